//! `[law]`: one table, named by its law, with that law's own keys.

use serde::Deserialize;

use super::file::PlmTable;
use super::values::{AreaFactor, Factor, Share, Strength, TransitionRatio};
use super::{Scenario, ScenarioError};
use crate::law::brake::Brake;
use crate::law::combined::Combined;
use crate::law::hertz::Hertz;
use crate::law::jackson_green::{Hardness, JacksonGreen, Jumps};
use crate::law::johnson::Johnson;
use crate::law::kogut_etsion::KogutEtsion;
use crate::law::kogut_komvopoulos::KogutKomvopoulos;
use crate::law::ma_liu::MaLiu;
use crate::law::mesarovic_johnson::MesarovicJohnson;
use crate::law::stronge::Stronge;
use crate::law::thornton::Thornton;
use crate::law::walton_braun::WaltonBraun;
use crate::law::yigit_christoforou::YigitChristoforou;
use crate::law::{LawChoice, Plm};
use crate::nearest::nearest;

/// `[law]`: exactly one table, named by its law.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum LawTable {
    /// `[law.plm]`
    Plm(PlmTable),
    /// `[law.hertz]`
    Hertz(NoKeys),
    /// `[law.thornton]`
    Thornton(ThorntonTable),
    /// `[law.stronge]`
    Stronge(StrongeTable),
    /// `[law.jackson_green]`
    JacksonGreen(JacksonGreenTable),
    /// `[law.kogut_etsion]`
    KogutEtsion(KogutEtsionTable),
    /// `[law.kogut_komvopoulos]`
    KogutKomvopoulos(KogutKomvopoulosTable),
    /// `[law.yigit_christoforou]`
    YigitChristoforou(YigitChristoforouTable),
    /// `[law.ma_liu]`
    MaLiu(MaLiuTable),
    /// `[law.brake]`
    Brake(NoKeys),
    /// `[law.mesarovic_johnson]`
    MesarovicJohnson(MesarovicJohnsonTable),
    /// `[law.walton_braun]`
    WaltonBraun(WaltonBraunTable),
    /// `[law.johnson]`
    Johnson(JohnsonTable),
    /// `[law.combined]`
    Combined(CombinedTable),
}

macro_rules! tables {
    ($($(#[$doc:meta])* $name:ident { $($(#[$key_doc:meta])* $key:ident: $quantity:ty,)* })*) => {$(
        $(#[$doc])*
        #[derive(Debug, Clone, PartialEq, Default, Deserialize)]
        #[serde(deny_unknown_fields, expecting = "a table")]
        pub struct $name {
            $($(#[$key_doc])* pub $key: Option<$quantity>,)*
        }
    )*};
}

tables! {
    /// A table that takes no keys.
    NoKeys {}
    /// `[law.thornton]`
    ThorntonTable {
        /// p_y.
        yield_pressure: Strength,
    }
    /// `[law.stronge]`
    StrongeTable {
        /// ϑ.
        yield_pressure_ratio: Factor,
        /// f_u.
        unloading_factor: Factor,
    }
    /// `[law.jackson_green]`
    JacksonGreenTable {
        /// C.
        yield_factor: Factor,
        /// Form of H_G.
        hardness: HardnessWord,
        /// What becomes of the printed jump.
        jumps: JumpsWord,
    }
    /// `[law.kogut_etsion]`
    KogutEtsionTable {
        /// K H/σ_Y.
        yield_factor: Factor,
        /// What becomes of the printed jumps.
        jumps: JumpsWord,
    }
    /// `[law.kogut_komvopoulos]`
    KogutKomvopoulosTable {
        /// What becomes of the printed jumps.
        jumps: JumpsWord,
    }
    /// `[law.yigit_christoforou]`
    YigitChristoforouTable {
        /// C.
        yield_factor: Factor,
    }
    /// `[law.ma_liu]`
    MaLiuTable {
        /// H/σ_Y.
        hardness_ratio: Factor,
        /// δ_p/δ_Y.
        transition_ratio: TransitionRatio,
    }
    /// `[law.mesarovic_johnson]`
    MesarovicJohnsonTable {
        /// c².
        area_factor: AreaFactor,
    }
    /// `[law.walton_braun]`
    WaltonBraunTable {
        /// k_1 in units of F_Y/δ_Y.
        loading_stiffness: Factor,
        /// k_1/k_2.
        stiffness_ratio: Share,
    }
    /// `[law.johnson]`
    JohnsonTable {
        /// p_d.
        dynamic_pressure: Strength,
    }
}

/// `[law.combined]`
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub struct CombinedTable {
    /// The law that loads.
    pub loading: String,
    /// The law that unloads.
    pub unloading: String,
}

/// "exponential" or "cosine".
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum HardnessWord {
    /// 2005.
    Exponential,
    /// Later form.
    Cosine,
}

/// "printed" or "crossed".
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum JumpsWord {
    /// Kept.
    Printed,
    /// Every piece goes on to where the next one crosses it.
    Crossed,
}

impl From<JumpsWord> for Jumps {
    fn from(word: JumpsWord) -> Self {
        match word {
            JumpsWord::Printed => Self::Printed,
            JumpsWord::Crossed => Self::Crossed,
        }
    }
}

impl Scenario {
    /// The law that the scenario names, with its parameters; PLM if none.
    pub(super) fn law(&self) -> Result<LawChoice, ScenarioError> {
        let jumps = |word: Option<JumpsWord>| word.map(Jumps::from).unwrap_or_default();
        let factor = |factor: Option<Factor>| factor.map(|factor| factor.0);
        let Some(table) = &self.file.law else { return Ok(LawChoice::default()) };
        let choice = match table {
            LawTable::Plm(_) => LawChoice::Plm(Plm::default()),
            LawTable::Hertz(_) => LawChoice::Hertz(Hertz),
            LawTable::Thornton(table) => {
                LawChoice::Thornton(Thornton { yield_pressure: table.yield_pressure.map(|pressure| pressure.0) })
            }
            LawTable::Stronge(table) => {
                let default = Stronge::default();
                LawChoice::Stronge(Stronge {
                    yield_pressure_ratio: factor(table.yield_pressure_ratio).unwrap_or(default.yield_pressure_ratio),
                    unloading_factor: factor(table.unloading_factor).unwrap_or(default.unloading_factor),
                })
            }
            LawTable::JacksonGreen(table) => LawChoice::JacksonGreen(JacksonGreen {
                yield_factor: factor(table.yield_factor),
                hardness: match table.hardness {
                    Some(HardnessWord::Cosine) => Hardness::Cosine,
                    _ => Hardness::Exponential,
                },
                jumps: jumps(table.jumps),
            }),
            LawTable::KogutEtsion(table) => LawChoice::KogutEtsion(KogutEtsion {
                yield_factor: factor(table.yield_factor),
                jumps: jumps(table.jumps),
            }),
            LawTable::KogutKomvopoulos(table) => {
                LawChoice::KogutKomvopoulos(KogutKomvopoulos { jumps: jumps(table.jumps) })
            }
            LawTable::YigitChristoforou(table) => {
                LawChoice::YigitChristoforou(YigitChristoforou { yield_factor: factor(table.yield_factor) })
            }
            LawTable::MaLiu(table) => {
                let default = MaLiu::default();
                LawChoice::MaLiu(MaLiu {
                    hardness_ratio: factor(table.hardness_ratio).unwrap_or(default.hardness_ratio),
                    transition_ratio: table.transition_ratio.map_or(default.transition_ratio, |ratio| ratio.0),
                })
            }
            LawTable::Brake(_) => LawChoice::Brake(Brake),
            LawTable::MesarovicJohnson(table) => {
                let default = MesarovicJohnson::default();
                LawChoice::MesarovicJohnson(MesarovicJohnson {
                    area_factor: table.area_factor.map_or(default.area_factor, |factor| factor.0),
                })
            }
            LawTable::WaltonBraun(table) => {
                let default = WaltonBraun::default();
                LawChoice::WaltonBraun(WaltonBraun {
                    loading_stiffness: factor(table.loading_stiffness).unwrap_or(default.loading_stiffness),
                    stiffness_ratio: table.stiffness_ratio.map_or(default.stiffness_ratio, |share| share.0),
                })
            }
            LawTable::Johnson(table) => {
                LawChoice::Johnson(Johnson { dynamic_pressure: table.dynamic_pressure.map(|pressure| pressure.0) })
            }
            LawTable::Combined(table) => LawChoice::Combined(Combined {
                loading: Box::new(self.half("law.combined.loading", &table.loading, LawChoice::has_loading)?),
                unloading: Box::new(self.half("law.combined.unloading", &table.unloading, LawChoice::has_unloading)?),
            }),
        };
        if !choice.has_loading() {
            let name = choice.name();
            let message = format!(
                "{name} is a law of unloading only; write [law.combined] with loading = \"jackson_green\" (or another) and unloading = \"{name}\""
            );
            return Err(self.document.refuse(&format!("law.{name}"), message));
        }
        Ok(choice)
    }

    fn half(&self, key: &str, name: &str, has_it: fn(&LawChoice) -> bool) -> Result<LawChoice, ScenarioError> {
        let known: Vec<LawChoice> = LawChoice::all().into_iter().filter(has_it).collect();
        let names = || known.iter().map(|law| law.about().name);
        known.iter().find(|law| law.about().name == name).cloned().ok_or_else(|| {
            let guess = nearest(name, names()).map_or_else(String::new, |near| format!(", did you mean \"{near}\"?"));
            let half = key.rsplit('.').next().unwrap_or_default();
            let list: Vec<_> = names().collect();
            self.document.refuse(key, format!("no {half} is known as \"{name}\"{guess}; there are {}", list.join(", ")))
        })
    }
}

/// The law of that name in a list of a sweep.
///
/// # Errors
/// The message for a name that is no whole law.
pub(super) fn named(name: &str) -> Result<LawChoice, String> {
    let whole: Vec<_> = LawChoice::all().into_iter().filter(LawChoice::has_loading).collect();
    let names = || whole.iter().map(|law| law.about().name);
    let choice = LawChoice::from_name(name).filter(LawChoice::has_loading);
    choice.ok_or_else(|| {
        let guess = nearest(name, names()).map_or_else(String::new, |near| format!(", did you mean \"{near}\"?"));
        let list: Vec<_> = names().collect();
        format!(
            "no law is known as \"{name}\"{guess}; laws are {}, or \"loading + unloading\" such as \"jackson_green + brake\"",
            list.join(", ")
        )
    })
}
