//! The pieces as rk8 sees them: y'' = g(y) in variables in which g is smooth (see [`super::rk8`]).

/// g(y) of one smooth piece in its own variables, with what landing and dense output need.
pub(super) trait Field: Copy {
    /// Whether σ is the time.
    const IS_TIME: bool;
    /// y for a distance d.
    fn y_at(self, distance: f64) -> f64;
    /// d for y.
    fn distance_at(self, y: f64) -> f64;
    /// The field of factor × g.
    fn scaled(self, factor: f64) -> Self;
    /// g(y).
    fn g(self, y: f64) -> f64;
    /// (g', g'') at y; g' ≤ 0.
    fn derivatives(self, y: f64) -> (f64, f64);
    /// Potential −∫ g.
    fn potential(self, y: f64) -> f64;
    /// The y > 0 of a given potential.
    fn at_potential(self, potential: f64) -> f64;
}

/// Straight: g = −(a + b y), y = d.
#[derive(Debug, Clone, Copy)]
pub(super) struct Straight {
    pub(super) a: f64,
    pub(super) b: f64,
}

impl Field for Straight {
    const IS_TIME: bool = true;
    #[inline(always)]
    fn y_at(self, distance: f64) -> f64 {
        distance
    }
    #[inline(always)]
    fn distance_at(self, y: f64) -> f64 {
        y
    }
    #[inline(always)]
    fn scaled(self, factor: f64) -> Self {
        Self { a: self.a * factor, b: self.b * factor }
    }
    #[inline(always)]
    fn g(self, y: f64) -> f64 {
        -(self.a + self.b * y)
    }
    #[inline(always)]
    fn derivatives(self, _: f64) -> (f64, f64) {
        (-self.b, 0.0)
    }
    #[inline(always)]
    fn potential(self, y: f64) -> f64 {
        y * (self.a + 0.5 * self.b * y)
    }
    #[inline(always)]
    fn at_potential(self, potential: f64) -> f64 {
        2.0 * potential / (self.a + (self.a * self.a + 2.0 * self.b * potential).sqrt())
    }
}

/// Power law in s = √d: g = −c s^p with c = 2 k, p = 2 n + 1.
#[derive(Debug, Clone, Copy)]
pub(super) struct Power {
    pub(super) c: f64,
    pub(super) p: f64,
}

/// The same for n = 3/2: g = −c s⁴.
#[derive(Debug, Clone, Copy)]
pub(super) struct Hertz {
    pub(super) c: f64,
}

macro_rules! square_root_variable {
    () => {
        const IS_TIME: bool = false;
        #[inline(always)]
        fn y_at(self, distance: f64) -> f64 {
            distance.sqrt()
        }
        #[inline(always)]
        fn distance_at(self, y: f64) -> f64 {
            y * y
        }
    };
}

impl Field for Hertz {
    square_root_variable!();
    #[inline(always)]
    fn scaled(self, factor: f64) -> Self {
        Self { c: self.c * factor }
    }
    #[inline(always)]
    fn g(self, y: f64) -> f64 {
        let square = y * y;
        -self.c * (square * square)
    }
    #[inline(always)]
    fn derivatives(self, y: f64) -> (f64, f64) {
        let square = y * y;
        (-4.0 * self.c * square * y, -12.0 * self.c * square)
    }
    #[inline(always)]
    fn potential(self, y: f64) -> f64 {
        let square = y * y;
        0.2 * self.c * square * square * y
    }
    #[inline(always)]
    fn at_potential(self, potential: f64) -> f64 {
        (5.0 * potential / self.c).powf(0.2)
    }
}

impl Field for Power {
    square_root_variable!();
    #[inline(always)]
    fn scaled(self, factor: f64) -> Self {
        Self { c: self.c * factor, ..self }
    }
    #[inline(always)]
    fn g(self, y: f64) -> f64 {
        -self.c * y.abs().powf(self.p)
    }
    #[inline(always)]
    fn derivatives(self, y: f64) -> (f64, f64) {
        let second = -self.c * self.p * (self.p - 1.0) * y.abs().powf(self.p - 2.0);
        (second * y / (self.p - 1.0), second)
    }
    #[inline(always)]
    fn potential(self, y: f64) -> f64 {
        self.c / (self.p + 1.0) * y.abs().powf(self.p + 1.0)
    }
    #[inline(always)]
    fn at_potential(self, potential: f64) -> f64 {
        ((self.p + 1.0) * potential / self.c).powf(1.0 / (self.p + 1.0))
    }
}
