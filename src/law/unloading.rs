//! Unloading and reloading, Xie et al. (2024), Eqs. 19-25, for any exponent n in (1, 2].

use crate::power::power;

/// The largest state a contact has seen: all the memory the law has.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Peak {
    /// x_m.
    pub indentation: f64,
    /// f_m.
    pub force: f64,
    /// ε_m, the part of x_m that is recovered on unloading: (E_s*/E*) δ_sm in units of L. Finite for a rigid sphere too.
    pub elastic_approach: f64,
}

impl Peak {
    /// Residual indentation x_r = x_m − ε_m (Eq. 23).
    #[must_use]
    pub fn residual(&self) -> f64 {
        self.indentation - self.elastic_approach
    }

    /// R_e/R = f_m²/ε_m³: unloading radius over sphere radius (Eq. 24). At least 1, and 1 without a dent.
    #[must_use]
    pub fn unloading_radius_ratio(&self) -> f64 {
        let per_approach = self.force / self.elastic_approach;
        per_approach * per_approach / self.elastic_approach
    }
}

/// The unloading branch that leaves a peak.
///
/// ```text
/// f = f_m ((x − x_r)/ε_m)^n,   x_r ≤ x ≤ x_m        (Eq. 19 for n = 3/2)
/// ```
///
/// Reloading runs back up the same curve. Meets the loading curve at (x_m, f_m), with a kink; zero at x_r.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unloading {
    /// Where it starts.
    pub peak: Peak,
    /// n in (1, 2].
    pub exponent: f64,
}

impl Unloading {
    /// Force at x; zero below the residual indentation (the surfaces have parted, there is no adhesion).
    #[must_use]
    pub fn force(&self, x: f64) -> f64 {
        let recovered = x - self.peak.residual();
        if recovered <= 0.0 {
            return 0.0;
        }
        self.peak.force * power(recovered / self.peak.elastic_approach, self.exponent)
    }

    /// The x at which the force is `force`, 0 to f_m: the inverse of [`Unloading::force`].
    #[must_use]
    pub fn indentation_at_force(&self, force: f64) -> f64 {
        self.peak.residual() + self.peak.elastic_approach * (force / self.peak.force).powf(1.0 / self.exponent)
    }

    /// df/dx where unloading begins, n f_m/ε_m.
    #[must_use]
    pub fn initial_slope(&self) -> f64 {
        self.exponent * self.peak.force / self.peak.elastic_approach
    }

    /// Elastic energy stored at x, f (x − x_r)/(n + 1); what unloading from the peak gives back is this at x_m.
    #[must_use]
    pub fn stored(&self, x: f64) -> f64 {
        self.force(x) * (x - self.peak.residual()) / (self.exponent + 1.0)
    }

    /// k of f = k d^n with d = x − x_r, the recovered approach still stored.
    #[must_use]
    pub fn stiffness(&self) -> f64 {
        self.peak.force / power(self.peak.elastic_approach, self.exponent)
    }
}
