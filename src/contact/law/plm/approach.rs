//! The polyline of the PLM that gives the elastic approach over the force.

/// The slopes and knots of the polyline, for a half-space of any strength.
#[derive(Debug, Clone, PartialEq)]
pub struct ApproachSlopes {
    /// Slope s from A = 1 on.
    pub(super) first: f64,
    /// A from which the contact is fully plastic, ≥ 1.
    pub(super) plastic_from: f64,
    pub(super) plastic: f64,
    /// Finite geometry: A a_Y/R from which a factor multiplies the slope that holds there, rising.
    pub(super) geometry: Vec<(f64, f64)>,
}

impl ApproachSlopes {
    /// The pieces for a half-space that yields at this a_Y/R, from (A, ε) = (1, 1) on. A knot of the finite geometry below A = 1
    /// applies from A = 1.
    fn pieces(&self, yield_radius_ratio: f64) -> impl Iterator<Item = ApproachSegment> {
        let mut geometry =
            self.geometry.iter().map(move |(from, factor)| (from / yield_radius_ratio, factor)).peekable();
        let (mut first, mut plastic) = (self.first, self.plastic);
        let (mut radius, mut approach, mut slope, mut next) = (1.0, 1.0, 0.0, 1.0);
        std::iter::from_fn(move || {
            if next == f64::INFINITY {
                return None;
            }
            approach += slope * (next - radius);
            while let Some((_, factor)) = geometry.next_if(|(from, _)| *from <= next) {
                first *= factor;
                plastic *= factor;
            }
            let is_plastic = next >= self.plastic_from;
            slope = if is_plastic { plastic } else { first };
            radius = next;
            let of_geometry = geometry.peek().map_or(f64::INFINITY, |(from, _)| *from);
            next = if is_plastic { of_geometry } else { of_geometry.min(self.plastic_from) };
            Some(ApproachSegment { force: radius * approach, slope, offset: approach - slope * radius })
        })
    }

    /// ε at force f ≥ 1 on the polyline of a half-space that yields at this a_Y/R. Nothing is allocated.
    pub fn approach(&self, force: f64, yield_radius_ratio: f64) -> f64 {
        let mut pieces = self.pieces(yield_radius_ratio);
        let first = pieces.next();
        let last = pieces.take_while(|piece| piece.force <= force).last();
        last.or(first).map_or(force, |piece| piece.approach(force))
    }
}

/// ε_line(f), made of pieces that are straight in A = f/ε.
#[derive(Debug, Clone, PartialEq)]
pub struct ApproachPolyline {
    pieces: Vec<ApproachSegment>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct ApproachSegment {
    /// Force at which it begins.
    force: f64,
    /// s.
    slope: f64,
    /// b = ε_i − s A_i.
    offset: f64,
}

impl ApproachSegment {
    /// ε at a force.
    #[inline]
    fn approach(&self, force: f64) -> f64 {
        let Self { slope, offset: b, .. } = *self;
        let root = (b * b + 4.0 * slope * force).sqrt();
        // (b + √)/2, in the form that does not cancel for b < 0
        if b >= 0.0 { 0.5 * (b + root) } else { 2.0 * slope * force / (root - b) }
    }
}

impl ApproachPolyline {
    /// The polyline for a half-space that yields at this a_Y/R.
    pub fn new(slopes: &ApproachSlopes, yield_radius_ratio: f64) -> Self {
        Self { pieces: slopes.pieces(yield_radius_ratio).collect() }
    }

    /// ε on the line at force f ≥ 1.
    #[inline]
    pub fn approach(&self, force: f64) -> f64 {
        // few pieces: a scan from the end beats a search
        let piece = self.pieces.iter().rev().find(|piece| piece.force <= force).or(self.pieces.first());
        piece.map_or(force, |piece| piece.approach(force))
    }

    /// ε as [`Self::approach`] gives it, for forces that lie near each other: it begins to look at the piece of the force before.
    pub(super) fn sequential_lookup(&self) -> impl FnMut(f64) -> f64 + '_ {
        let (pieces, mut place) = (&self.pieces, 0);
        move |force| {
            while place > 0 && pieces[place].force > force {
                place -= 1;
            }
            while pieces.get(place + 1).is_some_and(|next| next.force <= force) {
                place += 1;
            }
            pieces.get(place).map_or(force, |piece| piece.approach(force))
        }
    }
}
