/* pair_style plm: spheres against spheres by the contact law of plm-impact.
   SPDX-License-Identifier: GPL-2.0-or-later

   This file reads the commands and prepares a run; pair_plm_compute.cpp has the forces of a step, and
   pair_plm_contacts.cpp what is asked about contacts between steps. */

#include "pair_plm.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix_plm_energy.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "neigh_history.h"
#include "neighbor.h"
#include "plm_history.h"
#include "plm_vectors.h"
#include "update.h"
#include "utils.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

using namespace LAMMPS_NS;

namespace {
constexpr const char *STYLE = "Pair plm";
constexpr const char *HISTORY = "NEIGH_HISTORY_PLM", *DUMMY = "NEIGH_HISTORY_PLM_DUMMY";
// with more radii than these, contacts are those of the nearest ratio of radii in a table
constexpr std::size_t MOST_EXACT_RADII = 64;
} // namespace

PairPLM::PairPLM(LAMMPS *lmp)
    : Pair(lmp), account(nullptr), friction(-1.0), rolling_stiffness(0.0), rolling(-1.0),
      size(PLM::History::size(false, false)), fix_history(nullptr), units{}, is_deep(false), is_inside(false) {
    single_enable = 1;
    no_virial_fdotr_compute = 1;
    restartinfo = 0;
    finitecutflag = 1;
    centroidstressflag = CENTROID_NOTAVAIL;
    nondefault_history_transfer = 1;
    single_extra = 6;
    svector = new double[single_extra];
    // keeps the place of the history in the order of fixes
    modify->add_fix(std::string(DUMMY) + " all DUMMY");
}

PairPLM::~PairPLM() {
    delete[] svector;
    svector = nullptr;
    if (account) account->forget(this);
    modify->delete_fix(fix_history ? HISTORY : DUMMY);
    if (allocated) {
        memory->destroy(setflag);
        memory->destroy(cutsq);
    }
}

void PairPLM::allocate() {
    allocated = 1;
    const int n = atom->ntypes + 1;
    memory->create(setflag, n, n, "pair:setflag");
    memory->create(cutsq, n, n, "pair:cutsq");
    law.assign(n, std::vector<PLM::PairLaw *>(n, nullptr));
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) setflag[i][j] = 0;
}

/* A second command for the same pair style replaces the first one. */
void PairPLM::settings(int narg, char **arg) {
    const char *usage = "expected: pair_style plm [friction MU] [rolling K MU]";
    friction = rolling = -1.0;
    for (int at = 0; at < narg;) {
        if (strcmp(arg[at], "friction") == 0 && at + 1 < narg) {
            friction = PLM::friction_of(lmp, STYLE, arg[at + 1]);
            at += 2;
        } else if (strcmp(arg[at], "rolling") == 0 && at + 2 < narg) {
            rolling_stiffness = utils::numeric(FLERR, arg[at + 1], false, lmp);
            rolling = PLM::friction_of(lmp, STYLE, arg[at + 2]);
            if (!(rolling_stiffness > 0.0) || !std::isfinite(rolling_stiffness))
                error->all(FLERR, "Pair plm: the stiffness {} of rolling must be a positive number", arg[at + 1]);
            at += 3;
        } else
            error->all(FLERR, "Pair plm: unknown or incomplete keyword {}; {}", arg[at], usage);
    }
    const int wanted = PLM::History::size(friction >= 0.0, rolling >= 0.0);
    if (fix_history && wanted != size)
        error->all(FLERR, "Pair plm: friction or rolling cannot begin or end between runs, because the contacts have a "
                          "history of another size. Give pair_style none first; all dents are then forgotten");
    size = wanted;
    units = PLM::units_of(lmp, STYLE);
    if (!finder) finder = std::make_unique<PLM::Finder>(units);
}

/* A range of types with itself is one material; two different types are the sphere and the half-space of the scenario.
 */
void PairPLM::coeff(int narg, char **arg) {
    if (narg != 3) error->all(FLERR, "Pair plm: expected: pair_coeff I J FILE");
    if (!allocated) allocate();
    int ilo, ihi, jlo, jhi;
    utils::bounds(FLERR, arg[0], 1, atom->ntypes, ilo, ihi, error);
    utils::bounds(FLERR, arg[1], 1, atom->ntypes, jlo, jhi, error);
    const bool has_one_material = ilo == jlo && ihi == jhi;
    if (!has_one_material && jlo <= ihi)
        error->all(FLERR,
                   "Pair plm: types {} and {} overlap. Give one material as I I or I*J I*J, and two materials as two "
                   "separate ranges, of which the lower is the sphere of the scenario",
                   arg[0], arg[1]);
    plm_contact *contact = PLM::open_contact(lmp, STYLE, arg[2]);
    char message[2048];
    plm_contact *of_one = plm_contact_of_one_material(contact, message, sizeof(message));
    if (has_one_material) {
        plm_contact_free(contact);
        if (!of_one) error->all(FLERR, "Pair plm: {}: {}", arg[2], message);
        contact = of_one;
    } else {
        if (of_one && plm_contact_fingerprint(of_one) != plm_contact_fingerprint(contact) && comm->me == 0)
            error->warning(
                FLERR,
                "Pair plm: {}: e has an error of up to 7 % (mostly too high) if types {} and {} are of one "
                "material: one of the two bodies has no yield_strength and stays elastic. Give both strengths",
                arg[2], arg[0], arg[1]);
        plm_contact_free(of_one);
    }
    laws.push_back(std::make_unique<PLM::PairLaw>(contact, has_one_material));
    for (int i = ilo; i <= ihi; i++)
        for (int j = std::max(jlo, i); j <= jhi; j++) {
            setflag[i][j] = 1;
            law[i][j] = law[j][i] = laws.back().get();
        }
}

void PairPLM::init_style() {
    if (!atom->radius_flag || !atom->rmass_flag)
        error->all(FLERR, "Pair plm needs spheres with radius and mass: use atom_style sphere");
    if (utils::strmatch(update->integrate_style, "^respa"))
        error->all(FLERR, "Pair plm: run_style respa is not supported");
    if (friction >= 0.0 && comm->ghost_velocity == 0)
        error->all(FLERR, "Pair plm: friction needs the velocities of ghost atoms: comm_modify vel yes");
    neighbor->add_request(this, NeighConst::REQ_SIZE | NeighConst::REQ_HISTORY);
    if (!fix_history) {
        const std::string command = std::string(HISTORY) + " all NEIGH_HISTORY " + std::to_string(size);
        fix_history = dynamic_cast<FixNeighHistory *>(modify->replace_fix(DUMMY, command, 1));
        fix_history->pair = this;
    }
    // After a run LAMMPS has moved the histories to the spheres. write_restart then makes new ghost atoms, and would
    // move the histories again, with the neighbour list of the run, whose ghost atoms are others: contacts across a
    // face of the box would be lost (LAMMPS 22 Jul 2025). Only within a run do the histories have to be moved for a
    // restart file.
    fix_history->restart_global = 0;
    account = nullptr; // fix plm/energy comes again in its init()

    // of every type the largest radius, also of spheres that come later; and the radii, if there are few
    const int types = atom->ntypes;
    std::vector<double> mine(types + 1, 0.0);
    for (const char *style : {"^pour", "^deposit"})
        for (auto *fix : modify->get_fix_by_style(style))
            for (int type = 1; type <= types; type++) {
                int itype = type;
                if (const void *radius = fix->extract("radius", itype))
                    mine[type] = std::max(mine[type], *static_cast<const double *>(radius));
            }
    std::set<double> radii;
    for (int i = 0; i < atom->nlocal; i++) {
        mine[atom->type[i]] = std::max(mine[atom->type[i]], atom->radius[i]);
        if (radii.size() <= MOST_EXACT_RADII) radii.insert(atom->radius[i]);
    }
    largest.resize(types + 1);
    MPI_Allreduce(mine.data(), largest.data(), types + 1, MPI_DOUBLE, MPI_MAX, world);
    std::vector<double> few(radii.begin(), radii.end());
    few.resize(MOST_EXACT_RADII + 1, -1.0);
    std::vector<double> all((MOST_EXACT_RADII + 1) * comm->nprocs);
    MPI_Allgather(few.data(), MOST_EXACT_RADII + 1, MPI_DOUBLE, all.data(), MOST_EXACT_RADII + 1, MPI_DOUBLE, world);
    radii = std::set<double>(all.begin(), all.end());
    radii.erase(-1.0);
    if (radii.size() > MOST_EXACT_RADII) radii.clear();
    finder->set_exact(std::vector<double>(radii.begin(), radii.end()));
}

double PairPLM::init_one(int i, int j) {
    if (!setflag[i][j])
        error->all(FLERR, "Pair plm: no scenario for types {} and {}: give pair_coeff {} {}", i, j, i, j);
    law[j][i] = law[i][j];
    return largest[i] + largest[j];
}

/* Which time step the shortest contact needs: of the smallest spheres of two types, at the sum of the largest speeds.
 */
void PairPLM::setup() {
    fix_history->restart_global = 1;
    const int n = atom->ntypes + 1;
    std::vector<double> least(2 * n, HUGE_VAL), fastest(n, 0.0), smallest(2 * n), speeds(n);
    for (int i = 0; i < atom->nlocal; i++) {
        const int type = atom->type[i];
        least[type] = std::min(least[type], atom->radius[i]);
        least[n + type] = std::min(least[n + type], atom->rmass[i]);
        fastest[type] = std::max(fastest[type], PLM::length(atom->v[i]));
    }
    MPI_Allreduce(least.data(), smallest.data(), 2 * n, MPI_DOUBLE, MPI_MIN, world);
    MPI_Allreduce(fastest.data(), speeds.data(), n, MPI_DOUBLE, MPI_MAX, world);
    for (int i = 1; i < n; i++)
        for (int j = i; j < n; j++) {
            if (!law[i][j] || smallest[i] == HUGE_VAL || smallest[j] == HUGE_VAL) continue;
            const PLM::Balls &balls = finder->find(law[i][j], smallest[i], smallest[j]);
            if (!balls.contact) continue;
            const double scale = balls.length / units.length;
            const double mass = smallest[n + i] * smallest[n + j] / (smallest[n + i] + smallest[n + j]) * units.mass;
            // seen from the contact, lengths and times are longer by the scale, and masses by its cube
            const double of_contact = mass * scale * scale * scale;
            double speed = (speeds[i] + speeds[j]) * units.length / units.time, e;
            if (speed == 0.0)
                speed =
                    plm_contact_yield_speed(balls.contact) * sqrt(plm_contact_reduced_mass(balls.contact) / of_contact);
            const double time = plm_contact_time_of_mass(balls.contact, of_contact, speed, &e);
            if (std::isfinite(time)) advice.add(time / scale / units.time, e, NAN);
        }
    advice.report(lmp, STYLE);
}
