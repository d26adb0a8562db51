/* What fix plm/wall and pair_style plm share.
   SPDX-License-Identifier: GPL-2.0-or-later */

#include "plm_common.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "lammps.h"
#include "update.h"
#include "utils.h"

#include <cmath>
#include <string>

using namespace LAMMPS_NS;

namespace {
// steps per contact for e within 0.1 %: plots/bench/README.md, the worst problem
constexpr double STEPS_FOR_E = 70.0;
// with fewer steps than these e is off by several per cent
constexpr double LEAST_STEPS = 10.0;
// a first overlap beyond this multiple of the way of one step, and this share of the radius, is a start inside
constexpr double MAX_FIRST_OVERLAP_STEPS = 2.0, ROUNDING = 1e-6;
} // namespace

PLM::Units PLM::units_of(LAMMPS *lmp, const char *style) {
    const std::string name = lmp->update->unit_style;
    Units units{1.0, 1.0, 1.0, 1.0};
    if (name == "cgs")
        units = {1e-2, 1e-3, 1.0, 0.0};
    else if (name == "micro")
        units = {1e-6, 1e-15, 1e-6, 0.0};
    else if (name == "nano")
        units = {1e-9, 1e-21, 1e-9, 0.0};
    else if (name != "si")
        lmp->error->all(
            FLERR, "{}: a scenario has SI units, and units {} have no length in metres: use si, cgs, micro or nano",
            style, name);
    units.force = units.mass * units.length / (units.time * units.time);
    return units;
}

plm_contact *PLM::open_contact(LAMMPS *lmp, const char *style, const char *file) {
    char message[2048];
    plm_contact *contact = plm_contact_open(file, message, sizeof(message));
    if (!contact) lmp->error->all(FLERR, "{}: {}", style, message);
    return contact;
}

double PLM::friction_of(LAMMPS *lmp, const char *style, const char *word) {
    const double friction = utils::numeric(FLERR, word, false, lmp);
    if (!(friction >= 0.0) || !std::isfinite(friction))
        lmp->error->all(FLERR, "{}: friction {} must be a number of 0 or more", style, word);
    if (!lmp->atom->omega_flag || !lmp->atom->torque_flag)
        lmp->error->all(FLERR, "{}: friction turns spheres, and atom_style {} has no spin: use atom_style sphere",
                        style, lmp->atom->atom_style);
    return friction;
}

bool PLM::starts_inside(double overlap, double way, double radius) {
    return overlap > MAX_FIRST_OVERLAP_STEPS * way + ROUNDING * radius;
}

void PLM::Advice::add(double time, double restitution, double with_waves) {
    if (time < shortest) shortest = time;
    if (restitution - with_waves > lost) {
        lost = restitution - with_waves;
        of_law = restitution;
    }
}

void PLM::Advice::report(LAMMPS *lmp, const char *style) {
    if (is_reported) return;
    is_reported = true;
    struct {
        double loss;
        int rank;
    } mine{lost, lmp->comm->me}, worst;
    MPI_Allreduce(&mine, &worst, 1, MPI_DOUBLE_INT, MPI_MAXLOC, lmp->world);
    MPI_Bcast(&of_law, 1, MPI_DOUBLE, worst.rank, lmp->world);
    const double none = shortest;
    double all;
    MPI_Allreduce(&none, &all, 1, MPI_DOUBLE, MPI_MIN, lmp->world);
    if (lmp->comm->me != 0 || all == Advice().shortest) return;
    const double dt = lmp->update->dt, wanted = all / STEPS_FOR_E;
    utils::logmesg(lmp,
                   "{}: the shortest contact lasts {:.4g}; {:.0f} steps of it keep e within 0.1 %: timestep {:.3g} "
                   "or less (it is {:.3g})\n",
                   style, all, STEPS_FOR_E, wanted, dt);
    if (worst.loss > 0.0)
        utils::logmesg(
            lmp, "{}: elastic waves are left out: they would lower e from {:.4f} to {:.4f} where they take most\n",
            style, of_law, of_law - worst.loss);
    if (all < LEAST_STEPS * dt)
        lmp->error->warning(FLERR,
                            "{}: e is not meaningful: the shortest contact has only {:.1f} time steps. Use a "
                            "timestep of {:.3g} or less",
                            style, all / dt, wanted);
    else if (dt > wanted)
        lmp->error->warning(FLERR, "{}: the timestep {:.3g} is too long for e within 0.1 %", style, dt);
}
