//! Free flight of a sphere in still air: falls, rises, and their times.
//!
//! With the drag k v² of a constant coefficient C_d and the buoyancy of the sphere's volume V:
//!
//! ```text
//! k = ρ C_d π R²/(2 m),   g' = g (1 − ρ V/m)
//! fall   v = √(g'/k) √(1 − e^(−2 k h)),   t = acosh(e^(k h))/√(k g'),   h = ln cosh(√(k g') t)/k
//! rise   h = ln(1 + k v²/g')/(2 k),       t = atan(v √(k/g'))/√(k g')
//! ```
//!
//! The drag of a sphere depends on the Reynolds number (Schiller and Naumann 1933), and heights and times are integrals over
//! the speed:
//!
//! ```text
//! C_d = 24/Re (1 + 0.15 Re^0.687)  up to Re = 2 R ρ v/μ = 1000,   0.44 beyond
//! h = ∫ u du/(g' ∓ d(u)),   t = ∫ du/(g' ∓ d(u)),   d = ρ C_d π R² u²/(2 m)
//! ```
//!
//! Added mass, spin and wind are not modelled.

use std::f64::consts::PI;

use crate::contact::body::sphere_volume;
use crate::numerics::functions::{atan, exp, exp_m1, ln_1p, pow, sin_cos, tanh};
use crate::numerics::quadrature::tanh_sinh;
use crate::numerics::root::newton_bisection;

/// The air around a sphere, as it is given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Medium {
    /// ρ \[kg/m³\].
    pub density: f64,
    /// C_d; `None` for the drag of a sphere by its Reynolds number.
    pub drag: Option<f64>,
    /// μ \[Pa s\], which is used only with the drag by Reynolds number.
    pub viscosity: f64,
}

/// The drag of a sphere in flight.
#[derive(Debug, Clone, Copy, PartialEq)]
enum DragLaw {
    None,
    /// k \[1/m\].
    Constant(f64),
    /// The deceleration a v + b v^1.687 up to the speed `turn`, and c v² above it. Falls end at the speed `terminal`.
    Sphere {
        a: f64,
        b: f64,
        c: f64,
        turn: f64,
        terminal: f64,
    },
}

/// The free flight of a sphere under gravity. SI units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeFlight {
    /// g \[m/s²\].
    pub gravity: f64,
    /// g' \[m/s²\].
    effective_gravity: f64,
    drag: DragLaw,
}

/// e^−40 is below the last bit of 1.
const MAX_DEPTH: f64 = 40.0;

/// True if two values differ by no more than rounding.
fn is_converged(x: f64, next: f64) -> bool {
    (x - next).abs() <= 4.0 * f64::EPSILON * next.abs()
}

impl FreeFlight {
    /// Without air.
    pub fn in_vacuum(gravity: f64) -> Self {
        Self { gravity, effective_gravity: gravity, drag: DragLaw::None }
    }

    /// A sphere of this radius and mass in air. Its buoyancy must be less than its weight.
    pub fn in_air(gravity: f64, medium: &Medium, radius: f64, mass: f64) -> Self {
        let Medium { density, drag, viscosity } = *medium;
        let effective_gravity = gravity * (1.0 - Self::buoyancy_ratio(density, radius, mass));
        let per_drag = density * PI * radius * radius / (2.0 * mass);
        let drag = drag.map_or_else(
            || {
                // Re over v
                let rate = 2.0 * radius * density / viscosity;
                let (a, c) = (24.0 * per_drag / rate, 0.44 * per_drag);
                let (b, turn) = (3.6 * per_drag * pow(rate, -0.313), 1000.0 / rate);
                let of_low = |v: f64| a * v + b * pow(v, 1.687);
                let low = || {
                    let slope = |v: f64| -(a + 1.687 * b * pow(v, 0.687));
                    newton_bisection((0.0, turn), (effective_gravity / a).min(turn), is_converged, |v| {
                        (effective_gravity - of_low(v), slope(v))
                    })
                };
                let terminal =
                    if of_low(turn) >= effective_gravity { low() } else { (effective_gravity / c).sqrt().max(turn) };
                DragLaw::Sphere { a, b, c, turn, terminal }
            },
            |coefficient| DragLaw::Constant(coefficient * per_drag),
        );
        Self { gravity, effective_gravity, drag: if drag == DragLaw::Constant(0.0) { DragLaw::None } else { drag } }
    }

    /// ρ V/m: the buoyancy over the weight.
    pub fn buoyancy_ratio(density: f64, radius: f64, mass: f64) -> f64 {
        density * sphere_volume(radius) / mass
    }

    /// True if the flight is in air.
    pub fn has_air(&self) -> bool {
        self.drag != DragLaw::None || self.effective_gravity != self.gravity
    }

    /// g minus the buoyancy \[m/s²\].
    pub fn pull(&self) -> f64 {
        self.effective_gravity
    }

    /// Fraction of the energy m g h of a fall from this height \[m\] that the air absorbs, with the buoyancy.
    pub fn loss_fraction(&self, height: f64) -> f64 {
        let speed = self.landing_speed(height);
        1.0 - speed * speed / (2.0 * self.gravity * height)
    }

    /// The speed at which the drag balances the weight \[m/s\]; infinite without air.
    pub fn terminal_speed(&self) -> f64 {
        match self.drag {
            DragLaw::None => f64::INFINITY,
            DragLaw::Constant(k) => (self.effective_gravity / k).sqrt(),
            DragLaw::Sphere { terminal, .. } => terminal,
        }
    }

    /// Speed \[m/s\] after a fall from rest through `height` \[m\].
    pub fn landing_speed(&self, height: f64) -> f64 {
        match self.drag {
            DragLaw::None => (2.0 * self.effective_gravity * height).sqrt(),
            DragLaw::Constant(k) => (self.effective_gravity * -exp_m1(-2.0 * k * height) / k).sqrt(),
            DragLaw::Sphere { terminal, .. } => terminal * -exp_m1(-self.log_deficit_after_height(height)),
        }
    }

    /// The time \[s\] of a fall from rest through `height` \[m\].
    pub fn fall_time(&self, height: f64) -> f64 {
        match self.drag {
            DragLaw::None => self.landing_speed(height) / self.effective_gravity,
            // acosh(e^x) = x + ln(1 + √(1 − e^(−2x)))
            DragLaw::Constant(k) => {
                let x = k * height;
                (x + ln_1p((-exp_m1(-2.0 * x)).sqrt())) / (k * self.effective_gravity).sqrt()
            }
            DragLaw::Sphere { .. } => self.fall_integral(self.log_deficit_after_height(height), |_| 1.0),
        }
    }

    /// The height \[m\] of a fall from rest that lasts this time \[s\].
    fn fall_height(&self, time: f64) -> f64 {
        match self.drag {
            DragLaw::None => 0.5 * self.effective_gravity * time * time,
            DragLaw::Constant(k) => {
                let x = (k * self.effective_gravity).sqrt() * time;
                let tanh = tanh(x);
                // ln cosh x: at large x the first form loses digits, and at small x the second form
                (if x < 1.0 { -0.5 * ln_1p(-tanh * tanh) } else { x - ln_1p(tanh) }) / k
            }
            DragLaw::Sphere { .. } => self.fall_integral(self.log_deficit_after_time(time), |v| v),
        }
    }

    /// The height \[m\] from which a fall reaches a speed \[m/s\]; infinite from the terminal speed on.
    pub fn drop_height(&self, speed: f64) -> f64 {
        match self.drag {
            _ if speed >= self.terminal_speed() => f64::INFINITY,
            DragLaw::None => 0.5 * speed * speed / self.effective_gravity,
            DragLaw::Constant(k) => -ln_1p(-k * speed * speed / self.effective_gravity) / (2.0 * k),
            DragLaw::Sphere { terminal, .. } => self.fall_integral(-ln_1p(-speed / terminal), |v| v),
        }
    }

    /// The height \[m\] to which a sphere rises that starts with this speed \[m/s\].
    pub fn rise_height(&self, speed: f64) -> f64 {
        match self.drag {
            DragLaw::None => 0.5 * speed * speed / self.effective_gravity,
            DragLaw::Constant(k) => ln_1p(k * speed * speed / self.effective_gravity) / (2.0 * k),
            DragLaw::Sphere { .. } => self.rise_integral(speed, |v| v),
        }
    }

    /// The time \[s\] of a rise that starts with this speed \[m/s\].
    pub fn rise_time(&self, speed: f64) -> f64 {
        match self.drag {
            DragLaw::None => speed / self.effective_gravity,
            DragLaw::Constant(k) => {
                atan(speed * (k / self.effective_gravity).sqrt()) / (k * self.effective_gravity).sqrt()
            }
            DragLaw::Sphere { .. } => self.rise_integral(speed, |_| 1.0),
        }
    }

    /// The take-off speed \[m/s\] of a sphere that returns to the same height after this time \[s\].
    pub fn take_off_speed(&self, time: f64) -> f64 {
        let whole = |v: f64| self.rise_time(v) + self.fall_time(self.rise_height(v));
        let (first, mut high) = (0.5 * self.effective_gravity * time, self.effective_gravity * time);
        while whole(high) < time && high.is_finite() {
            high *= 2.0;
        }
        let rate = |v: f64| {
            (1.0 + v / self.landing_speed(self.rise_height(v))) / (self.effective_gravity + self.deceleration(v))
        };
        newton_bisection((0.0, high), first, is_converged, |v| (time - whole(v), -rate(v)))
    }

    /// The upward speed \[m/s\] at a time \[s\] after a take-off with `speed`; negative during the fall.
    pub fn speed_after(&self, speed: f64, time: f64) -> f64 {
        let to_top = self.rise_time(speed) - time;
        match self.drag {
            DragLaw::None => speed - self.effective_gravity * time,
            DragLaw::Constant(k) => {
                let (angle, terminal) = ((k * self.effective_gravity).sqrt() * to_top, self.terminal_speed());
                let (sin, cos) = sin_cos(angle.max(0.0));
                terminal * if angle > 0.0 { sin / cos } else { tanh(angle) }
            }
            DragLaw::Sphere { .. } if to_top >= 0.0 => {
                let slope = |v: f64| 1.0 / -(self.effective_gravity + self.deceleration(v));
                newton_bisection((0.0, speed), self.effective_gravity * to_top, is_converged, |v| {
                    (to_top - self.rise_integral(v, |_| 1.0), slope(v))
                })
            }
            DragLaw::Sphere { terminal, .. } => terminal * exp_m1(-self.log_deficit_after_time(-to_top)),
        }
    }

    /// The height \[m\] above the take-off at a time \[s\] after a take-off with `speed`. The height of the fall follows from
    /// its time: at the terminal speed the same speed belongs to all heights.
    pub fn height_after(&self, speed: f64, time: f64) -> f64 {
        let to_top = self.rise_time(speed) - time;
        let below_top =
            if to_top >= 0.0 { self.rise_height(self.speed_after(speed, time)) } else { self.fall_height(-to_top) };
        self.rise_height(speed) - below_top
    }

    /// d \[m/s²\] at a speed.
    fn deceleration(&self, v: f64) -> f64 {
        match self.drag {
            DragLaw::None => 0.0,
            DragLaw::Constant(k) => k * v * v,
            DragLaw::Sphere { a, b, turn, .. } if v <= turn => a * v + b * pow(v, 1.687),
            DragLaw::Sphere { c, .. } => c * v * v,
        }
    }

    /// ∫ part du/(g' + d) from rest to a speed.
    fn rise_integral(&self, speed: f64, part: fn(f64) -> f64) -> f64 {
        let DragLaw::Sphere { turn, .. } = self.drag else { return f64::NAN };
        let between = |from: f64, to: f64| {
            tanh_sinh(to - from, |below, _| {
                part(from + below) / (self.effective_gravity + self.deceleration(from + below))
            })
        };
        let middle = turn.min(speed);
        between(0.0, middle) + between(middle, speed)
    }

    /// During the fall, at the speed v_t (1 − e^(−depth)): this speed, and dt/d(depth) = v_t e^(−depth)/(g' − d).
    fn fall_state(&self, depth: f64) -> (f64, f64) {
        let DragLaw::Sphere { a, b, c, turn, terminal } = self.drag else { return (f64::NAN, f64::NAN) };
        let (v, short) = (terminal * -exp_m1(-depth), exp(-depth));
        // g' − d(v) without the difference of two nearly equal numbers
        let net = if terminal <= turn {
            a * terminal * short - b * pow(terminal, 1.687) * exp_m1(1.687 * ln_1p(-short))
        } else if v > turn {
            c * terminal * terminal * short * (2.0 - short)
        } else {
            self.effective_gravity - self.deceleration(v)
        };
        (v, terminal * short / net)
    }

    /// ∫ part du/(g' − d) from rest to the speed v_t (1 − e^(−depth)).
    fn fall_integral(&self, depth: f64, part: fn(f64) -> f64) -> f64 {
        let DragLaw::Sphere { turn, terminal, .. } = self.drag else { return f64::NAN };
        let between = |from: f64, to: f64| {
            tanh_sinh(to - from, |below, _| {
                let (v, rate) = self.fall_state(from + below);
                part(v) * rate
            })
        };
        // at a larger depth the speed is the terminal speed to the last bit
        let last = depth.min(MAX_DEPTH);
        let middle = if turn < terminal { (-ln_1p(-turn / terminal)).clamp(0.0, last) } else { 0.0 };
        let (v, rate) = self.fall_state(last);
        between(0.0, middle) + between(middle, last) + part(v) * rate * (depth - last)
    }

    /// −ln(1 − v/v_t) after a fall from rest through `height` \[m\].
    fn log_deficit_after_height(&self, height: f64) -> f64 {
        self.log_speed_deficit(height, |v| v, (2.0 * self.effective_gravity * height).sqrt())
    }

    /// −ln(1 − v/v_t) after a fall from rest of this time \[s\].
    fn log_deficit_after_time(&self, time: f64) -> f64 {
        self.log_speed_deficit(time, |_| 1.0, self.effective_gravity * time)
    }

    /// −ln(1 − v/v_t) of the speed v up to which ∫ part du/(g' − d) from rest has this value. The search begins at the speed
    /// without drag.
    fn log_speed_deficit(&self, value: f64, part: fn(f64) -> f64, speed_without_drag: f64) -> f64 {
        let terminal = self.terminal_speed();
        let first = -ln_1p(-(speed_without_drag / terminal).min(0.999));
        // at the terminal speed the integral grows by part v_t/2g' to part v_t/g' a unit
        let most = MAX_DEPTH + 2.0 * value * self.effective_gravity / (terminal * part(terminal));
        newton_bisection((0.0, most), first, is_converged, |depth| {
            let (v, rate) = self.fall_state(depth.min(MAX_DEPTH));
            (value - self.fall_integral(depth, part), -part(v) * rate)
        })
    }
}
