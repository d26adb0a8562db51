//! The crate `ode_solvers` (Dormand-Prince 5(4) and 8(5,3)) behind [`Integrator`].
//!
//! That crate stops *after* the accepted step that passed an event. The step is discarded, and the motion from the state
//! before it to the event is integrated again. Without pull and drag this is done with another independent variable
//! (`henon`), with them to the time of the event (`newton`).
//!
//! The crate takes one absolute tolerance for all components, so it is given variables of size one. In release 0.6.2 the
//! twelfth node of Dop853 is 0 instead of 1 (found here: the row sums of its tableau are right, and with an explicit
//! independent variable the order drops to 3), so nothing here depends on the independent variable explicitly.

mod driver;
mod henon;
mod newton;

use super::{Drag, IntegrationError, Integrator, Landing, Path, Sampler, State, Work};
use driver::Node;
pub use driver::{Library, Scheme};

impl Integrator for Library {
    fn traverse(
        &mut self,
        path: &Path,
        state: &mut State,
        samples: Option<&mut Sampler>,
    ) -> Result<Landing, IntegrationError> {
        self.taken_before_leg = self.work.steps + self.work.rejected;
        let super::Sizes { distance, speed } = path.sizes;
        let unit_of_time = distance / speed;
        let begun = *state;
        let absolute = |[t, d, u, loss]: Node| State {
            time: begun.time + t * unit_of_time,
            distance: d * distance,
            speed: u * speed,
            loss: loss * speed * speed,
        };
        let start = [0.0, begun.distance / distance, begun.speed / speed, begun.loss / (speed * speed)];
        let is_free = path.pull == 0.0 && path.drag == Drag::NONE;
        // the nodes of all steps before the end, and the end
        let (nodes, landing, end) =
            if is_free { henon::run(self, path, start)? } else { newton::run(self, path, start)? };
        *state = absolute(end);
        state.distance = path.landed_at(landing, state.distance);
        if let Some(samples) = samples {
            while let Some(time) = samples.due_before(state.time) {
                let t = (time - begun.time) / unit_of_time;
                let node = nodes[nodes.partition_point(|node| node[0] <= t).saturating_sub(1)];
                let at =
                    if is_free { henon::after(self, path, node, t)? } else { self.after(path, node, t - node[0])? };
                samples.take(State { time, ..absolute(at) });
            }
        }
        Ok(landing)
    }

    fn work(&self) -> Work {
        self.work
    }
}
