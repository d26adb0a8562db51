//! The polyline of the PLM that gives the elastic approach over the force.

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

impl ElasticLine {
    /// From (A, ε) = (1, 1) on, with a new slope at each A; the A must rise.
    pub(super) fn through(knots: impl Iterator<Item = (f64, f64)>) -> Self {
        let mut pieces: Vec<LinePiece> = Vec::with_capacity(4);
        let (mut radius, mut approach, mut slope) = (1.0, 1.0, 0.0);
        for (next, next_slope) in knots {
            approach += slope * (next - radius);
            (radius, slope) = (next, next_slope);
            pieces.push(LinePiece { force: radius * approach, slope, offset: approach - slope * radius });
        }
        Self { pieces }
    }

    /// ε on the line at force f ≥ 1.
    #[inline]
    #[must_use]
    pub fn at(&self, force: f64) -> f64 {
        // few pieces: a scan from the end beats a search
        let piece = self.pieces.iter().rev().find(|piece| piece.force <= force).or(self.pieces.first());
        piece.map_or(force, |LinePiece { slope, offset: b, .. }| {
            let root = (b * b + 4.0 * slope * force).sqrt();
            // (b + √)/2, in the form that does not cancel for b < 0
            if *b >= 0.0 { 0.5 * (b + root) } else { 2.0 * slope * force / (root - b) }
        })
    }
}
