//! The list of laws, combinations of two of them, and the laws that are not public. Each law has a file of its own.
//!
//! F/F_Y, δ_r/δ_m and e of every law at six depths of case 3 of Xie et al. (2024) agree with an independent program to
//! all its digits (3 to 4), with one exception: that program took a² = 4c²Rδ for the dents of `mesarovic_johnson`, which
//! is half the law's own pressure under the same force. Here it is a² = 2c²Rδ. Thornton's closed form of e(v) is met to
//! 1e-12, and so are its limits, e = 1.185 (V_y/V)^¼ and the slope −1/4; Johnson's closed form is met to 1e-13.

pub mod brake;
pub mod hertz;
pub mod jackson_green;
pub mod johnson;
pub mod kogut_etsion;
pub mod kogut_komvopoulos;
pub mod ma_liu;
pub mod mesarovic_johnson;
pub mod stronge;
pub mod thornton;
pub mod walton_braun;
pub mod yigit_christoforou;

use super::contact_law::{About, Bodies, ContactLaw};
use super::plm;
use super::published::{Loading, RecoveryRule};
use crate::strength::flow::FlowCurve;

macro_rules! laws {
    ($($file:ident::$law:ident),* $(,)?) => {
        /// A law with its parameters.
        #[derive(Debug, Clone, PartialEq)]
        pub enum LawChoice {
            $(#[doc = concat!("See [`", stringify!($file), "::", stringify!($law), "`].")] $law($file::$law),)*
            /// Two halves.
            Combined(Combined),
        }

        impl LawChoice {
            /// Every law but combinations, with its default parameters.
            pub fn all() -> Vec<Self> {
                vec![$(Self::$law($file::$law::default())),*]
            }

            /// The law itself.
            pub fn get(&self) -> &dyn ContactLaw {
                match self {
                    $(Self::$law(law) => law,)*
                    Self::Combined(law) => law,
                }
            }
        }
    };
}

laws!(
    plm::Plm,
    hertz::Hertz,
    thornton::Thornton,
    stronge::Stronge,
    jackson_green::JacksonGreen,
    kogut_etsion::KogutEtsion,
    kogut_komvopoulos::KogutKomvopoulos,
    yigit_christoforou::YigitChristoforou,
    ma_liu::MaLiu,
    brake::Brake,
    mesarovic_johnson::MesarovicJohnson,
    walton_braun::WaltonBraun,
    johnson::Johnson,
);

impl Default for LawChoice {
    fn default() -> Self {
        Self::Plm(plm::Plm::default())
    }
}

impl LawChoice {
    /// The law of that name with its default parameters: "thornton", or "jackson_green + brake" for the loading of one with
    /// the unloading of the other.
    pub fn from_name(name: &str) -> Option<Self> {
        if let Some((loading, unloading)) = name.split_once('+') {
            let half = |name: &str| Self::from_name(name.trim()).map(Box::new);
            let (loading, unloading) = (half(loading)?, half(unloading)?);
            return loading.has_loading().then_some(Self::Combined(Combined { loading, unloading }));
        }
        Self::all().into_iter().find(|law| law.about().name == name)
    }

    /// Names of all laws.
    pub fn names() -> Vec<&'static str> {
        Self::all().iter().map(|law| law.about().name).collect()
    }

    /// How the half-space hardens, if it does.
    pub fn flow(&self) -> Option<&FlowCurve> {
        match self {
            Self::Plm(plm) => plm.flow.as_ref(),
            _ => None,
        }
    }

    /// Where it comes from.
    pub fn about(&self) -> &'static About {
        self.get().about()
    }

    /// Whether it says how a contact loads. All laws unload, if need be by the paper's law.
    pub fn has_loading(&self) -> bool {
        self.about().loading != "none"
    }

    /// Whether its unloading is its own and not that of another law.
    pub(crate) fn has_own_unloading(&self) -> bool {
        !matches!(self, Self::KogutKomvopoulos(_))
    }

    /// Its name in tables: of a combination "loading + unloading".
    pub fn name(&self) -> String {
        match self {
            Self::Combined(Combined { loading, unloading }) => format!("{} + {}", loading.name(), unloading.name()),
            law => law.about().name.to_owned(),
        }
    }

    /// Where it was published.
    pub fn source(&self) -> String {
        match self {
            Self::Combined(Combined { loading, unloading }) => {
                format!("loading: {}; unloading: {}", loading.source(), unloading.source())
            }
            law => law.about().source.to_owned(),
        }
    }
}

/// The loading of one law with the unloading of another.
///
/// The unloading is given the force, indentation and contact radius of the peak as the loading has them.
#[derive(Debug, Clone, PartialEq)]
pub struct Combined {
    /// How it loads.
    pub loading: Box<LawChoice>,
    /// How it unloads.
    pub unloading: Box<LawChoice>,
}

impl ContactLaw for Combined {
    fn about(&self) -> &'static About {
        About::of("combined")
    }

    fn loading(&self, bodies: &Bodies) -> Option<Loading> {
        self.loading.get().loading(bodies)
    }

    fn recovery(&self, bodies: &Bodies) -> RecoveryRule {
        self.unloading.get().recovery(bodies)
    }
}

/// A law that is not here, and why.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct NotPublic {
    /// Authors and year.
    pub title: &'static str,
    /// Why.
    pub reason: &'static str,
}

/// The laws that Xie et al. (2024) name and that could not be implemented.
pub const NOT_PUBLIC: &[NotPublic] = &[
    NotPublic {
        title: "PLM's own unloading (Weng et al. 2021)",
        reason: "Tribol. Int. 162, 107114: no public text states it; the loading is fitted anew, the unloading is the paper's",
    },
    NotPublic {
        title: "Kogut and Komvopoulos 2004, unloading",
        reason: "a fit of the residual indentation whose constants are in no public text; its loading is here",
    },
    NotPublic {
        title: "MYC (Majeed, Yigit, Christoforou 2012)",
        reason: "no public text; its ancestor of 1994 is here as yigit_christoforou",
    },
    NotPublic {
        title: "CYM (Christoforou, Yigit, Majeed 2013)",
        reason: "no public text; its ancestor of 1994 is here as yigit_christoforou",
    },
    NotPublic { title: "Rathbone et al. 2015", reason: "equations in no public text" },
    NotPublic { title: "Du and Wang 2009", reason: "equations in no public text" },
    NotPublic { title: "Zhao et al. 2015", reason: "equations in no public text (hardening, stick contact)" },
    NotPublic {
        title: "Dong et al. 2018",
        reason: "the fitted factor f_u of its unloading is in no public text; stronge takes f_u as a key",
    },
    NotPublic { title: "Chen et al. (power-law hardening)", reason: "the fitted factors are in no public text" },
    NotPublic {
        title: "Brake 2012 and 2015, loading",
        reason: "coefficients of the mixed regime could not be verified; the unloading is here",
    },
];
