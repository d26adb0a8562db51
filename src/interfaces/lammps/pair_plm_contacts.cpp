/* Answers of pair_style plm to LAMMPS between steps: histories, energies and laws of its contacts.
   SPDX-License-Identifier: GPL-2.0-or-later */

#include "pair_plm.h"

#include "atom.h"
#include "force.h"
#include "neigh_history.h"
#include "neigh_list.h"
#include "plm_history.h"
#include "plm_vectors.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace PLM::History;

/* Seen from the other sphere friction and rolled way turn; the normal part is the same. */
void PairPLM::transfer_history(double *source, double *target, int, int) {
    for (int k = 0; k < size; k++) target[k] = k < FRICTION ? source[k] : -source[k];
}

/* The history of a contact, which one of its spheres owns; nullptr if they do not touch. */
double *PairPLM::history_of(int i, int j) {
    const int owners[][2] = {{i, j}, {j, i}};
    for (int k = 0; k < 2; k++) {
        const int owner = owners[k][0];
        if (owner >= atom->nlocal) continue;
        for (int jj = 0; jj < list->numneigh[owner]; jj++)
            if ((list->firstneigh[owner][jj] & NEIGHMASK) == owners[k][1])
                return fix_history->firstflag[owner][jj] ? fix_history->firstvalue[owner] + size * jj : nullptr;
    }
    return nullptr;
}

/* The state of a contact with its plastic work, and its stored energy in units of LAMMPS. The history is not changed.
 */
double PairPLM::stored_energy_of(const PLM::Balls &balls, plm_history &state) {
    double stored = NAN;
    plm_contact_step(balls.contact, state.indentation, &state, 0.0, nullptr, nullptr, &stored);
    return stored * balls.per_energy;
}

/* For compute pair/local: stored energy, and force, overlap, dent depth, plastic work, size of the friction, radius of
   the contact's effective sphere. */
double PairPLM::single(int i, int j, int, int, double rsq, double, double, double &fforce) {
    std::fill_n(svector, single_extra, 0.0);
    fforce = 0.0;
    const double sum = atom->radius[i] + atom->radius[j];
    const double *history = rsq < sum * sum ? history_of(i, j) : nullptr;
    if (!history) return 0.0;
    const PLM::Balls &balls = balls_of(i, j);
    plm_history state = PLM::state_of(history);
    const double stored = stored_energy_of(balls, state);
    svector[0] = state.force * balls.per_force;
    svector[1] = state.indentation / balls.length;
    svector[2] = (state.memory[0] - state.memory[2]) / balls.length;
    svector[3] = state.plastic * balls.per_energy;
    if (friction >= 0.0) svector[4] = PLM::length(history + FRICTION) * balls.per_force;
    svector[5] = atom->radius[i] * atom->radius[j] / sum;
    fforce = svector[0] / sqrt(rsq);
    return stored;
}

double PairPLM::stored_energy() {
    double stored = 0.0;
    for (int ii = 0; ii < list->inum; ii++) {
        const int i = list->ilist[ii];
        for (int jj = 0; jj < list->numneigh[i]; jj++) {
            if (!fix_history->firstflag[i][jj]) continue;
            const int j = list->firstneigh[i][jj] & NEIGHMASK;
            const double share = force->newton_pair || j < atom->nlocal ? 1.0 : 0.5;
            plm_history state = PLM::state_of(fix_history->firstvalue[i] + size * jj);
            stored += share * stored_energy_of(balls_of(i, j), state);
        }
    }
    return stored;
}

double PairPLM::fingerprint() const {
    std::uint64_t mixed = size;
    for (int i = 1; i <= atom->ntypes; i++)
        for (int j = i; j <= atom->ntypes; j++)
            if (law[i][j]) mixed = mixed * 0x9e3779b97f4a7c15ULL + plm_contact_fingerprint(law[i][j]->scenario());
    return static_cast<double>(mixed >> 12);
}

double PairPLM::memory_usage() { return finder->memory_usage(); }
