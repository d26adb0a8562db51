//! Picture of the tangential restitution against the angle: measured, by the program, by the spring of DEM codes, and of a
//! rigid body.

use super::super::oblique::{FRICTION, alumina_on_glass, rebound};
use super::Picture;
use crate::error::Error;
use crate::impact::ImpactError;
use crate::impact::oblique::mindlin::Motion;
use crate::math::functions::sin_cos;
use crate::plot::{Axis, Chart, Series, Style};
use crate::reference::oblique::rebounds;

/// The flattest angle of the curves \[deg\].
const FLATTEST: u32 = 65;

pub(super) fn picture() -> Result<Picture, Error> {
    let measured = rebounds()?.into_iter().filter(|row| row.quantity == "tangential_restitution");
    let measured = Series::points("measured, alumina on glass", measured.map(|row| (row.angle, row.value)).collect());
    let contact = alumina_on_glass()?;
    let motion = Motion::elastic().map_err(ImpactError::from)?;
    let (chi, j) = (contact.chi(), contact.slip_factor());
    let mut curves = [Vec::new(), Vec::new(), Vec::new()];
    for step in 1..=4 * FLATTEST {
        let degrees = 0.25 * f64::from(step);
        let angle = degrees.to_radians();
        let Some(after) = rebound(&contact, angle, FRICTION)? else { continue };
        let (sin, cos) = sin_cos(angle);
        // s_0 = v_t, so that e_t = 1 + (s_1/s_0 - 1)/j
        let psi = 4.0 * contact.shear_ratio() * sin / cos / FRICTION;
        let sliding = 1.0 - 4.0 * chi / psi;
        let ratios = [-after.contact_point_restitution, motion.run_on_one_spring(psi, chi), sliding.max(0.0)];
        for (curve, ratio) in curves.iter_mut().zip(ratios) {
            curve.push((degrees, 1.0 + (ratio - 1.0) / j));
        }
    }
    let names = [
        "this program: Mindlin's contact",
        "one spring, as LAMMPS mindlin_rescale/force",
        "rigid body: slides, or rolls in the end",
    ];
    let mut series = vec![measured.styled(Style::BLACK)];
    series.extend(
        names.into_iter().zip(curves).enumerate().map(|(i, (name, curve))| Series::bare(name, curve).styled(i)),
    );
    let axes = [
        Axis::linear("Angle of impact from the normal", "deg"),
        Axis::linear("Tangential restitution v_t'/v_t", "").between(0.5, 1.0),
    ];
    Ok((
        "oblique-alumina-on-glass".to_owned(),
        Chart::new("Oblique rebound of alumina from glass, 3.9 m/s, friction 0.092", axes, series),
    ))
}
