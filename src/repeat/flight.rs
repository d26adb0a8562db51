//! Free flight under gravity, in closed form. Heights are those of the sphere's lowest point over the original surface,
//! −δ while in contact.

/// From leaving a place until touching another one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flight {
    /// When it begins \[s\].
    pub begin: f64,
    /// How long it lasts \[s\].
    pub duration: f64,
    /// Where it begins \[m\].
    pub height: f64,
    /// Speed upwards as it begins \[m/s\].
    pub speed: f64,
    /// Speed downwards at the next touch \[m/s\].
    pub landing_speed: f64,
    /// g \[m/s²\].
    pub gravity: f64,
}

impl Flight {
    /// The fall from rest at `height` to the surface.
    #[must_use]
    pub fn fall(gravity: f64, height: f64) -> Self {
        let landing_speed = crate::impact::drop_speed(gravity, height);
        Self { begin: 0.0, duration: landing_speed / gravity, height, speed: 0.0, landing_speed, gravity }
    }

    /// Upwards at `speed` from the depth `from` until the next touch at the depth `to`, both below the original surface;
    /// `None` if it does not rise that far.
    ///
    /// ```text
    /// u² = v² − 2 g (from − to),   duration = (v + u)/g
    /// ```
    #[must_use]
    pub fn between(gravity: f64, begin: f64, from: f64, speed: f64, to: f64) -> Option<Self> {
        let square = speed * speed - 2.0 * gravity * (from - to);
        let reaches = square > 0.0 || (from == to && speed > 0.0);
        reaches.then(|| {
            // there and back to the same height: the same speed, to the last bit
            let landing_speed = if from == to { speed } else { square.sqrt() };
            let duration = (speed + landing_speed) / gravity;
            Self { begin, duration, height: -from, speed, landing_speed, gravity }
        })
    }

    /// Height over the original surface \[m\] at a time since the beginning \[s\].
    #[must_use]
    pub fn height_at(&self, time: f64) -> f64 {
        self.height + time * (self.speed - 0.5 * self.gravity * time)
    }

    /// Speed downwards \[m/s\], as δ' is.
    #[must_use]
    pub fn speed_at(&self, time: f64) -> f64 {
        self.gravity * time - self.speed
    }

    /// The highest point \[m\].
    #[must_use]
    pub fn top(&self) -> f64 {
        self.height + 0.5 * self.speed * self.speed / self.gravity
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fall_takes_the_time_of_galilei() {
        // t = √(2 h/g): 2 s from 19.62 m at 9.81 m/s²
        let fall = Flight::fall(9.81, 19.62);
        approx::assert_relative_eq!(fall.duration, 2.0, max_relative = 1e-15);
        approx::assert_relative_eq!(fall.landing_speed, 19.62, max_relative = 1e-15);
        approx::assert_abs_diff_eq!(fall.height_at(2.0), 0.0, epsilon = 1e-14);
        approx::assert_relative_eq!(fall.speed_at(2.0), 19.62, max_relative = 1e-15);
    }

    #[test]
    fn a_flight_out_of_a_dent_loses_its_depth() {
        // from 1 m below at 6 m/s under 10 m/s²: 0.8 m above the surface, back on it at 4 m/s after 1 s
        let flight = Flight::between(10.0, 3.0, 1.0, 6.0, 0.0).unwrap();
        assert_eq!((flight.landing_speed, flight.duration, flight.top()), (4.0, 1.0, 0.8));
        assert_eq!(flight.height_at(1.0), 0.0);
        // just to the rim is not onto fresh surface; on the same spot every speed comes back
        assert_eq!(Flight::between(10.0, 0.0, 1.0, 20_f64.sqrt() * (1.0 - 1e-15), 0.0), None);
        assert_eq!(Flight::between(10.0, 0.0, 1.0, 0.1, 1.0).unwrap().landing_speed, 0.1);
    }
}
