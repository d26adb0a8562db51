//! The part of a scenario that a code for many spheres takes over: the bodies with plate or rod and damping, and the speed. That code
//! has its own way to compute all other forces and the path of the sphere.

use crate::contact::body::Support;
use crate::error::{Error, ErrorKind};
use crate::impact::Contact;
use crate::numerics::functions::cos;
use crate::scenario::input::{Input, OBLIQUE_KEYS, SPIN_KEYS};
use crate::scenario::keys::key;
use crate::scenario::{Kind, Scenario};

/// The contact of a scenario without the motion around it.
pub(super) struct ExportedContact {
    pub contact: Contact,
    /// Impact speed normal to the surface \[m/s\]; `None` without one, and where it varies.
    pub speed: Option<f64>,
    /// Radius \[m\] of the second ball; `None` for a wall.
    pub ball: Option<f64>,
    /// The coefficient of friction, if the scenario has one.
    pub friction: Option<f64>,
    /// A sentence for every other part of the scenario: it says that the part is left out, or what replaces it.
    pub omitted: Vec<String>,
}

impl ExportedContact {
    pub fn new(scenario: &Scenario) -> Result<Self, Error> {
        let kind = scenario.kind()?;
        let refuse = |message| Err(scenario.document.refusal(kind.name(), message));
        match kind {
            Kind::Calibrate => {
                return refuse(
                    "this scenario is a calibration. Run `plm-impact calibrate`, and export the resulting calibrated.toml.",
                );
            }
            Kind::Indentation => return refuse("this scenario has no impact. Remove this table, and add [impact]."),
            _ => {}
        }
        let plan = kind.is_table().then(|| scenario.plan()).transpose()?;
        let mut input = match &plan {
            Some(plan) => plan.input.clone(),
            None => scenario.resolve_bodies()?.0,
        };
        let paths = plan.map(|plan| plan.varied_paths()).unwrap_or_default();
        let is_single = !paths.iter().any(|path| ["impact.speed", "impact.drop_height", "impact.angle"].contains(path));
        let angle = input.number(key!("impact.angle")).unwrap_or(0.0);
        let speed = Some(input.speed() * cos(angle)).filter(|speed| is_single && *speed > 0.0);
        let mut left_out = omitted_parts(&input);
        let table = match kind {
            Kind::Repeat => {
                Some("[repeat] is not exported: the lines are for the first impact, on fresh surface".to_owned())
            }
            Kind::Sweep | Kind::MonteCarlo => Some(first_case(&input, kind, &paths)),
            _ => None,
        };
        left_out.splice(0..0, table);
        let friction = input.number(key!("friction.coefficient"));
        let of_motion = [key!("gravity.acceleration"), key!("impact.drop_height"), key!("air.density")];
        for key in of_motion.into_iter().chain(OBLIQUE_KEYS) {
            input.set(key, None);
        }
        let failed = |reason| Error::for_file(ErrorKind::Input, scenario.document.name(), reason);
        let contact = input.contact().map_err(failed)?;
        let ball = match contact.half_space().support {
            Support::Fixed => None,
            Support::Ball => contact.half_space().ball_radius(),
            Support::Free(_) => {
                let message = "only a fixed wall or two spheres can be exported. Remove this key, or give mass = \"ball\" with half_space.radius and half_space.density.";
                return Err(scenario.document.refusal("half_space.mass", message));
            }
        };
        Ok(Self { contact, speed, ball, friction, omitted: left_out })
    }
}

/// The parts of the motion that the other code has itself.
fn omitted_parts(input: &Input) -> Vec<String> {
    let has = |at| input.number(at).is_some();
    let by_itself = |name: &str| format!("{name} is not exported: set this in the simulation");
    let mut left_out = Vec::new();
    if has(key!("impact.angle")) {
        left_out.push("impact.angle is not exported: the speed is the component normal to the wall".to_owned());
    }
    let tables = [("[gravity]", key!("gravity.acceleration")), ("[air]", key!("air.density"))];
    let keys = SPIN_KEYS.map(|key| (key.path(), key)).into_iter().chain(tables);
    left_out.extend(keys.filter(|(_, key)| has(*key)).map(|(name, _)| by_itself(name)));
    left_out
}

/// Which of its cases stands for a table.
fn first_case(input: &Input, kind: Kind, paths: &[&str]) -> String {
    let key_values = input.key_values();
    let is_of_bodies = |path: &&&str| !path.starts_with("impact.") && !path.starts_with("solver.");
    let value = |path: &&str| {
        let key_values = key_values.iter().find(|key_values| key_values.path == *path)?;
        Some(format!("{path} = {}", key_values.terminal_text()))
    };
    let values: Vec<String> = paths.iter().filter(is_of_bodies).filter_map(value).collect();
    let name = kind.name();
    if values.is_empty() {
        return format!("[{name}] is not exported");
    }
    let which = if kind == Kind::MonteCarlo { "the middle of every range" } else { "the first values" };
    format!("[{name}] is not exported: the lines are for {which}, {}", values.join(", "))
}
