//! The tangential displacement of the springs of an MDR contact, as a polyline over η = ξ².
//!
//! The springs are at 0 < ξ < α. Their stops are straight lines in η. A spring that enters at the rim has the displacement since its
//! entry, which is a smooth curve in η. So the displacement is a list of pieces, straight ones along the stops and curved ones
//! where springs entered, and nothing is sampled in space:
//!
//! ```text
//! stop      |ζ| ≤ P (1 − η/α²),   P = (3/2) f/α
//! stuck     every ζ grows by the same shift
//! friction  T = −∫₀^α ζ dξ
//! ```

/// The values of the normal motion that friction needs, at one time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct NormalState {
    /// τ.
    pub(super) time: f64,
    /// α²: η of the rim.
    pub(super) square: f64,
    /// P: the stop of the spring in the middle.
    pub(super) coulomb_limit: f64,
    /// The impulse of the contact force so far.
    pub(super) impulse: f64,
}

impl NormalState {
    /// f: the contact force.
    pub(super) fn force(&self) -> f64 {
        self.coulomb_limit * self.square.sqrt() / 1.5
    }
}

/// A knot behind a knot beyond the stop lies on the stop within rounding if it is nearer to the stop than this fraction of it.
const ROUNDING: f64 = 1e-13;

/// Capacity for most profiles.
const INITIAL_CAPACITY: usize = 32;

/// The end of a piece of the displacement. The piece begins at the knot before:
/// `ζ = straight line + bend (η − η_before)(η − η_here)`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
struct Knot {
    square: f64,
    /// ξ.
    radius: f64,
    /// ζ minus the shift of all springs.
    stretch: f64,
    /// Half of d²ζ/dη² on the piece.
    bend: f64,
    /// The integral of `stretch` over ξ from the middle.
    integral: f64,
}

/// ζ over η, from the middle to the rim.
#[derive(Debug, PartialEq)]
pub(super) struct SpringProfile {
    knots: Vec<Knot>,
    /// The shift of all springs so far. Springs that stick keep their knots.
    pub(super) shift: f64,
    /// The ranges of η in which springs slip to either side, at their stops.
    slip_annuli: [Option<[f64; 2]>; 2],
    /// How many knots are joined already.
    merged: usize,
    /// Memory for the knots that are clipped.
    spare: Vec<Knot>,
}

impl Clone for SpringProfile {
    fn clone(&self) -> Self {
        let mut same = Self::new();
        same.clone_from(self);
        same
    }

    /// Copies the knots into the existing memory.
    fn clone_from(&mut self, from: &Self) {
        self.knots.clone_from(&from.knots);
        (self.shift, self.slip_annuli, self.merged) = (from.shift, from.slip_annuli, from.merged);
    }
}

impl SpringProfile {
    /// A contact of one point, before first contact.
    pub(super) fn new() -> Self {
        let mut knots = Vec::with_capacity(INITIAL_CAPACITY);
        knots.push(Knot::default());
        Self { knots, shift: 0.0, slip_annuli: [None; 2], merged: 0, spare: Vec::with_capacity(INITIAL_CAPACITY) }
    }

    /// The side that all springs slip to, if they are at their stops.
    pub(super) fn slip_side(&self, stop: f64) -> Option<f64> {
        let [middle, rim] = self.knots[..] else { return None };
        let stretch = middle.stretch + self.shift;
        let is_at_stop = rim.bend == 0.0 && stretch.abs() >= stop * (1.0 - ROUNDING);
        is_at_stop.then(|| stretch.signum())
    }

    /// All springs are at their stops on this side.
    pub(super) fn slide(&mut self, rim: &NormalState, side: f64) {
        self.knots.truncate(1);
        self.shift = 0.0;
        self.knots[0].stretch = side * rim.coulomb_limit;
        self.push(rim.square, 0.0, 0.0);
        let ring = Some([0.0, rim.square]);
        self.slip_annuli = if side > 0.0 { [ring, None] } else { [None, ring] };
    }

    /// The displacement of the spring in the middle, minus the shift.
    pub(super) fn central_stretch(&self) -> f64 {
        self.knots.first().map_or(0.0, |knot| knot.stretch)
    }

    /// Shifts all springs, adds or removes springs up to the new rim, clips the springs at their stops, and returns the friction T.
    /// `bend` is the curvature of the displacement of the springs that enter. `fronts` are the η at which the springs at either stop
    /// have the speed of their stop at the end of the step.
    pub(super) fn advance(&mut self, [from, to]: [&NormalState; 2], shift: f64, bend: f64, fronts: [f64; 2]) -> f64 {
        self.shift += shift;
        let rim = to.square;
        if self.knots.last().is_some_and(|last| last.square < rim) {
            self.push(rim, -self.shift, bend);
        } else {
            self.truncate(rim);
        }
        let rings = std::mem::take(&mut self.slip_annuli);
        if rim <= 0.0 {
            return 0.0;
        }
        let fall = to.coulomb_limit / rim;
        let (level, moved) = (to.coulomb_limit, self.shift);
        let is_beyond = |knot: &Knot| (knot.stretch + moved).abs() > level * (1.0 + ROUNDING) - fall * knot.square;
        if let Some(first) = self.knots.iter().position(is_beyond) {
            let (side, from) = ((self.knots[first].stretch + moved).signum(), first.saturating_sub(1));
            self.clip(from, level, fall, side);
            let is_beyond =
                |knot: &Knot| -side * (knot.stretch + moved) > level * (1.0 + ROUNDING) - fall * knot.square;
            if self.knots[from..].iter().any(is_beyond) {
                self.clip(from, level, fall, -side);
            }
        }
        for (i, side) in [1.0, -1.0].into_iter().enumerate() {
            if let (Some(ring), true) = (rings[i], from.square > 0.0) {
                let more = fall - from.coulomb_limit / from.square;
                let corner = (to.coulomb_limit - from.coulomb_limit - side * shift) / more;
                let bend = 0.25 * more / (corner - fronts[i]);
                let [inner, outer] = ring;
                let width = outer - inner;
                if bend < 0.0 && fronts[i] > inner - width && fronts[i] < outer + width {
                    self.smooth_stick_slip_edge(i, ring, [corner, fronts[i]], bend, [level, fall]);
                }
            }
        }
        self.knots.last().map_or(0.0, |last| -(last.integral + self.shift * last.radius))
    }

    /// Rounds the corner of the displacement between springs that stick and springs that slip, if the front between them has moved
    /// over springs of this ring.
    fn smooth_stick_slip_edge(
        &mut self,
        i: usize,
        ring: [f64; 2],
        [corner, front]: [f64; 2],
        bend: f64,
        [level, fall]: [f64; 2],
    ) {
        let side = [1.0, -1.0][i];
        let width = (front - corner).abs();
        let rim = self.knots.last().map_or(0.0, |last| last.square);
        let (start, end) = ((corner - width).max(ring[0]), (corner + width).min(ring[1]).min(rim));
        if start >= end {
            return;
        }
        let envelope = |square: f64| {
            let beyond = square - front;
            side * (level - fall * square + bend * beyond * beyond) - self.shift
        };
        let (at_start, at_end) = (envelope(start), envelope(end));
        let place = self.knots.partition_point(|knot| knot.square < start);
        let mut old = std::mem::take(&mut self.spare);
        old.clear();
        old.extend(self.knots.drain(place..));
        self.push(start, at_start, old.first().map_or(0.0, |knot| knot.bend));
        self.push(end, at_end, side * bend);
        for knot in old.iter().filter(|knot| knot.square > end) {
            self.push_at(knot.square, knot.radius, knot.stretch, knot.bend);
        }
        self.spare = old;
        if let Some(ring) = &mut self.slip_annuli[i] {
            if front > corner { ring[0] = ring[0].max(end) } else { ring[1] = ring[1].min(start) }
        }
    }

    /// Adds a piece at the outer end.
    fn push(&mut self, square: f64, stretch: f64, bend: f64) {
        let radius = square.max(0.0).sqrt();
        self.push_at(square, radius, stretch, bend);
    }

    fn push_at(&mut self, square: f64, radius: f64, stretch: f64, bend: f64) {
        let integral = self.knots.last().map_or(0.0, |from| {
            let (a, b, ab) = (from.square, square, from.radius * radius);
            let way = radius - from.radius;
            // the mean of η over the piece less a, over b − a
            let weight = (radius + from.radius + from.radius) / (3.0 * (radius + from.radius));
            let straight = from.stretch + (stretch - from.stretch) * if b > 0.0 { weight } else { 0.5 };
            let curved = if bend == 0.0 {
                0.0
            } else {
                let mean_of_squares = (b * (b + ab + a) + a * (ab + a)) / 5.0;
                bend * (mean_of_squares - (a + b) * (a + ab + b) / 3.0 + a * b)
            };
            from.integral + way * (straight + curved)
        });
        self.knots.push(Knot { square, radius, stretch, bend, integral });
    }

    /// Joins pieces that one parabola represents to this accuracy.
    pub(super) fn merge_pieces(&mut self, accuracy: f64) {
        let mut old = std::mem::take(&mut self.spare);
        old.clear();
        old.extend(self.knots.drain(self.merged.min(self.knots.len())..));
        for knot in &old {
            if let [.., before, middle] = self.knots[..] {
                let (first, second) = (middle.square - before.square, knot.square - middle.square);
                let kink = (knot.stretch - middle.stretch) / second - (middle.stretch - before.stretch) / first;
                let bend = kink / (first + second);
                let off =
                    ((bend - middle.bend) * first * first).abs().max(((bend - knot.bend) * second * second).abs());
                if off <= 4.0 * accuracy {
                    self.knots.pop();
                    self.push_at(knot.square, knot.radius, knot.stretch, bend);
                    continue;
                }
            }
            self.push_at(knot.square, knot.radius, knot.stretch, knot.bend);
        }
        self.spare = old;
        self.merged = self.knots.len();
    }

    /// Removes the part outside of the rim.
    fn truncate(&mut self, rim: f64) {
        while self.knots.len() > 1 && self.knots[self.knots.len() - 2].square >= rim {
            self.knots.pop();
        }
        if let [.., before, last] = self.knots[..] {
            let (from, to) = (rim - before.square, rim - last.square);
            let slope = (last.stretch - before.stretch) / (last.square - before.square);
            self.knots.pop();
            self.push(rim, before.stretch + (slope + last.bend * to) * from, last.bend);
        }
    }

    /// Limits ζ (or −ζ) to `stop − fall η` from this knot on. Pieces that lie on the stop become one.
    fn clip(&mut self, from: usize, stop: f64, fall: f64, side: f64) {
        let shift = self.shift;
        let gap = |knot: &Knot| stop - fall * knot.square - side * (knot.stretch + shift);
        let on_stop = |square: f64| side * (stop - fall * square) - shift;
        let mut old = std::mem::take(&mut self.spare);
        old.clear();
        old.extend(self.knots.drain(from..));
        // the knot before and its gap
        let mut last: Option<(Knot, f64)> = None;
        let mut ring = [0.0; 2];
        for (i, &knot) in old.iter().enumerate() {
            let here = gap(&knot);
            let was_beyond = last.is_some_and(|(_, gap)| gap < 0.0);
            let is_beyond = here < if was_beyond { ROUNDING * stop } else { -ROUNDING * stop };
            let mut edge = knot.square;
            if let Some((before, there)) = last.filter(|_| was_beyond != is_beyond) {
                let square = gap_zero(&before, &knot, [there, here], -side);
                edge = square;
                if before.square < square && square < knot.square {
                    self.push(square, on_stop(square), if was_beyond { 0.0 } else { knot.bend });
                }
            }
            if let Some((before, _)) = last.filter(|_| !was_beyond && !is_beyond) {
                // the piece has not changed
                let moved = self.knots.last().map_or(0.0, |last| last.integral - before.integral);
                self.knots.push(Knot { integral: knot.integral + moved, ..knot });
            } else if !is_beyond {
                self.push_at(knot.square, knot.radius, knot.stretch, knot.bend);
            } else if !was_beyond || old.get(i + 1).is_none_or(|next| gap(next) >= ROUNDING * stop) {
                // a knot between two others beyond the stop is no end of a piece
                self.push_at(knot.square, knot.radius, on_stop(knot.square), 0.0);
            }
            if is_beyond && !was_beyond {
                ring = [edge, knot.square];
            } else if is_beyond || was_beyond {
                ring[1] = edge;
            }
            last = Some((knot, if is_beyond { here.min(-f64::MIN_POSITIVE) } else { here }));
        }
        self.spare = old;
        self.slip_annuli[usize::from(side < 0.0)] = Some(ring);
    }
}

/// Where the gap of the piece that ends at `to` vanishes, in η. It has one sign at either end; `sign` is that of ζ in the gap.
fn gap_zero(from: &Knot, to: &Knot, [there, here]: [f64; 2], sign: f64) -> f64 {
    let width = to.square - from.square;
    let straight = there / (there - here);
    let bend = sign * to.bend * width * width;
    let mut z = straight;
    if bend != 0.0 {
        for _ in 0..2 {
            let gap = there + (here - there) * z + bend * z * (z - 1.0);
            z -= gap / (here - there + bend * (2.0 * z - 1.0));
        }
    }
    from.square + width * if z > 0.0 && z < 1.0 { z } else { straight }
}
