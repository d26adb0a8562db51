/* The history of a contact of pair_style plm, from step to step.
   SPDX-License-Identifier: GPL-2.0-or-later */

#ifndef LMP_PLM_HISTORY_H
#define LMP_PLM_HISTORY_H

#include "plm_impact.h"

namespace LAMMPS_NS {
namespace PLM {

/* Places in the history of a contact: the state of the law; the plastic work that fix plm/energy has counted; with
   friction the friction on the sphere that owns the contact; with rolling friction the rolled way. All are those of the
   contact of the scenario, but the rolled way. */
namespace History {
enum { TAKEN = sizeof(plm_history) / sizeof(double), FRICTION, ROLLED = FRICTION + 3 };

constexpr int size(bool has_friction, bool has_rolling) {
    return has_rolling ? ROLLED + 3 : has_friction ? static_cast<int>(ROLLED) : static_cast<int>(FRICTION);
}
} // namespace History

/* The state of the law, at the start of a history. */
inline plm_history &state_of(double *history) { return *reinterpret_cast<plm_history *>(history); }
inline const plm_history &state_of(const double *history) { return *reinterpret_cast<const plm_history *>(history); }

} // namespace PLM
} // namespace LAMMPS_NS

#endif
