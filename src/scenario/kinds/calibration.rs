//! `[calibrate]`: keys that are fitted to measurements.

use crate::contact::law::LawChoice;
use crate::contact::law::plm::hardness_test::hardness_of_flow_stress;
use crate::contact::strength::hardness::{self, HardnessScale};
use crate::error::Error;
use crate::impact::{Method, WaveguideKind};
use crate::scenario::document::read_text;
use crate::scenario::input::{Body, BodyMaterial, Input, N_BODY_KEYS, NumericKey, REQUIRED_KEYS};
use crate::scenario::keys::key;
use crate::scenario::keys::words::STUDENT_T;
use crate::scenario::plan::{AxisValues, Cases, FreeKey, Plan, SweepAxis};
use crate::scenario::{DATA_KEY, MAX_DATA_MIB, Scenario};

#[derive(Debug, Clone, PartialEq)]
pub enum MeasurementSource {
    /// A file: its name and its text.
    Text(String, String),
    /// The table `[calibrate.measured]`: names and values, SI, of one impact.
    Numbers(Vec<(String, f64)>),
}

/// The request of `[calibrate]`. All numbers are in SI, and checked.
#[derive(Debug, Clone)]
pub struct CalibrationRequest {
    /// The input, with the free keys at the lower ends of their ranges. The speed is NaN if it is not given.
    pub input: Input,
    /// The free keys: one or two, or empty if measurements are only compared.
    pub free: Vec<FreeKey>,
    pub source: MeasurementSource,
    /// Standard deviations by the name of the measurement.
    pub deviations: Vec<(String, f64)>,
    /// Error of the law, as a fraction of each value.
    pub model_error: f64,
    /// True if the noise is to be estimated, even if the data give standard deviations.
    pub is_estimated: bool,
    /// True if outliers are expected.
    pub is_robust: bool,
    /// Other laws to fit.
    pub laws: Vec<LawChoice>,
}

/// The range of the strength in multiples of the modulus of its body.
const STRENGTH_RANGE: [f64; 2] = [1e-5, 0.1];

impl Scenario {
    /// The calibration of the scenario.
    pub fn calibration_request(&self) -> Result<CalibrationRequest, Error> {
        self.refuse_columns()?;
        if !self.is_given("calibrate") {
            return Err(self.document.refusal("", NO_TABLE_TEXT));
        }
        let (mut input, _) = self.check_input(N_BODY_KEYS)?;
        input.set_default_method(Method::Auto);
        let free = self.free_keys(&input);
        for free in &free {
            free.key.set_exclusive(&mut input, free.from);
        }
        let laws = self.input.word_list(key!("calibrate.laws")).unwrap_or_default();
        let laws: Vec<LawChoice> = laws.iter().filter_map(|name| LawChoice::from_name(name)).collect();
        let hardens = Body::ALL.into_iter().find(|body| input.flow_curve(*body).is_some());
        let has_others = laws.iter().any(|law| law.name() != input.named_law.name());
        if let Some(body) = hardens.filter(|_| has_others) {
            let table = body.flow_stress();
            let message = format!("the other laws do not support {table}. Remove this table, or fit the law plm only.");
            return Err(self.document.refusal("calibrate.laws", message));
        }
        if input.has_rate() && has_others {
            let message = "the other laws do not support a strain rate. Remove the rate, or fit the law plm only.";
            return Err(self.document.refusal("calibrate.laws", message));
        }
        let mut deviations = self.input.numbers_of("calibrate.noise");
        let is_estimated = self.is_given("calibrate.noise") && deviations.is_empty();
        deviations.retain(|(name, _)| name != "model");
        Ok(CalibrationRequest {
            source: self.measurements()?,
            free,
            deviations,
            model_error: self.input.number(key!("calibrate.noise.model")).unwrap_or(0.0),
            is_estimated,
            is_robust: self.input.word(key!("calibrate.robust")) == Some(STUDENT_T),
            laws,
            input,
        })
    }

    fn measurements(&self) -> Result<MeasurementSource, Error> {
        let measured = self.input.numbers_of("calibrate.measured");
        match (self.input.text_value(key!("calibrate.data")), measured.is_empty()) {
            (Some(name), _) => {
                if let Some((path, text)) = self.files.get(DATA_KEY) {
                    return Ok(MeasurementSource::Text(path.display().to_string(), text.clone()));
                }
                let path = self.directory.join(name);
                read_text(&path, MAX_DATA_MIB).map(|text| MeasurementSource::Text(path.display().to_string(), text))
            }
            (None, false) => Ok(MeasurementSource::Numbers(measured)),
            (None, true) => {
                let message = "no measurements are given. Give data = \"drops.csv\", or one value such as measured.restitution = 0.49.";
                Err(self.document.refusal("calibrate", message))
            }
        }
    }

    /// The free keys. If the scenario names none, the free key is the yield strength of one body, or its hardness if the scenario gives
    /// a hardness.
    fn free_keys(&self, input: &Input) -> Vec<FreeKey> {
        if let Some(free) = &self.variation.free {
            let on_scale = |free: &FreeKey| FreeKey { hardness: self.hardness_scale(free.key), ..*free };
            return free.iter().map(on_scale).collect();
        }
        let body = self.default_body(input);
        let path = if self.is_given(body.hardness()) { body.hardness() } else { body.yield_strength() };
        let [from, to] = strength_range(input, body, path);
        let free = |key: NumericKey| {
            let (from, hardness) = (from.max(key.quantity().range().0), self.hardness_scale(key));
            FreeKey { key, from, to, is_logarithmic: true, hardness }
        };
        NumericKey::find(path).map(free).into_iter().collect()
    }

    /// The body whose strength is fitted, if the scenario names no key. This is the half-space. It is the sphere if the scenario gives the
    /// strength of the sphere, makes the sphere the softer body, and names no material of the half-space.
    fn default_body(&self, input: &Input) -> Body {
        let sphere = Body::Sphere;
        let is_given = [sphere.yield_strength(), sphere.hardness()].iter().any(|path| self.document.contains(path));
        let is_softer = || input.yield_partition().map(|partition| partition.is_sphere);
        let is_named = self.document.contains(Body::HalfSpace.material());
        if is_given && !is_named && is_softer() == Some(true) { sphere } else { Body::HalfSpace }
    }

    /// The hardness scale on which the scenario or a material gives a key, or on which the scenario gives an end of its range.
    pub(super) fn hardness_scale(&self, key: NumericKey) -> Option<HardnessScale> {
        let end = format!("calibrate.free.{}.from", key.path());
        let given = [key.path(), &end].into_iter().find_map(|path| self.document.written_value(path));
        let of_material =
            self.input.materials().iter().flat_map(BodyMaterial::known_values).find(|(path, _)| *path == key.path());
        let text = given.or(of_material.map(|(_, known)| known.value.text.as_str()))?;
        key.quantity().is_hardness.then(|| hardness::parse(text)).flatten().map(|(_, scale)| scale)
    }

    /// Refuses free keys and columns of the data that have no effect, and impacts without a speed or a mass.
    pub fn check_varied(
        &self,
        wanted: &CalibrationRequest,
        columns: &[NumericKey],
        is_of_impacts: bool,
    ) -> Result<(), Error> {
        let refuse = |path: &str, message: String| {
            let is_column = columns.iter().any(|key| key.path() == path);
            let (place, before) =
                if is_column { ("calibrate.data", format!("its column {path} ")) } else { (path, String::new()) };
            Err(self.refusal_where_varied(place, before + &message))
        };
        let mut input = wanted.input.clone();
        let free = wanted.free.iter().map(|free| (free.key, free.from));
        let axis = |(key, value): (NumericKey, f64)| {
            key.set_exclusive(&mut input, value);
            SweepAxis::from_numbers(key, AxisValues::List(vec![value]))
        };
        let axes = free.chain(columns.iter().map(|key| (*key, 1.0))).map(axis).collect();
        let plan = Plan::new(&input, Cases::Grid(axes));
        let paths = plan.varied_paths();
        if let Some(free) = wanted.free.iter().find(|free| columns.iter().any(|key| key.path() == free.key.path())) {
            return refuse(
                free.key.path(),
                "is both a fitted key and a column of the data. Remove one of the two.".to_owned(),
            );
        }
        let guide = wanted.input.forces().waveguide;
        for kind in [WaveguideKind::Plate, WaveguideKind::Rod] {
            let is_on_it = guide.is_some_and(|guide| guide.kind() == kind) || paths.contains(&kind.size_key());
            if is_on_it && !is_of_impacts {
                let message = "does not apply to an indentation curve, which is quasi-static. Remove this key.";
                return refuse(kind.size_key(), message.to_owned());
            }
        }
        // the speed of the data replaces the speed of the scenario
        let is_speed = |path: &str| path.starts_with("impact.");
        if let Some((path, problem)) = self.conflicting_axis(&paths).filter(|(path, _)| !is_speed(path)) {
            return refuse(path, problem);
        }
        if let Some((path, problem)) = plan.unused_axis() {
            return refuse(path, problem);
        }
        let has_speed = paths.iter().any(|path| is_speed(path));
        if is_of_impacts {
            self.require(
                &REQUIRED_KEYS[N_BODY_KEYS..if has_speed { REQUIRED_KEYS.len() - 1 } else { REQUIRED_KEYS.len() }],
            )
        } else {
            Ok(())
        }
    }
}

/// The range in which the strength or the hardness of a body is searched, if nothing else is given.
pub(super) fn strength_range(input: &Input, body: Body, path: &str) -> [f64; 2] {
    let material = input.material(body);
    let own = Some(material.youngs_modulus).filter(|modulus| modulus.is_finite());
    let modulus = own.unwrap_or(input.half_space().material.youngs_modulus);
    let strengths = STRENGTH_RANGE.map(|share| share * modulus);
    if path == body.hardness() {
        strengths.map(|strength| hardness_of_flow_stress(strength, &material))
    } else {
        strengths
    }
}

const NO_TABLE_TEXT: &str = "no measurements are given. Add [calibrate] with data = \"drops.csv\", name a CSV file, or give one value (such as --restitution 0.49).";
