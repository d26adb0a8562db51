/* fix plm/energy: where the energy of the contacts of pair_style plm is.
   SPDX-License-Identifier: GPL-2.0-or-later */

#include "fix_plm_energy.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "force.h"
#include "memory.h"
#include "pair_plm.h"
#include "plm_common.h"

#include <algorithm>
#include <cstring>

using namespace LAMMPS_NS;
using namespace FixConst;

namespace {
enum { OF_DENT, OF_RUBBING, COLUMNS };
// doubles of a sphere in a restart file before its work
constexpr int RESTART_HEADER = 1;
} // namespace

FixPLMEnergy::FixPLMEnergy(LAMMPS *lmp, int narg, char **arg)
    : Fix(lmp, narg, arg), pair(nullptr), done{0.0, 0.0, 0.0}, of_restart(0.0), work(nullptr) {
    if (narg != 3) error->all(FLERR, "expected: fix ID all plm/energy");
    scalar_flag = vector_flag = 1;
    size_vector = 1 + WORKS;
    extscalar = extvector = 1;
    global_freq = 1;
    peratom_flag = 1;
    size_peratom_cols = COLUMNS;
    peratom_freq = 1;
    restart_global = restart_peratom = 1;
    create_attribute = 1;
    comm_reverse = maxexchange = COLUMNS;

    FixPLMEnergy::grow_arrays(atom->nmax);
    atom->add_callback(Atom::GROW);
    atom->add_callback(Atom::RESTART);
    for (int i = 0; i < atom->nlocal; i++) FixPLMEnergy::set_arrays(i);
}

FixPLMEnergy::~FixPLMEnergy() {
    if (pair) pair->account = nullptr;
    atom->delete_callback(id, Atom::GROW);
    atom->delete_callback(id, Atom::RESTART);
    memory->destroy(work);
}

int FixPLMEnergy::setmask() { return PRE_FORCE | POST_FORCE; }

void FixPLMEnergy::init() {
    pair = dynamic_cast<PairPLM *>(force->pair_match("^plm$", 0));
    if (!pair) error->all(FLERR, "Fix plm/energy counts the energy of pair_style plm, which is not there");
    if (pair->account && pair->account != this) error->all(FLERR, "Fix plm/energy: there is another fix plm/energy");
    pair->account = this;
    if (of_restart != 0.0 && of_restart != pair->fingerprint())
        error->all(FLERR,
                   "Fix plm/energy: the restart file was written with other scenarios of pair_style plm, or with or "
                   "without friction or rolling, and the dents in it belong to those; use them, or give this "
                   "fix another ID");
}

void FixPLMEnergy::forget(const PairPLM *gone) {
    if (pair == gone) pair = nullptr;
}

void FixPLMEnergy::setup_pre_force(int vflag) { pre_force(vflag); }

/* What ghost atoms get in this step is sent to their owners after it. */
void FixPLMEnergy::pre_force(int) {
    for (int i = atom->nlocal; i < atom->nlocal + atom->nghost; i++) std::fill_n(work[i], COLUMNS, 0.0);
}

void FixPLMEnergy::setup(int vflag) { post_force(vflag); }

void FixPLMEnergy::post_force(int) {
    if (force->newton_pair) comm->reverse_comm(this);
}

void FixPLMEnergy::add(Work kind, double share, double energy, int i, int j) {
    done[kind] += share * energy;
    const int column = kind == PLASTIC ? OF_DENT : OF_RUBBING;
    work[i][column] += 0.5 * energy;
    if (force->newton_pair || j < atom->nlocal) work[j][column] += 0.5 * energy;
}

/* Energy stored in the contacts, plastic work of the dents, work of friction, work of rolling friction. */
double FixPLMEnergy::compute_scalar() {
    double sum = 0.0;
    for (int k = 0; k < size_vector; k++) sum += compute_vector(k);
    return sum;
}

double FixPLMEnergy::compute_vector(int k) {
    const double mine = k > 0 ? done[k - 1] : pair ? pair->stored_energy() : 0.0;
    double all;
    MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
    return all;
}

double FixPLMEnergy::memory_usage() { return (double)atom->nmax * COLUMNS * sizeof(double); }

void FixPLMEnergy::grow_arrays(int nmax) {
    memory->grow(work, nmax, COLUMNS, "plm/energy:work");
    array_atom = work;
}

void FixPLMEnergy::copy_arrays(int i, int j, int) { std::copy_n(work[i], COLUMNS, work[j]); }

void FixPLMEnergy::set_arrays(int i) { std::fill_n(work[i], COLUMNS, 0.0); }

int FixPLMEnergy::pack_reverse_comm(int n, int first, double *buffer) {
    for (int i = first; i < first + n; i++) buffer = std::copy_n(work[i], COLUMNS, buffer);
    return n * COLUMNS;
}

void FixPLMEnergy::unpack_reverse_comm(int n, int *owners, double *buffer) {
    for (int k = 0; k < n; k++)
        for (int column = 0; column < COLUMNS; column++) work[owners[k]][column] += *buffer++;
}

int FixPLMEnergy::pack_exchange(int i, double *buffer) {
    std::copy_n(work[i], COLUMNS, buffer);
    return COLUMNS;
}

int FixPLMEnergy::unpack_exchange(int i, double *buffer) {
    std::copy_n(buffer, COLUMNS, work[i]);
    return COLUMNS;
}

int FixPLMEnergy::pack_restart(int i, double *buffer) {
    buffer[0] = COLUMNS + RESTART_HEADER;
    std::copy_n(work[i], COLUMNS, buffer + RESTART_HEADER);
    return COLUMNS + RESTART_HEADER;
}

void FixPLMEnergy::unpack_restart(int i, int nth) {
    std::copy_n(PLM::restart_record(atom->extra[i], nth) + RESTART_HEADER, COLUMNS, work[i]);
}

int FixPLMEnergy::size_restart(int) { return COLUMNS + RESTART_HEADER; }

int FixPLMEnergy::maxsize_restart() { return COLUMNS + RESTART_HEADER; }

/* The account of all ranks, and the fingerprint of the laws. */
void FixPLMEnergy::write_restart(FILE *file) {
    double list[WORKS + 1];
    MPI_Reduce(done, list, WORKS, MPI_DOUBLE, MPI_SUM, 0, world);
    list[WORKS] = pair ? pair->fingerprint() : 0.0;
    if (comm->me != 0) return;
    const int bytes = sizeof(list);
    fwrite(&bytes, sizeof(bytes), 1, file);
    fwrite(list, sizeof(double), WORKS + 1, file);
}

void FixPLMEnergy::restart(char *buffer) {
    double list[WORKS + 1];
    memcpy(list, buffer, sizeof(list));
    of_restart = list[WORKS];
    if (comm->me == 0) std::copy_n(list, static_cast<int>(WORKS), done);
}
