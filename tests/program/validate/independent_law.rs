//! A second implementation of the law, from its equations and its table of coefficients, and the curves it was fitted to.

pub const BUILT_IN: &str = include_str!("../../../src/contact/law/plm/coefficients.toml");

/// A second implementation of the PLM: plain sums, bisection instead of formulas for roots, the trapezoidal rule
/// instead of closed forms.
pub struct IndependentLaw {
    pub table: toml::Table,
    /// Knots of the force, and the two parts of its slopes.
    force: [Vec<f64>; 3],
    pub kappa: f64,
    pub a_y: f64,
    /// Points of the force in deep dents, from δ/R = 0.035 on.
    deep: Vec<[f64; 2]>,
}

pub fn list(table: &toml::Table, of: &str, key: &str) -> Vec<f64> {
    table[of][key].as_array().unwrap().iter().map(|value| value.as_float().unwrap()).collect()
}

impl IndependentLaw {
    /// The law of the bodies in the comment lines of a loading curve.
    pub fn for_curve(curve: &str) -> Self {
        let value = |key: &str| -> f64 {
            let line = curve.lines().find_map(|line| line.strip_prefix(&format!("# {key} = "))).unwrap();
            line.split(' ').next().unwrap().parse().unwrap()
        };
        let [sphere, half_space] = ["sphere", "half_space"].map(|body| value(&format!("{body}.youngs_modulus")));
        Self::new(sphere, half_space, value("half_space.yield_strength"))
    }

    /// The law of these moduli \[GPa\] and this strength \[MPa\].
    pub fn new(sphere: f64, half_space: f64, strength: f64) -> Self {
        let (e_s, e_h) = (sphere / 0.91, half_space / 0.91);
        let e_star = e_s * e_h / (e_s + e_h);
        // C_ν = 1.61316 at ν = 0.3
        let a_y = std::f64::consts::PI * 1.613_160_7 * 1e-3 * strength / (2.0 * e_star);
        let table = toml::from_str(BUILT_IN).unwrap();
        let force = ["from", "slope", "slope_kappa_squared"].map(|key| list(&table, "force", key));
        let shallow = Self { table, force, kappa: e_star / e_s, a_y, deep: Vec::new() };
        Self { deep: shallow.deep_points(), ..shallow }
    }

    fn one(&self, key: &str) -> f64 {
        self.table["elastic_approach"][key].as_float().unwrap()
    }

    fn of_depth(&self, key: &str) -> f64 {
        self.table["depth"][key].as_float().unwrap()
    }

    /// x at which δ/R begins to matter, and from which it does no more.
    fn depths(&self) -> [f64; 2] {
        ["from", "to"].map(|key| self.of_depth(key) / (self.a_y * self.a_y))
    }

    /// y at x.
    fn depth(&self, x: f64) -> f64 {
        let [from, to] = self.depths();
        let x = x.min(to);
        let plastic_from = 1.0 + self.one("plastic_from_rho") * (1.0 - self.kappa);
        let share = 1.0 - plastic_from * self.shallow_approach(x) / self.shallow_force(x);
        if x <= from { 0.0 } else { (x * self.a_y * self.a_y - self.of_depth("from")) * share.max(0.0) }
    }

    /// The knots and the ends of the range, with points at most 10 % apart between them.
    fn deep_points(&self) -> Vec<[f64; 2]> {
        let [from, to] = self.depths();
        let knots = self.force[0].iter().copied();
        let ends: Vec<f64> =
            [from].into_iter().chain(knots.clone().filter(|x| (from..to).contains(x))).chain([to]).collect();
        let mut points = vec![[from, self.shallow_force(from)]];
        let mut add = |x: f64| points.push([x, self.shallow_force(x) / (1.0 + self.of_depth("force") * self.depth(x))]);
        for pair in ends.windows(2) {
            let ratio = pair[1] / pair[0];
            let count = (1..100).find(|count| ratio.powf(1.0 / f64::from(*count)) <= 1.1).unwrap();
            (1..=count).for_each(|i| add(pair[0] * ratio.powf(f64::from(i) / f64::from(count))));
        }
        knots.filter(|x| *x > to).for_each(add);
        points
    }

    pub fn force(&self, x: f64) -> f64 {
        match self.deep.partition_point(|[start, _]| *start <= x) {
            0 => self.shallow_force(x),
            after if after < self.deep.len() => {
                let [[x0, f0], [x1, f1]] = [self.deep[after - 1], self.deep[after]];
                f0 + (f1 - f0) * (x - x0) / (x1 - x0)
            }
            after => {
                let ([from, slope, extra], [start, force]) = (&self.force, self.deep[after - 1]);
                let last = from.len() - 1;
                let slope = slope[last] + self.kappa.powi(2) * extra[last];
                force + slope / (1.0 + self.of_depth("force") * self.depth(start)) * (x - start)
            }
        }
    }

    /// The force without the correction for deep dents.
    pub fn shallow_force(&self, x: f64) -> f64 {
        let [from, slope, extra] = &self.force;
        let mut force = x.min(from[0]).powf(1.5);
        for i in 0..from.len() {
            let end = from.get(i + 1).copied().unwrap_or(f64::INFINITY);
            force += (slope[i] + self.kappa.powi(2) * extra[i]) * (x.min(end) - from[i]).max(0.0);
        }
        force
    }

    /// ε at A on the polyline, summed in small steps.
    fn line(&self, a: f64) -> f64 {
        let k2 = self.kappa.powi(2);
        let first =
            (self.one("first_slope") + self.one("first_slope_kappa_squared") * k2).min(self.one("first_slope_limit"));
        let plastic = self.one("plastic_slope") + self.one("plastic_slope_kappa_squared") * k2;
        let plastic_from = 1.0 + self.one("plastic_from_rho") * (1.0 - self.kappa);
        let [from, factor] = ["geometry_from", "geometry_factor"].map(|key| list(&self.table, "elastic_approach", key));
        let slope = |a: f64| {
            let base = if a < plastic_from { first } else { plastic };
            from.iter()
                .zip(&factor)
                .filter(|(from, _)| a * self.a_y >= **from)
                .fold(base, |slope, (_, factor)| slope * factor)
        };
        let knots = from.iter().map(|from| from / self.a_y).chain([plastic_from]);
        let mut places: Vec<f64> = knots.filter(|knot| *knot > 1.0 && *knot < a).chain([1.0, a]).collect();
        places.sort_by(f64::total_cmp);
        1.0 + places.windows(2).map(|pair| slope(0.5 * (pair[0] + pair[1])) * (pair[1] - pair[0])).sum::<f64>()
    }

    pub fn approach(&self, x: f64) -> f64 {
        let recovery = self.of_depth("recovery") * (self.of_depth("recovery_kappa") - self.kappa);
        (self.shallow_approach(x) * (1.0 + recovery * self.depth(x))).min(x)
    }

    /// ε without the correction for deep dents.
    pub fn shallow_approach(&self, x: f64) -> f64 {
        let force = self.shallow_force(x);
        // ε = line(f/ε): the left side rises in ε, the right side falls
        let (mut low, mut high) = (0.0, x);
        if x <= 1.0 || self.line(force / x) >= x {
            return x;
        }
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            if middle < self.line(force / middle) { low = middle } else { high = middle }
        }
        low
    }

    pub fn work(&self, x: f64) -> f64 {
        let n = 20_000;
        let step = x / f64::from(n);
        step * ((1..n).map(|i| self.force(f64::from(i) * step)).sum::<f64>() + 0.5 * self.force(x))
    }

    /// Λ(A).
    fn pressure_shape(a: f64) -> f64 {
        match a {
            a if a < 1.5 => 1.0,
            a if a < 4.0 => 1.0 + 0.15 * (a - 1.5) / 2.5,
            a if a < 8.0 => 1.15 + 0.04 * (a - 4.0) / 4.0,
            _ => 1.19,
        }
    }

    pub fn restitution(&self, x: f64, is_paper: bool) -> f64 {
        let (force, approach) = (self.force(x), self.approach(x));
        let lambda = Self::pressure_shape(self.shallow_force(x) / self.shallow_approach(x));
        let n = if is_paper { 1.5 } else { 1.5 - 0.807_46 * (lambda - 1.0) };
        (force * approach / (n + 1.0) / self.work(x)).sqrt()
    }

    /// a/R, narrower than â/Λ from â/R = 0.105 on.
    pub fn contact_radius(&self, x: f64) -> f64 {
        let a = self.shallow_force(x) / self.shallow_approach(x);
        let geometry = 1.0 + (0.25 + 0.145 * self.kappa.powi(2)) * (a * self.a_y - 0.105).max(0.0);
        a * self.a_y / Self::pressure_shape(a) / geometry
    }
}

pub const CURVES: [&str; 5] = [
    include_str!("../../../src/reference/fe_loading_case1.csv"),
    include_str!("../../../src/reference/fe_loading_case2.csv"),
    include_str!("../../../src/reference/fe_loading_case3.csv"),
    include_str!("../../../src/reference/fe_loading_case4.csv"),
    include_str!("../../../src/reference/fe_loading_case5.csv"),
];
