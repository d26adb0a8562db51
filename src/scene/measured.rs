//! The quantities that can be measured, the keys of `[calibrate]` that are named by them, and how each follows from a computed
//! impact.

use super::Scene;
use super::key::Form::Number;
use super::quantity::{DEVIATION, FORCE, LEEB, LENGTH, MODEL_ERROR, Quantity, RESTITUTION, SPEED, TIME};
use super::table::tables;
use crate::impact::Essentials;
use crate::units::names::named;

/// The quantities of an impact and those of an indentation: name, meaning, quantity, and quantity of its standard deviation.
macro_rules! measured {
    (
        impact { $($variant:ident $name:ident $about:literal $quantity:ident $deviation:ident;)+ }
        indentation { $($curve:ident $of_curve:ident $about_curve:literal $quantity_of_curve:ident;)+ }
    ) => {
        named! {
            /// A measured quantity.
            #[derive(PartialOrd, Ord)]
            pub enum Measured {
                $(#[doc = $about] $variant = stringify!($name),)+
                $(#[doc = $about_curve] $curve = stringify!($of_curve),)+
            }
        }

        impl Measured {
            /// Dimension and allowed range.
            pub fn quantity(self) -> &'static Quantity {
                match self {
                    $(Self::$variant => &$quantity,)+
                    $(Self::$curve => &$quantity_of_curve,)+
                }
            }
        }

        tables! {
            /// `[calibrate.noise]`; without any number they are to be estimated.
            pub struct Deviations {
                /// Error of the law as a share of each value, added in quadrature, independent from value to value.
                model: Option<f64> as Number(&MODEL_ERROR) => "0",
                $(/// Standard deviation of this measurement, where the data have no column for it.
                $name: Option<f64> as Number(&$deviation),)+
                $(/// Standard deviation of this measurement, where the data have no column for it.
                $of_curve: Option<f64> as Number(&$quantity_of_curve),)+
            }

            /// `[calibrate.measured]`
            pub struct MeasuredInput {
                $(#[doc = $about] #[doc = ", measured in the impact of the scenario: in place of data."]
                $name: Option<f64> as Number(&$quantity),)+
            }
        }
    };
}

measured! {
    impact {
        Restitution restitution "Rebound speed over impact speed" RESTITUTION DEVIATION;
        ReboundSpeed rebound_speed "Speed of the rebound" SPEED SPEED;
        ReboundHeight rebound_height "Height of the rebound" LENGTH LENGTH;
        Leeb leeb "Leeb hardness: 1000 times the restitution" LEEB DEVIATION;
        DentDiameter dent_diameter "Diameter of the dent's rim" LENGTH LENGTH;
        DentDepth dent_depth "Depth of the dent" LENGTH LENGTH;
        ContactTime contact_time "Time in contact" TIME TIME;
        PeakForce peak_force "Largest force" FORCE FORCE;
    }
    indentation {
        Force force "Force of an indentation curve" FORCE;
    }
}

impl Measured {
    /// Whether the quantity depends only on the restitution and known keys.
    pub fn is_of_restitution(self) -> bool {
        self <= Self::Leeb
    }

    /// The value in an impact of a scene; `None` if the impact has no such value.
    pub fn predict(self, row: &Essentials, scene: &Scene) -> Option<f64> {
        match self {
            Self::DentDiameter => Some(if row.has_dent() { 2.0 * row.peak_contact_radius } else { 0.0 }),
            Self::DentDepth => Some(row.residual_indentation),
            Self::ContactTime => Some(row.contact_time),
            Self::PeakForce => Some(row.peak_force),
            // what is measured is less by the energy of elastic waves, if the half-space has a density
            _ => self.of_rebound(row.measured_restitution(), scene),
        }
    }

    /// The value after a rebound with this restitution; `None` if the quantity does not follow from that.
    pub fn of_rebound(self, restitution: f64, scene: &Scene) -> Option<f64> {
        let speed = restitution * scene.speed;
        match self {
            Self::Restitution => Some(restitution),
            Self::ReboundSpeed => Some(speed),
            Self::ReboundHeight => Some(0.5 * speed * speed / scene.input.falling_gravity()),
            Self::Leeb => Some(1000.0 * restitution),
            _ => None,
        }
    }
}
