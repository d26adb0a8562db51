//! The polyline of the PLM that gives the elastic approach over the force.

/// What the polyline is made of, for a half-space of any strength.
#[derive(Debug, Clone, PartialEq)]
pub struct LineSlopes {
    /// Slope s from A = 1 on.
    pub(super) first: f64,
    /// A from which the contact is fully plastic, ≥ 1.
    pub(super) plastic_from: f64,
    /// Slope from there on.
    pub(super) plastic: f64,
    /// Finite geometry: A a_Y/R from which a factor multiplies the slope that holds there.
    pub(super) geometry: Vec<(f64, f64)>,
}

impl LineSlopes {
    /// The pieces for a half-space that yields at this a_Y/R, from (A, ε) = (1, 1) on.
    fn pieces(&self, yield_radius_ratio: f64) -> impl Iterator<Item = LinePiece> {
        // a knot below A = 1 applies from A = 1
        let geometry =
            move || self.geometry.iter().map(move |(from, factor)| ((from / yield_radius_ratio).max(1.0), *factor));
        let next_knot = move |radius: &f64| {
            let knots = geometry().map(|(from, _)| from).chain([self.plastic_from]);
            knots.filter(|knot| knot > radius).min_by(f64::total_cmp)
        };
        let (mut radius, mut approach, mut slope) = (1.0, 1.0, 0.0);
        std::iter::successors(Some(1.0), next_knot).map(move |next| {
            approach += slope * (next - radius);
            let base = if next >= self.plastic_from { self.plastic } else { self.first };
            slope = geometry().filter(|(from, _)| *from <= next).fold(base, |slope, (_, factor)| slope * factor);
            radius = next;
            LinePiece { force: radius * approach, slope, offset: approach - slope * radius }
        })
    }

    /// ε at force f ≥ 1 on the polyline of a half-space that yields at this a_Y/R, without making the polyline.
    pub fn approach(&self, force: f64, yield_radius_ratio: f64) -> f64 {
        let mut pieces = self.pieces(yield_radius_ratio);
        let first = pieces.next();
        let last = pieces.take_while(|piece| piece.force <= force).last();
        last.or(first).map_or(force, |piece| piece.approach(force))
    }
}

/// ε_line(f), made of pieces that are straight in A = f/ε.
#[derive(Debug, Clone, PartialEq)]
pub struct ElasticLine {
    pieces: Vec<LinePiece>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct LinePiece {
    /// Force at which it begins.
    force: f64,
    /// s.
    slope: f64,
    /// b = ε_i − s A_i.
    offset: f64,
}

impl LinePiece {
    /// ε at a force.
    #[inline]
    fn approach(&self, force: f64) -> f64 {
        let Self { slope, offset: b, .. } = *self;
        let root = (b * b + 4.0 * slope * force).sqrt();
        // (b + √)/2, in the form that does not cancel for b < 0
        if b >= 0.0 { 0.5 * (b + root) } else { 2.0 * slope * force / (root - b) }
    }
}

impl ElasticLine {
    /// The polyline for a half-space that yields at this a_Y/R.
    pub fn new(slopes: &LineSlopes, yield_radius_ratio: f64) -> Self {
        Self { pieces: slopes.pieces(yield_radius_ratio).collect() }
    }

    /// ε on the line at force f ≥ 1.
    #[inline]
    pub fn at(&self, force: f64) -> f64 {
        // few pieces: a scan from the end beats a search
        let piece = self.pieces.iter().rev().find(|piece| piece.force <= force).or(self.pieces.first());
        piece.map_or(force, |piece| piece.approach(force))
    }
}
