//! `[law]`: one table, named by its law, with that law's own keys. The keys stand for fields of the laws themselves.

use std::mem::discriminant;
use std::sync::{Arc, LazyLock};

use toml::de::DeValue;

use super::field::{Field, Held, show_word};
use super::key::AnyKey;
use super::key::Form::{self, Number, NumberOr, Text, Word};
use super::quantity::{AREA_FACTOR, EXPONENT, FACTOR, SHARE, STRENGTH, TRANSITION_RATIO};
use super::read::{Fault, Reader, items};
use super::table::{keys, tables};
use super::words::{HARDNESSES, LOADINGS, UNLOADINGS};
use super::written::{COMBINED, Node, below};
use crate::law::catalogue::{
    brake::Brake, every_law, hertz::Hertz, jackson_green::JacksonGreen, johnson::Johnson, kogut_etsion::KogutEtsion,
    kogut_komvopoulos::KogutKomvopoulos, ma_liu::MaLiu, mesarovic_johnson::MesarovicJohnson, stronge::Stronge,
    thornton::Thornton, walton_braun::WaltonBraun, yigit_christoforou::YigitChristoforou,
};
use crate::law::{LawChoice, Plm, PlmCoefficients};

keys! {
    Plm {
        /// Exponent of the unloading force, or "pressure-shape": the exponent that follows from the shape of the contact
        /// pressure at the peak. Other numbers than 1.5 are for comparison.
        unloading_exponent in exponent: NumberOr(&EXPONENT, "pressure-shape") => "1.5",
        /// File of coefficients of the loading curve, relative to the scenario.
        coefficients: Text("my.toml") => "built in",
    }
    Hertz {}
    Thornton {
        /// Contact pressure at which the straight part of the loading begins.
        yield_pressure: Number(&STRENGTH) => "largest Hertz pressure at first yield",
    }
    Stronge {
        /// Mean contact pressure at first yield over the yield strength.
        yield_pressure_ratio: Number(&FACTOR) => "1.1",
        /// Factor f_u of the recovered approach.
        unloading_factor: Number(&FACTOR) => "1",
    }
    JacksonGreen {
        /// Largest Hertz pressure at first yield over the yield strength.
        yield_factor: Number(&FACTOR) => "1.295 exp(0.736 nu)",
        /// Formula of the geometric hardness: exponential is that of 2005, cosine the later one.
        hardness: Word(&HARDNESSES) => "\"exponential\"",
    }
    KogutEtsion {
        /// Largest Hertz pressure at first yield over the yield strength.
        yield_factor: Number(&FACTOR) => "(0.454 + 0.41 nu) x 2.8",
    }
    KogutKomvopoulos {}
    YigitChristoforou {
        /// Largest Hertz pressure at first yield over the yield strength.
        yield_factor: Number(&FACTOR) => "1.649",
    }
    MaLiu {
        /// Hardness over the yield strength.
        hardness_ratio: Number(&FACTOR) => "2.8",
        /// Indentation of full plasticity over that at first yield.
        transition_ratio: Number(&TRANSITION_RATIO) => "110",
    }
    Brake {}
    MesarovicJohnson {
        /// True contact area over the area in which the sphere cuts the original surface.
        area_factor: Number(&AREA_FACTOR) => "1.43",
    }
    WaltonBraun {
        /// Stiffness of loading, in units of force over indentation at first yield.
        loading_stiffness: Number(&FACTOR) => "1",
        /// Stiffness of loading over that of unloading; the restitution is the square root of this ratio.
        stiffness_ratio: Number(&SHARE) => "0.5",
    }
    Johnson {
        /// Mean contact pressure while the sphere goes in.
        dynamic_pressure: Number(&STRENGTH) => "3 yield strengths",
    }
}

tables! {
    /// `[law.combined]`: the loading of one law with the unloading of another.
    pub struct HalvesInput {
        /// Law of the loading.
        loading: Option<String> as Word(&LOADINGS),
        /// Law of the unloading.
        unloading: Option<String> as Word(&UNLOADINGS),
    }
}

/// The table of a law; `None` for one of two halves.
macro_rules! tables_of {
    ($($file:ident::$law:ident),* $(,)?) => {
        fn table(law: &LawChoice) -> Option<&dyn Field> {
            match law {
                $(LawChoice::$law(law) => Some(law),)*
                LawChoice::Combined(_) => None,
            }
        }

        fn table_mut(law: &mut LawChoice) -> Option<&mut dyn Field> {
            match law {
                $(LawChoice::$law(law) => Some(law),)*
                LawChoice::Combined(_) => None,
            }
        }
    };
}

every_law!(tables_of);

/// All laws with their defaults. Their order gives the numbers of their tables.
static ALL: LazyLock<Vec<LawChoice>> = LazyLock::new(LawChoice::all);

/// One law, named by its table; PLM if none is.
impl Field for LawChoice {
    fn read(&mut self, form: &Form, node: &Node, reader: &mut Reader) -> Result<(), Fault> {
        let Some(written) = chosen(self, node, reader)? else { return Ok(()) };
        let name = self.about().name;
        if let Some(table) = table_mut(self) {
            reader.within(name, |reader| table.read(form, written, reader));
        }
        Ok(())
    }
    fn at(&self, at: usize) -> Option<&dyn Field> {
        table(self).filter(|_| discriminant(self) == discriminant(&ALL[at]))
    }
    fn at_mut(&mut self, at: usize) -> Option<&mut dyn Field> {
        if discriminant(self) == discriminant(&ALL[at]) { table_mut(self) } else { None }
    }
    fn keys(&self, path: &str, way: &[usize], into: &mut Vec<AnyKey>) {
        for (at, law) in ALL.iter().enumerate() {
            if let Some(table) = table(law) {
                table.keys(&below(path, law.about().name), &[way, &[at]].concat(), into);
            }
        }
        HalvesInput::default().keys(&below(path, COMBINED), &[], into);
    }
    fn show(&self, form: &Form, path: &str, into: &mut Vec<Held>) {
        show_word(self.name(), path, into);
        if let Some(table) = table(self) {
            table.show(form, &below(path, self.about().name), into);
        }
    }
}

const ONE_LAW: &str = "write one table such as [law.plm], or leave [law] out";

/// Takes the law that `[law]` names, and gives its table if it is one law.
fn chosen<'n, 't>(
    choice: &mut LawChoice,
    node: &'n Node<'t>,
    reader: &mut Reader,
) -> Result<Option<&'n Node<'t>>, Fault> {
    let DeValue::Table(laws) = node.get_ref() else {
        return Err(Fault::at(node, format!("not a table; {ONE_LAW}")));
    };
    let found: Vec<&str> = laws.keys().map(|law| &**law.get_ref()).collect();
    let (&[name], Some((law, table))) = (&found[..], laws.iter().next()) else {
        let found = if found.is_empty() { "none".to_owned() } else { found.join(" and ") };
        return Err(Fault::at(node, format!("a scenario has exactly one law, found {found}; {ONE_LAW}")));
    };
    if name == COMBINED {
        reader.within(COMBINED, |reader| {
            *choice = combined(table, reader)?;
            Ok(())
        });
        return Ok(None);
    }
    let Some(known) = LawChoice::all().into_iter().find(|law| law.about().name == name) else {
        let known: Vec<&str> = LawChoice::names().into_iter().chain([COMBINED]).collect();
        reader.unknown([(law, table)], &known);
        return Ok(None);
    };
    *choice = known;
    if !choice.has_loading() {
        let message = format!(
            "{name} is a law of unloading only; write [law.combined] with loading = \"jackson_green\" (or another) and unloading = \"{name}\""
        );
        reader.within(name, |_| Err(Fault::at(table, message)));
    }
    Ok(Some(table))
}

/// The law of two halves.
fn combined(node: &Node, reader: &mut Reader) -> Result<LawChoice, Fault> {
    let mut halves = HalvesInput::default();
    halves.read(&Form::Table, node, reader)?;
    for (half, verb, law) in [("loading", "loads", "plm"), ("unloading", "unloads", "thornton")] {
        if !items(node)?.contains_key(half) {
            let message = format!("the key `{half}` is missing: the law that {verb}, such as {half} = \"{law}\"");
            return Err(Fault::at(node, message));
        }
    }
    let name = format!("{} + {}", halves.loading.unwrap_or_default(), halves.unloading.unwrap_or_default());
    Ok(LawChoice::from_name(&name).unwrap_or_default())
}

/// Coefficients of a file.
impl Field for Arc<PlmCoefficients> {
    fn read(&mut self, _: &Form, node: &Node, reader: &mut Reader) -> Result<(), Fault> {
        let [path, text] = reader.file(node, "my.toml")?;
        let table = PlmCoefficients::from_toml(&text);
        let table = table.map_err(|error| Fault::at(node, format!("{path}: {}", error.to_string().trim_end())))?;
        *self = Self::new(table);
        Ok(())
    }
    fn show(&self, _: &Form, path: &str, into: &mut Vec<Held>) {
        show_word(format!("{} ({})", self.provenance.name, self.provenance.source), path, into);
    }
}
