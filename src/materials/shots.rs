//! Shot for peening by its trade name, such as S230. The file `materials/shots.csv` names the standards.

use std::sync::LazyLock;

use super::MaterialEntry;
use crate::strings::csv::CsvReader;
use crate::strings::{did_you_mean, known_names, named_enum};

named_enum! {
    /// The material of a shot, with its name in the file.
    pub enum ShotKind {
        CastSteel = "cast_steel",
        CutWire = "cut_wire",
        Glass = "glass",
        Ceramic = "ceramic",
    }
}

/// A shot with a trade name.
#[derive(Debug, Clone, PartialEq)]
pub struct Shot {
    pub name: String,
    /// The diameter that the name states, in mm, as the file has it.
    pub diameter_mm: String,
    pub kind: ShotKind,
}

impl ShotKind {
    /// The material of the library with the density and the elastic constants of this shot, if the library has one.
    pub fn material(self) -> Option<&'static MaterialEntry> {
        match self {
            Self::CastSteel => super::find("steel-shot-cast"),
            Self::CutWire => super::find("steel-52100-hardened"),
            Self::Glass => super::find("glass-soda-lime"),
            Self::Ceramic => None,
        }
    }

    /// True for a shot of steel, whose hardness varies from delivery to delivery.
    pub fn is_steel(self) -> bool {
        matches!(self, Self::CastSteel | Self::CutWire)
    }
}

/// All shots, in the order of the file.
pub fn all_shots() -> &'static [Shot] {
    static ALL: LazyLock<Vec<Shot>> = LazyLock::new(|| read(include_str!("shots.csv")).unwrap_or_default());
    &ALL
}

/// The shots of a file; `None` if the file is damaged.
fn read(text: &str) -> Option<Vec<Shot>> {
    let reader = CsvReader::new(text).ok()?;
    let shot = |row: Result<(u64, csv::StringRecord), _>| {
        let (_, row) = row.ok()?;
        let kind = ShotKind::from_name(row.get(2)?)?;
        Some(Shot { name: row.get(0)?.to_owned(), diameter_mm: row.get(1)?.to_owned(), kind })
    };
    reader.rows().map(shot).collect()
}

/// The shot of this name. A hyphen or a blank before the number and small letters are allowed: CW-14, s 230.
///
/// # Errors
/// A message with the nearest names.
pub fn find_shot(name: &str) -> Result<&'static Shot, String> {
    let plain: String = name.chars().filter(|c| !['-', ' '].contains(c)).collect::<String>().to_uppercase();
    let names: Vec<&str> = all_shots().iter().map(|shot| shot.name.as_str()).collect();
    all_shots().iter().find(|shot| shot.name == plain).ok_or_else(|| {
        let rest = known_names(&plain, &names, "shots");
        let end = did_you_mean(&plain, names.iter().copied(), '"', &rest);
        format!("\"{name}\" is not known{end}. For any other shot give --diameter.")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The number of a name is a length: SAE J444 in 1e-4 inch, J441 in 1e-3 inch, J1173 in 1e-2 mm, J1830 in 1e-3 mm.
    #[test]
    fn diameter_follows_from_every_name() {
        assert_eq!(all_shots().len(), 37);
        for Shot { name, diameter_mm, kind } in all_shots() {
            let number: f64 = name.trim_start_matches(char::is_alphabetic).parse().unwrap();
            let unit = match kind {
                ShotKind::CastSteel => 2.54e-3,
                ShotKind::CutWire => 2.54e-2,
                ShotKind::Glass => 1e-2,
                ShotKind::Ceramic => 1e-3,
            };
            let diameter: f64 = diameter_mm.parse().unwrap();
            assert!((number * unit / diameter - 1.0).abs() < 1e-12, "{name}");
        }
    }

    #[test]
    fn unknown_shot_names_the_nearest() {
        assert_eq!(find_shot("cw-14").map(|shot| shot.name.as_str()), Ok("CW14"));
        let refused = find_shot("S240").unwrap_err();
        assert!(refused.contains("\"S230\"") && refused.contains("--diameter"), "{refused}");
    }
}
