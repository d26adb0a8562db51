//! `[law]`: one table, named by its law, with that law's own keys. The keys stand for fields of the laws themselves.

use std::sync::Arc;

use super::field::{
    Fault, Field, Given, Number, Numeric, Or, Reader, Scalar, Shown, Special, Table, Word, keys, numeric, tables, text,
};
use super::key::{AnyKey, Form};
use super::quantity::{AreaFactor, Exponent, Factor, Share, Strength, TransitionRatio};
use super::words::{Hardnesses, JumpWords, Loadings, Unloadings};
use super::written::{Node, Value};
use crate::law::catalogue::brake::Brake;
use crate::law::catalogue::hertz::Hertz;
use crate::law::catalogue::jackson_green::{Hardness, JacksonGreen};
use crate::law::catalogue::johnson::Johnson;
use crate::law::catalogue::kogut_etsion::KogutEtsion;
use crate::law::catalogue::kogut_komvopoulos::KogutKomvopoulos;
use crate::law::catalogue::ma_liu::MaLiu;
use crate::law::catalogue::mesarovic_johnson::MesarovicJohnson;
use crate::law::catalogue::stronge::Stronge;
use crate::law::catalogue::thornton::Thornton;
use crate::law::catalogue::walton_braun::WaltonBraun;
use crate::law::catalogue::yigit_christoforou::YigitChristoforou;
use crate::law::jumps::Jumps;
use crate::law::{Combined, LawChoice, Plm, PlmCoefficients, UnloadingExponent};

/// In place of the exponent of the unloading force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PressureShape;

impl Special for PressureShape {
    const WORD: &'static str = "pressure-shape";
}

keys! {
    Plm {
        /// Exponent of the unloading force, or "pressure-shape": the exponent that follows from the shape of the contact
        /// pressure at the peak. Other numbers than 1.5 are for comparison.
        unloading_exponent => exponent: Or<Exponent, PressureShape> = "1.5",
        /// File of coefficients of the loading curve, relative to the scenario.
        coefficients => coefficients: Coefficients = "built in",
    }
    Hertz {}
    Thornton {
        /// Contact pressure at which the straight part of the loading begins.
        yield_pressure => yield_pressure: Number<Strength> = "largest Hertz pressure at first yield",
    }
    Stronge {
        /// Mean contact pressure at first yield over the yield strength.
        yield_pressure_ratio => yield_pressure_ratio: Number<Factor> = "1.1",
        /// Factor f_u of the recovered approach.
        unloading_factor => unloading_factor: Number<Factor> = "1",
    }
    JacksonGreen {
        /// Largest Hertz pressure at first yield over the yield strength.
        yield_factor => yield_factor: Number<Factor> = "1.295 exp(0.736 nu)",
        /// Formula of the geometric hardness: exponential is that of 2005, cosine the later one.
        hardness => hardness: Word<Hardnesses> = "\"exponential\"",
        /// What becomes of the jumps of the printed formulas: kept, or every piece goes on until it crosses the next.
        jumps => jumps: Word<JumpWords> = "\"printed\"",
    }
    KogutEtsion {
        /// Largest Hertz pressure at first yield over the yield strength.
        yield_factor => yield_factor: Number<Factor> = "(0.454 + 0.41 nu) x 2.8",
        /// What becomes of the jumps of the printed formulas: kept, or every piece goes on until it crosses the next.
        jumps => jumps: Word<JumpWords> = "\"printed\"",
    }
    KogutKomvopoulos {
        /// What becomes of the jumps of the printed formulas: kept, or every piece goes on until it crosses the next.
        jumps => jumps: Word<JumpWords> = "\"printed\"",
    }
    YigitChristoforou {
        /// Largest Hertz pressure at first yield over the yield strength.
        yield_factor => yield_factor: Number<Factor> = "1.649",
    }
    MaLiu {
        /// Hardness over the yield strength.
        hardness_ratio => hardness_ratio: Number<Factor> = "2.8",
        /// Indentation of full plasticity over that at first yield.
        transition_ratio => transition_ratio: Number<TransitionRatio> = "110",
    }
    Brake {}
    MesarovicJohnson {
        /// True contact area over the area in which the sphere cuts the original surface.
        area_factor => area_factor: Number<AreaFactor> = "1.43",
    }
    WaltonBraun {
        /// Stiffness of loading, in units of force over indentation at first yield.
        loading_stiffness => loading_stiffness: Number<Factor> = "1",
        /// Stiffness of loading over that of unloading; the restitution is the square root of this ratio.
        stiffness_ratio => stiffness_ratio: Number<Share> = "0.5",
    }
    Johnson {
        /// Mean contact pressure while the sphere goes in.
        dynamic_pressure => dynamic_pressure: Number<Strength> = "3 yield strengths",
    }
}

tables! {
    /// `[law.combined]`: the loading of one law with the unloading of another.
    pub struct HalvesInput {
        /// Law of the loading.
        loading: Option<Word<Loadings>>,
        /// Law of the unloading.
        unloading: Option<Word<Unloadings>>,
    }
}

/// The law that is named, PLM if none is.
#[derive(Debug, Clone, Default)]
pub struct LawInput {
    /// The law with its parameters, but for a flow curve of the half-space.
    pub choice: LawChoice,
    /// The halves of a combined law.
    pub halves: Option<HalvesInput>,
}

/// The laws by their names, with the table of each.
macro_rules! laws {
    ($($name:literal $law:ident),* $(,)?) => {
        /// Takes the keys of the table of this law.
        fn take(choice: &mut LawChoice, node: &Node, reader: &mut Reader) -> Result<(), Fault> {
            match choice {
                $(LawChoice::$law(law) => law.take(node, reader),)*
                LawChoice::Combined(_) => Ok(()),
            }
        }

        /// The keys of all laws.
        fn keys(path: &str, into: &mut Vec<AnyKey>) {
            $(<$law as Table>::keys(&format!("{path}.{}", $name), into);)*
            HalvesInput::keys(&format!("{path}.{COMBINED}"), into);
        }

        /// The numeric keys of all laws.
        pub(super) fn numeric_keys() -> Vec<Numeric<LawChoice>> {
            let mut keys = Vec::new();
            $(keys.extend(numeric::<LawChoice, $law>(
                concat!("law.", $name),
                |choice| if let LawChoice::$law(law) = choice { Some(law) } else { None },
                |choice| if let LawChoice::$law(law) = choice { Some(law) } else { None },
            ));)*
            keys
        }
    };
}

laws!(
    "plm" Plm,
    "hertz" Hertz,
    "thornton" Thornton,
    "stronge" Stronge,
    "jackson_green" JacksonGreen,
    "kogut_etsion" KogutEtsion,
    "kogut_komvopoulos" KogutKomvopoulos,
    "yigit_christoforou" YigitChristoforou,
    "ma_liu" MaLiu,
    "brake" Brake,
    "mesarovic_johnson" MesarovicJohnson,
    "walton_braun" WaltonBraun,
    "johnson" Johnson,
);

/// The law of two halves.
pub const COMBINED: &str = "combined";
const ONE_LAW: &str = "write one table such as [law.plm], or leave [law] out";

impl Field for LawInput {
    fn form() -> Form {
        Form::Table(keys)
    }
    fn read(&mut self, node: &Node, reader: &mut Reader) -> Result<(), Fault> {
        let Value::Table(laws) = &node.value else {
            return Err(Fault::at(node, format!("not a table; {ONE_LAW}")));
        };
        let [law] = &laws.0[..] else {
            let found: Vec<&str> = laws.0.iter().map(|law| law.name.as_str()).collect();
            let found = if found.is_empty() { "none".to_owned() } else { found.join(" and ") };
            return Err(Fault::at(node, format!("a scenario has exactly one law, found {found}; {ONE_LAW}")));
        };
        if law.name == COMBINED {
            let mut halves = HalvesInput::default();
            reader.within(COMBINED, |reader| halves.take(&law.node, reader));
            if let (Some(loading), Some(unloading)) = (&halves.loading, &halves.unloading) {
                let half = |name: &str| LawChoice::from_name(name).unwrap_or_default().into();
                self.choice =
                    LawChoice::Combined(Combined { loading: half(&loading.name), unloading: half(&unloading.name) });
            }
            self.halves = Some(halves);
        } else if let Some(choice) = LawChoice::all().into_iter().find(|choice| choice.about().name == law.name) {
            self.choice = choice;
            reader.within(&law.name, |reader| take(&mut self.choice, &law.node, reader));
        } else {
            let known: Vec<&str> = LawChoice::names().into_iter().chain([COMBINED]).collect();
            reader.unknown(&law.name, law.span.clone(), &known);
        }
        Ok(())
    }
}

/// Coefficients of a file.
pub struct Coefficients(Arc<PlmCoefficients>);

impl Scalar for Coefficients {
    fn form() -> Form {
        Form::Text("my.toml")
    }
    fn read(node: &Node, reader: &mut Reader) -> Result<Self, Fault> {
        let [path, text] = reader.file(node, text(node, "my.toml")?)?;
        let table = PlmCoefficients::from_toml(&text);
        let table = table.map_err(|error| Fault::at(node, format!("{path}: {}", error.to_string().trim_end())))?;
        Ok(Self(Arc::new(table)))
    }
}

impl From<Coefficients> for Arc<PlmCoefficients> {
    fn from(of: Coefficients) -> Self {
        of.0
    }
}

impl Shown for Arc<PlmCoefficients> {}
impl Shown for Jumps {}
impl Shown for Hardness {}

impl From<Word<JumpWords>> for Jumps {
    fn from(word: Word<JumpWords>) -> Self {
        if word.name == "crossed" { Self::Crossed } else { Self::Printed }
    }
}

impl From<Word<Hardnesses>> for Hardness {
    fn from(word: Word<Hardnesses>) -> Self {
        if word.name == "cosine" { Self::Cosine } else { Self::Exponential }
    }
}

impl From<Or<Exponent, PressureShape>> for UnloadingExponent {
    fn from(exponent: Or<Exponent, PressureShape>) -> Self {
        match exponent {
            Or::Number(number) if f64::from(number) == 1.5 => Self::Paper,
            Or::Number(number) => Self::Fixed(number.into()),
            Or::Word(_) => Self::PressureShape,
        }
    }
}

impl Shown for UnloadingExponent {
    fn shown(&self) -> Option<Given> {
        Some(match self {
            Self::Paper => Given::Number(1.5),
            Self::Fixed(value) => Given::Number(*value),
            Self::PressureShape => Given::Word,
        })
    }
}
