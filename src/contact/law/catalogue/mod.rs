//! The list of laws, combinations of two laws, and the laws that are not public. Each law has its own file, and `facts.csv` has
//! its source.
//!
//! F/F_Y, δ_r/δ_m and e of every law at six depths of case 3 of Xie et al. (2024) agree with an independent program to all its
//! digits (3 to 4). The dents of `mesarovic_johnson` agree with the contact radius a² = 2c²Rδ. Thornton's closed form of e(v)
//! agrees to 1e-12, with its limits e = 1.185 (V_y/V)^¼ and the slope −1/4; Johnson's closed form agrees to 1e-13.

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

use super::Law;
use super::contact_law::{ContactLaw, LawInfo, YieldingPair};
pub use super::plm;
use super::published::{LawError, LawParts};
use crate::contact::strength::flow_curve::FlowCurve;

macro_rules! law_enum {
    ($($file:ident::$law:ident),* $(,)?) => {
        /// A law with its parameters. Its file has its name.
        #[derive(Debug, Clone, PartialEq)]
        pub enum LawChoice {
            $(#[doc = concat!("See [`", stringify!($file), "::", stringify!($law), "`].")] $law($file::$law),)*
            Combined(Combined),
        }

        impl LawChoice {
            /// Every law but combinations, with its default parameters.
            pub fn all() -> Vec<Self> {
                vec![$(Self::$law($file::$law::default())),*]
            }

            pub fn info(&self) -> &'static LawInfo {
                match self {
                    $(Self::$law(_) => LawInfo::for_law(stringify!($file)),)*
                    Self::Combined(_) => LawInfo::for_law("combined"),
                }
            }

            pub fn as_contact_law(&self) -> &dyn ContactLaw {
                match self {
                    $(Self::$law(law) => law,)*
                    Self::Combined(law) => law,
                }
            }
        }
    };
}

// in the order of lists and tables
law_enum!(
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
        Self::all().into_iter().find(|law| law.info().name == name)
    }

    pub fn names() -> Vec<&'static str> {
        Self::all().iter().map(|law| law.info().name).collect()
    }

    /// The flow curves of sphere and half-space.
    pub fn flow_curves(&self) -> [Option<&FlowCurve>; 2] {
        match self {
            Self::Plm(plm) => plm.flow.each_ref().map(Option::as_ref),
            _ => [None, None],
        }
    }

    /// True if it says how a contact loads. All laws unload, if need be by the paper's law.
    pub fn has_loading(&self) -> bool {
        self.info().loading != "none"
    }

    /// True if its unloading is its own and not that of another law.
    pub(crate) fn has_own_unloading(&self) -> bool {
        !matches!(self, Self::KogutKomvopoulos(_))
    }

    /// Its name in tables: of a combination "loading + unloading".
    pub fn name(&self) -> String {
        match self {
            Self::Combined(Combined { loading, unloading }) => format!("{} + {}", loading.name(), unloading.name()),
            law => law.info().name.to_owned(),
        }
    }

    pub fn source(&self) -> String {
        match self {
            Self::Combined(Combined { loading, unloading }) => {
                format!("loading: {}; unloading: {}", loading.source(), unloading.source())
            }
            law => law.info().source.to_owned(),
        }
    }
}

/// The loading of one law with the unloading of another.
///
/// The unloading is given the force, indentation and contact radius of the peak as the loading has them.
#[derive(Debug, Clone, PartialEq)]
pub struct Combined {
    pub loading: Box<LawChoice>,
    pub unloading: Box<LawChoice>,
}

impl LawChoice {
    /// The law whose loading, and the law whose unloading this one has.
    fn loading_and_unloading(&self) -> [&Self; 2] {
        match self {
            Self::Combined(Combined { loading, unloading }) => {
                let ([loading, _], [_, unloading]) =
                    (loading.loading_and_unloading(), unloading.loading_and_unloading());
                [loading, unloading]
            }
            law => [law; 2],
        }
    }

    /// Sets by how much the rate of strain raises the flow curve of the PLM, or of the PLM in a combination.
    pub(crate) fn set_rate_factor(&mut self, factor: f64) {
        match self {
            Self::Plm(plm) => plm.rate_factor = factor,
            Self::Combined(Combined { loading, unloading }) => {
                loading.set_rate_factor(factor);
                unloading.set_rate_factor(factor);
            }
            _ => {}
        }
    }
}

impl ContactLaw for Combined {
    /// The PLM with its own unloading is the PLM.
    fn law(&self, bodies: &YieldingPair) -> Result<Law, LawError> {
        let ([loading, _], [_, unloading]) =
            (self.loading.loading_and_unloading(), self.unloading.loading_and_unloading());
        if let LawChoice::Plm(plm) = unloading {
            plm.check(bodies)?;
        }
        if let (LawChoice::Plm(loading), LawChoice::Plm(unloading)) = (loading, unloading) {
            loading.check(bodies)?;
            return Ok(loading.unloading_by(unloading, bodies));
        }
        let LawParts { loading, recovery } = self.build_parts(bodies);
        Ok(Law::from_published(loading?, recovery))
    }

    fn build_parts(&self, bodies: &YieldingPair) -> LawParts {
        let [loading, unloading] =
            [&self.loading, &self.unloading].map(|half| half.as_contact_law().build_parts(bodies));
        LawParts { recovery: unloading.recovery, ..loading }
    }
}

/// The laws that Xie et al. (2024) name and that could not be implemented, each with the reason.
pub fn unimplemented_laws() -> impl Iterator<Item = (&'static str, &'static str)> {
    include_str!("../not_public.csv").lines().skip(1).filter_map(|line| line.split_once('|'))
}
