//! The quantities that can be measured, and how each follows from a computed impact.

use crate::impact::Essentials;
use crate::scene::Scene;
use crate::scene::quantity::{FORCE, LEEB, LENGTH, Quantity, RESTITUTION, SPEED, TIME};

macro_rules! measured {
    ($($(#[$about:meta])+ $variant:ident = $name:literal, $quantity:ident;)+) => {
        /// A measured quantity.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
        pub enum Measured {
            $($(#[$about])+ $variant,)+
        }

        impl Measured {
            /// All measured quantities.
            pub const ALL: [Self; [$($name),+].len()] = [$(Self::$variant),+];

            /// The name, without the unit.
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $name,)+
                }
            }

            /// Dimension and allowed range.
            pub fn quantity(self) -> &'static Quantity {
                match self {
                    $(Self::$variant => &$quantity,)+
                }
            }
        }
    };
}

measured! {
    /// Rebound speed over impact speed.
    Restitution = "restitution", RESTITUTION;
    /// Speed of the rebound.
    ReboundSpeed = "rebound_speed", SPEED;
    /// Height of the rebound under gravity.
    ReboundHeight = "rebound_height", LENGTH;
    /// Leeb hardness: 1000 times the restitution.
    Leeb = "leeb", LEEB;
    /// Diameter of the dent's rim.
    DentDiameter = "dent_diameter", LENGTH;
    /// Depth of the dent.
    DentDepth = "dent_depth", LENGTH;
    /// Time in contact.
    ContactTime = "contact_time", TIME;
    /// Largest force.
    PeakForce = "peak_force", FORCE;
    /// Force of an indentation curve. All others are quantities of an impact.
    Force = "force", FORCE;
}

impl Measured {
    /// The quantity of this name.
    pub fn find(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|measured| measured.name() == name)
    }

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
            _ => self.of_rebound(row.restitution_with_waves().unwrap_or(row.restitution), scene),
        }
    }

    /// The value after a rebound with this restitution; `None` if the quantity does not follow from that.
    pub fn of_rebound(self, restitution: f64, scene: &Scene) -> Option<f64> {
        let speed = restitution * scene.speed;
        match self {
            Self::Restitution => Some(restitution),
            Self::ReboundSpeed => Some(speed),
            Self::ReboundHeight => Some(0.5 * speed * speed / scene.forces.gravity?),
            Self::Leeb => Some(1000.0 * restitution),
            _ => None,
        }
    }
}
