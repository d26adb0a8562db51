//! Lanes of the stepper with drag, on straight and Hertz pieces.
//!
//! The steps are those of `dop853`. Steps that are accepted and pass no event are handled for all lanes at once; in all other
//! cases the [`Run`] of the lane decides, as it does for a single motion.

mod rows;

use pulp::Arch;

use super::{AllLanes, Ended, LANES, Lanes, Started, put};
use crate::integrate::damped::finish;
use crate::integrate::damped::run::{Limits, Progress, Run, Verdict, least_share};
use crate::integrate::piece::power::DraggedHertz;
use crate::integrate::piece::straight::DraggedStraight;
use crate::integrate::{Drag, Landing, Path, Restoring, State};
use rows::{Onward, Rows, Stepping};

/// Every so many steps all lanes run the code of a single motion, so that its step limit is checked.
const MOST_UNTOLD: u64 = 1024;

/// The piece of a lane.
#[derive(Debug, Clone, Copy)]
enum LanePiece<const M: u8> {
    Straight(DraggedStraight),
    Hertz(DraggedHertz<M>),
}

/// The lanes: m = 2 for drag of the force, m = 4 for drag of the stiffness.
#[derive(Debug, Clone)]
pub struct Damped<const M: u8> {
    rows: Box<Rows>,
    ways: Box<[Option<(Run, LanePiece<M>)>; LANES]>,
    tolerance: f64,
    least: f64,
    /// Steps of all lanes so far.
    steps: u64,
    arch: Arch,
}

impl<const M: u8> Damped<M> {
    /// Lanes of this relative tolerance, all idle.
    pub fn new(tolerance: f64) -> Self {
        let (rows, ways) = (Box::new(Rows::default()), Box::new([None; LANES]));
        Self { rows, ways, tolerance, least: least_share(tolerance), steps: 0, arch: Arch::new() }
    }

    /// Whether these are the lanes for this drag.
    pub fn fits(drag: Drag) -> bool {
        drag != Drag::NONE && (drag.eta == 0.0) == (M == 2)
    }

    /// Makes a lane idle.
    fn leave(&mut self, lane: usize) -> Option<(Run, LanePiece<M>)> {
        self.rows.marches[lane] = 0.0;
        self.ways[lane].take()
    }
}

impl<const M: u8> Lanes for Damped<M> {
    const FEW: usize = LANES / 8;

    fn start(&mut self, lane: usize, path: &Path, at: &mut State) -> Started {
        if !Self::fits(path.drag) {
            return Started::Foreign;
        }
        let rows = &mut *self.rows;
        let (run, piece, numbers, drag) = match path.restoring {
            Restoring::Straight { at_start: a, slope: b } => {
                let piece = DraggedStraight::along(a, b, path);
                let run = Run::begin(piece, path, at, self.tolerance);
                (run, LanePiece::Straight(piece), [a, b, 0.0, 1.0], piece.drag)
            }
            Restoring::Power { coefficient: k, exponent: 1.5 } => {
                let piece = DraggedHertz::<M>::along(k, path);
                let run = Run::begin(piece, path, at, self.tolerance);
                (run, LanePiece::Hertz(piece), [0.0, 0.0, k, 0.0], piece.drag)
            }
            Restoring::Power { .. } | Restoring::Smooth { .. } => return Started::Foreign,
        };
        let Some(run) = run else {
            at.speed = 0.0;
            return Started::Landed(Landing::Turning);
        };
        put(&mut rows.piece, lane, numbers);
        put(&mut rows.drag, lane, [drag.chi, drag.eta]);
        rows.pull[lane] = path.pull;
        rows.put(lane, &run);
        put(&mut rows.inverse_sizes, lane, run.inverse_sizes);
        let Limits { direction, end, lifts_off, rests } = run.limits();
        put(&mut rows.limits, lane, [direction, end, lifts_off, rests]);
        self.ways[lane] = Some((run, piece));
        Started::UnderWay
    }

    fn step(&mut self) -> bool {
        let rows = &mut *self.rows;
        self.arch.dispatch(AllLanes(Stepping::<M>(rows)));
        // the slow functions have loops of their own, so that the processor overlaps those of neighbouring lanes
        let mut marching = [0; LANES];
        let mut count = 0;
        for lane in 0..LANES {
            marching[count] = lane;
            count += usize::from(rows.marches[lane] > 0.0);
        }
        for lane in &marching[..count] {
            rows.error[*lane] = rows.step_of(*lane).error(rows.h[*lane], self.least);
        }
        for lane in &marching[..count] {
            rows.pace[*lane] = Verdict::pace(rows.error[*lane]);
        }
        self.steps += 1;
        if self.steps.is_multiple_of(MOST_UNTOLD) {
            rows.clear = [0.0; LANES];
        } else {
            self.arch.dispatch(AllLanes(Onward(rows)));
        }
        true
    }

    #[inline]
    fn take_landing(&mut self, lane: usize, _: &Path, at: &mut State) -> Option<Ended> {
        let rows = &mut *self.rows;
        if rows.clear[lane] > 0.0 {
            return None;
        }
        let (run, piece) = self.ways[lane].as_mut()?;
        rows.catch_up(lane, run);
        let next = rows.step_of(lane);
        let verdict = Verdict { error: rows.error[lane], pace: rows.pace[lane] };
        let told = match piece {
            LanePiece::Straight(piece) => run.tell(*piece, &next, verdict),
            LanePiece::Hertz(piece) => run.tell(*piece, &next, verdict),
        };
        let landed = match told {
            Ok(Progress::Again) => {
                rows.put_length(lane, run);
                return None;
            }
            Ok(Progress::Moved { .. }) => {
                rows.put(lane, run);
                return None;
            }
            Ok(Progress::Landed { landing, state, .. }) => {
                *at = state;
                Ok(landing)
            }
            Err(error) => Err(error),
        };
        self.leave(lane);
        Some(landed)
    }

    fn finish(&mut self, lane: usize, at: &mut State) -> Option<Ended> {
        let (mut run, piece) = self.leave(lane)?;
        self.rows.catch_up(lane, &mut run);
        let ended = match piece {
            LanePiece::Straight(piece) => finish(piece, &mut run, None),
            LanePiece::Hertz(piece) => finish(piece, &mut run, None),
        };
        Some(ended.map(|(landing, state)| {
            *at = state;
            landing
        }))
    }
}
