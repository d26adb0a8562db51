/* The state of each sphere in fix plm/wall: energies, exchange between ranks, restart files.
   SPDX-License-Identifier: GPL-2.0-or-later */

#include "fix_plm_wall.h"

#include "atom.h"
#include "error.h"
#include "memory.h"
#include "plm_history.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

namespace {
// doubles of a sphere in a restart file before its state
constexpr int RESTART_HEADER = 2;
} // namespace

/* Radius of the sphere of the scenario over the radius of sphere i. */
double FixPLMWall::scale_of(int i) const { return laws[atom->type[i]].radius / atom->radius[i]; }

/* Divides an energy of the scenario's contact, to get the energy of a sphere of another radius in units of LAMMPS. */
double FixPLMWall::energy_scale(double scale) const { return scale * scale * scale * units.force * units.length; }

/* The sphere has left the surface: its plastic work is kept, and the next contact is a fresh one. */
void FixPLMWall::end_contact(int i, double *slot) {
    const double taken = PLM::state_of(slot + STATE).plastic / energy_scale(scale_of(i));
    state[i][ENDED] += taken;
    state[i][PLASTIC] += taken;
    std::fill_n(slot, slot_size, 0.0);
}

/* Energy stored in the contacts, and plastic work of the dents; then the force on the wall. */
double FixPLMWall::compute_scalar() { return compute_vector(0) + compute_vector(1); }

double FixPLMWall::compute_vector(int k) {
    double energy = k >= 2 ? load[k - 2] : 0.0, all;
    for (int i = 0; i < atom->nlocal && k < 2; i++) {
        if (!(atom->mask[i] & groupbit)) continue;
        if (k == 1) energy += state[i][PLASTIC];
        for (int w = 0; w < walls && k == 0; w++) {
            const double *slot = state[i] + FIRST_SLOT + slot_size * w;
            if (slot[WALL] == 0.0) continue;
            plm_history contact = PLM::state_of(slot + STATE);
            double stored = NAN;
            plm_contact_step(laws[atom->type[i]].contact, contact.indentation, &contact, 0.0, nullptr, nullptr,
                             &stored);
            energy += stored / energy_scale(scale_of(i));
        }
    }
    MPI_Allreduce(&energy, &all, 1, MPI_DOUBLE, MPI_SUM, world);
    return all;
}

double FixPLMWall::memory_usage() { return (double)atom->nmax * values * sizeof(double); }

void FixPLMWall::grow_arrays(int nmax) {
    memory->grow(state, nmax, values, "plm/wall:state");
    array_atom = state;
}

void FixPLMWall::copy_arrays(int i, int j, int /*delflag*/) { std::copy_n(state[i], values, state[j]); }

void FixPLMWall::set_arrays(int i) { std::fill_n(state[i], values, 0.0); }

int FixPLMWall::pack_exchange(int i, double *buffer) {
    std::copy_n(state[i], values, buffer);
    return values;
}

int FixPLMWall::unpack_exchange(int i, double *buffer) {
    std::copy_n(buffer, values, state[i]);
    return values;
}

/* In a restart file the number of doubles comes first, then the fingerprint of the contact that the memories belong to.
 */
int FixPLMWall::pack_restart(int i, double *buffer) {
    buffer[0] = values + RESTART_HEADER;
    buffer[1] = laws[atom->type[i]].fingerprint;
    std::copy_n(state[i], values, buffer + RESTART_HEADER);
    return values + RESTART_HEADER;
}

void FixPLMWall::unpack_restart(int i, int nth) {
    const double *record = PLM::restart_record(atom->extra[i], nth);
    if (static_cast<int>(record[0]) != values + RESTART_HEADER)
        error->one(FLERR, "Fix plm/wall: the restart file was written with another wall, with or without friction, or "
                          "by an older version; give "
                          "this fix another ID to begin with fresh contacts");
    if (record[1] != laws[atom->type[i]].fingerprint)
        error->one(FLERR,
                   "Fix plm/wall: the restart file was written with another scenario for atoms of type {}, and the "
                   "dents in it belong to that "
                   "one; use its file, or give this fix another ID to begin with fresh contacts",
                   atom->type[i]);
    std::copy_n(record + RESTART_HEADER, values, state[i]);
}

int FixPLMWall::size_restart(int /*i*/) { return values + RESTART_HEADER; }

int FixPLMWall::maxsize_restart() { return values + RESTART_HEADER; }
