//! Finite-element results that pictures and comparisons show beside the laws: the five material cases of Xie et al. (2024),
//! computed by this project. Only numbers: whoever asks compares.

use std::sync::LazyLock;

use crate::law::Bodies;

/// A full unloading of a finite-element run, quasi-static, in units of the yield point.
#[derive(Debug, Clone, PartialEq)]
pub struct Unloaded {
    /// Which material case.
    pub case: &'static str,
    /// E_s, E_h, σ_Y \[Pa\]; ν is 0.3.
    pub materials: [f64; 3],
    /// x_m.
    pub indentation: f64,
    /// f_m.
    pub force: f64,
    /// a_m/a_Y.
    pub contact_radius: f64,
    /// δ_s/δ at the peak.
    pub sphere_share: f64,
    /// δ_r/δ_m.
    pub residual_share: f64,
    /// W/(F_Y δ_Y).
    pub spent: f64,
    /// √(recovered/spent work).
    pub restitution: f64,
}

/// An unloading curve, from its peak to the residual indentation.
#[derive(Debug, Clone, PartialEq)]
pub struct UnloadingCurve {
    /// x_m.
    pub peak: f64,
    /// (x, f), the peak first.
    pub points: Vec<(f64, f64)>,
}

static UNLOADED: LazyLock<Vec<Unloaded>> = LazyLock::new(|| {
    rows(include_str!("../tests/reference/fe_quasi_static.csv")).filter_map(|fields| unloaded(&fields)).collect()
});

static CURVES: LazyLock<Vec<UnloadingCurve>> = LazyLock::new(|| {
    let mut curves: Vec<UnloadingCurve> = Vec::new();
    for fields in rows(include_str!("../tests/reference/fe_figure_10.csv")) {
        let [peak, _, x, f] = fields[..] else { continue };
        let [Ok(peak), Ok(x), Ok(f)] = [peak, x, f].map(str::parse::<f64>) else { continue };
        match curves.last_mut() {
            Some(curve) if curve.peak == peak => curve.points.push((x, f)),
            _ => curves.push(UnloadingCurve { peak, points: vec![(x, f)] }),
        }
    }
    curves
});

/// The rows behind comments and header.
fn rows(text: &'static str) -> impl Iterator<Item = Vec<&'static str>> {
    text.lines().filter(|line| !line.starts_with('#')).skip(1).map(|line| line.split(',').collect())
}

fn unloaded(fields: &[&'static str]) -> Option<Unloaded> {
    let (case, rest) = fields.split_first()?;
    let numbers: Vec<f64> = rest.iter().filter_map(|field| field.parse().ok()).collect();
    let [
        sphere,
        half_space,
        strength,
        indentation,
        force,
        contact_radius,
        sphere_share,
        residual_share,
        spent,
        restitution,
    ] = numbers[..]
    else {
        return None;
    };
    let materials = [sphere, half_space, strength];
    let case = *case;
    Some(Unloaded {
        case,
        materials,
        indentation,
        force,
        contact_radius,
        sphere_share,
        residual_share,
        spent,
        restitution,
    })
}

/// The unloadings of the case that has these materials, by rising depth; none for others. Quasi-static results in units of
/// the yield point know no radius.
#[must_use]
pub fn unloadings(sphere_modulus: f64, bodies: &Bodies) -> Vec<&'static Unloaded> {
    let materials = [sphere_modulus, half_space_modulus(bodies), bodies.yield_strength];
    let is_near = |(a, b): (f64, f64)| (a / b - 1.0).abs() < 1e-6;
    let has_materials = |row: &&Unloaded| row.materials.into_iter().zip(materials).all(is_near);
    let mut rows: Vec<_> = UNLOADED.iter().filter(has_materials).collect();
    if (bodies.poissons_ratio - 0.3).abs() > 1e-9 {
        rows.clear();
    }
    rows.sort_by(|a, b| a.indentation.total_cmp(&b.indentation));
    rows
}

/// E_h from E_h* = E*/ρ_E.
fn half_space_modulus(bodies: &Bodies) -> f64 {
    let nu = bodies.poissons_ratio;
    bodies.pair.effective_modulus / bodies.pair.half_space_compliance * (1.0 - nu * nu)
}

/// The unloading curve of case 3 whose peak is within 1 % of this depth.
#[must_use]
pub fn unloading_curve(sphere_modulus: f64, bodies: &Bodies, indentation: f64) -> Option<&'static UnloadingCurve> {
    if unloadings(sphere_modulus, bodies).first()?.case != "case3" {
        return None;
    }
    CURVES.iter().find(|curve| (curve.peak / indentation - 1.0).abs() < 0.01)
}
