//! Contour lines of a quantity on a grid: by marching squares, with linear interpolation along the edges of the cells.

/// The lines on which the value (of column, row) is `level`: pairs of points, with a point of NaN behind each pair. A cell with a corner
/// that is not finite has no line.
pub fn contour([columns, rows]: [&[f64]; 2], value: impl Fn(usize, usize) -> f64, level: f64) -> Vec<(f64, f64)> {
    let mut points = Vec::new();
    for row in 1..rows.len() {
        for column in 1..columns.len() {
            let corner = |c: usize, r: usize| (columns[c], rows[r], value(c, r) - level);
            let corners =
                [corner(column - 1, row - 1), corner(column, row - 1), corner(column, row), corner(column - 1, row)];
            let mut crossings = Vec::new();
            for edge in 0..4 {
                let ((x, y, from), (x_to, y_to, to)) = (corners[edge], corners[(edge + 1) % 4]);
                if from.is_finite() && to.is_finite() && (from < 0.0) != (to < 0.0) {
                    let share = from / (from - to);
                    crossings.push((x + share * (x_to - x), y + share * (y_to - y)));
                }
            }
            // at a saddle, two lines
            for pair in crossings.chunks_exact(2) {
                points.extend([pair[0], pair[1], (f64::NAN, f64::NAN)]);
            }
        }
    }
    points
}

/// At most `most` round numbers between two positive ends.
pub fn round_levels(low: f64, high: f64, most: usize) -> Vec<f64> {
    const STEPS: [&[f64]; 3] = [&[1.0, 1.5, 2.0, 3.0, 5.0, 7.0], &[1.0, 2.0, 5.0], &[1.0]];
    if !(low > 0.0 && low < high && high.is_finite()) {
        return Vec::new();
    }
    let level = |step: &f64, power: i32| format!("{step}e{power}").parse::<f64>().unwrap_or(f64::NAN);
    let levels = |steps: &[f64]| -> Vec<f64> {
        let all = (-30..=30).flat_map(|power| steps.iter().map(move |step| level(step, power)));
        all.filter(|level| (low..=high).contains(level)).collect()
    };
    STEPS.iter().map(|steps| levels(steps)).find(|levels| levels.len() <= most).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::functions::hypot;

    /// The contour of x² + y² at 1 is a circle, within the error of linear interpolation on cells of 0.1.
    #[test]
    fn contour_of_paraboloid_is_circle() {
        let axis: Vec<f64> = (0..=20).map(|i| f64::from(i) * 0.1).collect();
        let points = contour([&axis, &axis], |c, r| axis[c] * axis[c] + axis[r] * axis[r], 1.0);
        let drawn: Vec<_> = points.iter().filter(|point| point.0.is_finite()).collect();
        assert!(drawn.len() > 20);
        assert!(drawn.iter().all(|(x, y)| (hypot(*x, *y) - 1.0).abs() < 2e-3), "{drawn:?}");
    }

    #[test]
    fn levels_are_round_and_few() {
        assert_eq!(round_levels(0.11, 0.6, 7), [0.15, 0.2, 0.3, 0.5]);
        assert_eq!(round_levels(1e7, 4e8, 6), [1e7, 2e7, 5e7, 1e8, 2e8]);
        assert!(round_levels(f64::NAN, 1.0, 6).is_empty());
    }
}
