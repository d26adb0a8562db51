/* pair_style plm: spheres against spheres by the contact law of plm-impact.
   SPDX-License-Identifier: GPL-2.0-or-later

   The history of a contact is the memory of the law (three doubles), the plastic work and the indentation; with
   friction the friction on the sphere that owns the contact, with rolling friction the rolled way. All are those of the
   contact of the scenario, but the rolled way. */

#include "pair_plm.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix_plm_energy.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "neigh_history.h"
#include "neigh_list.h"
#include "neighbor.h"
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
enum { MEMORY, TAKEN = 3, NOW, FRICTION, ROLLED = FRICTION + 3 };
// with more radii than these, contacts are those of the nearest ratio of radii in a table
constexpr std::size_t MOST_EXACT_RADII = 64;
// a first overlap beyond this multiple of the way of one step, and this share of the radius, is a start inside of the
// other
constexpr double MAX_FIRST_OVERLAP_STEPS = 2.0, ROUNDING = 1e-6;

void cross(const double *a, const double *b, double *result) {
    result[0] = a[1] * b[2] - a[2] * b[1];
    result[1] = a[2] * b[0] - a[0] * b[2];
    result[2] = a[0] * b[1] - a[1] * b[0];
}

double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
} // namespace

PairPLM::PairPLM(LAMMPS *lmp)
    : Pair(lmp), account(nullptr), friction(-1.0), rolling_stiffness(0.0), rolling(-1.0), size(FRICTION),
      fix_history(nullptr), units{}, is_deep(false), is_inside(false) {
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

void PairPLM::settings(int narg, char **arg) {
    const char *usage = "expected: pair_style plm [friction MU] [rolling K MU]";
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
    size = rolling >= 0.0 ? ROLLED + 3 : friction >= 0.0 ? ROLLED : FRICTION;
    units = PLM::units_of(lmp, STYLE);
    finder = std::make_unique<PLM::Finder>(units);
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
    const int n = atom->ntypes + 1;
    std::vector<double> least(2 * n, HUGE_VAL), fastest(n, 0.0), smallest(2 * n), speeds(n);
    for (int i = 0; i < atom->nlocal; i++) {
        const int type = atom->type[i];
        least[type] = std::min(least[type], atom->radius[i]);
        least[n + type] = std::min(least[n + type], atom->rmass[i]);
        fastest[type] = std::max(fastest[type], sqrt(dot(atom->v[i], atom->v[i])));
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

/* Seen from the other sphere friction and rolled way turn; the normal part is the same. */
void PairPLM::transfer_history(double *source, double *target, int, int) {
    for (int k = 0; k < size; k++) target[k] = k < FRICTION ? source[k] : -source[k];
}

void PairPLM::compute(int eflag, int vflag) {
    ev_init(eflag, vflag);
    double **x = atom->x, **f = atom->f, **torque = atom->torque;
    const double *radius = atom->radius;
    const int *type = atom->type, nlocal = atom->nlocal, newton = force->newton_pair;
    for (int ii = 0; ii < list->inum; ii++) {
        const int i = list->ilist[ii], *neighbours = list->firstneigh[i];
        int *touches = fix_history->firstflag[i];
        double *histories = fix_history->firstvalue[i];
        for (int jj = 0; jj < list->numneigh[i]; jj++) {
            const int j = neighbours[jj] & NEIGHMASK;
            const double d[] = {x[i][0] - x[j][0], x[i][1] - x[j][1], x[i][2] - x[j][2]};
            const double rsq = dot(d, d), sum = radius[i] + radius[j];
            double *history = histories + size * jj;
            if (rsq >= sum * sum) {
                if (touches[jj]) {
                    touches[jj] = 0;
                    std::fill_n(history, size, 0.0);
                }
                continue;
            }
            const bool is_new = touches[jj] == 0;
            touches[jj] = 1;
            const bool is_in_order = type[i] <= type[j];
            const PLM::Balls &balls =
                finder->find(law[type[i]][type[j]], radius[is_in_order ? i : j], radius[is_in_order ? j : i]);
            if (!balls.contact)
                error->one(FLERR, "Pair plm: there is no contact between spheres of the radii {} and {}", radius[i],
                           radius[j]);
            const double r = sqrt(rsq), indentation = (sum - r) * balls.length, peak = history[MEMORY];
            const double of_contact = plm_contact_force(balls.contact, indentation, history + MEMORY);
            const double normal_force = of_contact / balls.force;
            if (!std::isfinite(normal_force))
                error->one(FLERR,
                           "Pair plm: the force between spheres {} and {} is not finite: is the timestep too long?",
                           atom->tag[i], atom->tag[j]);
            Contact contact{i,
                            j,
                            {d[0] / r, d[1] / r, d[2] / r},
                            newton || j < nlocal ? 1.0 : 0.5,
                            &balls,
                            {history[NOW], indentation, of_contact, history + MEMORY},
                            history};
            warn_once(contact, sum - r, is_new);
            if (history[MEMORY] != peak && account) count_plastic_work(contact);
            // the levers of the friction end in the middle of the overlap, which keeps the angular momentum
            const double lever_i = radius[i] - 0.5 * (sum - r), lever_j = radius[j] - 0.5 * (sum - r);
            // force on i; moment of the friction about its centre over the lever, and the couple of rolling on i
            double total[] = {normal_force * contact.normal[0], normal_force * contact.normal[1],
                              normal_force * contact.normal[2]};
            double moment[] = {0.0, 0.0, 0.0}, couple[] = {0.0, 0.0, 0.0};
            if (friction >= 0.0) add_friction(contact, total, moment);
            if (rolling >= 0.0) add_rolling(contact, normal_force, couple);
            history[NOW] = indentation;
            for (int k = 0; k < 3; k++) {
                f[i][k] += total[k];
                torque[i][k] += couple[k] - lever_i * moment[k];
            }
            if (newton || j < nlocal)
                for (int k = 0; k < 3; k++) {
                    f[j][k] -= total[k];
                    torque[j][k] -= couple[k] + lever_j * moment[k];
                }
            if (evflag) {
                const double stored =
                    eflag ? plm_contact_energy(balls.contact, indentation, of_contact, history + MEMORY, nullptr) /
                                balls.energy
                          : 0.0;
                ev_tally_xyz(i, j, nlocal, newton, stored, 0.0, total[0], total[1], total[2], d[0], d[1], d[2]);
            }
        }
    }
}

/* Adds the friction on i to its force, and its moment about the centre over the lever. As in LAMMPS the slip is that of
   whole radii; the work is that of the levers. */
void PairPLM::add_friction(const Contact &contact, double *force, double *moment) {
    const int i = contact.i, j = contact.j;
    const double *n = contact.normal, scale = contact.balls->length;
    double *history = contact.history + FRICTION;
    const double before[] = {history[0], history[1], history[2]};
    double turn[3], roll[3], slip[3];
    for (int k = 0; k < 3; k++) turn[k] = atom->radius[i] * atom->omega[i][k] + atom->radius[j] * atom->omega[j][k];
    cross(turn, n, roll);
    for (int k = 0; k < 3; k++) slip[k] = atom->v[i][k] - atom->v[j][k] - roll[k];
    PLM::project(slip, n, false);
    for (double &part : slip) part *= update->dt * scale;
    // the setup of a run has no step before it
    if (!update->setupflag) {
        if (!PLM::update_friction(contact.balls->contact, friction, n, contact.step, slip, history))
            error->one(FLERR,
                       "Pair plm: the friction between spheres {} and {} is not finite: is the timestep too long?",
                       atom->tag[i], atom->tag[j]);
        if (account) {
            double of_levers[3], back[3];
            for (int k = 0; k < 3; k++) turn[k] = atom->omega[i][k] + atom->omega[j][k];
            cross(turn, n, back);
            for (int k = 0; k < 3; k++) of_levers[k] = slip[k] + 0.5 * contact.step.indentation * back[k] * update->dt;
            const double work = -0.5 * (dot(before, of_levers) + dot(history, of_levers)) / contact.balls->energy;
            account->add(FixPLMEnergy::FRICTION, contact.share, work, i, j);
        }
    }
    double friction_force[3];
    for (int k = 0; k < 3; k++) {
        friction_force[k] = history[k] / contact.balls->force;
        force[k] += friction_force[k];
    }
    cross(n, friction_force, moment);
}

/* The rolling spring of LAMMPS (sds without damping): the couple on i, which is at most that of the coefficient. */
void PairPLM::add_rolling(const Contact &contact, double normal_force, double *couple) {
    const int i = contact.i, j = contact.j;
    const double *n = contact.normal,
                 effective = atom->radius[i] * atom->radius[j] / (atom->radius[i] + atom->radius[j]);
    double *rolled = contact.history + ROLLED;
    if (!update->setupflag) {
        const double before[] = {rolled[0], rolled[1], rolled[2]};
        double turn[3], way[3];
        for (int k = 0; k < 3; k++) turn[k] = atom->omega[i][k] - atom->omega[j][k];
        cross(turn, n, way);
        for (double &part : way) part *= effective * update->dt;
        PLM::project(rolled, n, true);
        for (int k = 0; k < 3; k++) rolled[k] += way[k];
        const double length = sqrt(dot(rolled, rolled)), most = rolling * normal_force / rolling_stiffness;
        if (length > most)
            for (int k = 0; k < 3; k++) rolled[k] *= most / length;
        if (account) {
            const double work = 0.5 * rolling_stiffness * (dot(before, way) + dot(rolled, way));
            account->add(FixPLMEnergy::ROLLING, contact.share, work, i, j);
        }
    }
    double pushing[3];
    for (int k = 0; k < 3; k++) pushing[k] = -effective * rolling_stiffness * rolled[k];
    cross(n, pushing, couple);
}

/* The plastic work of a dent that has grown: what was counted of this contact is in its history. */
void PairPLM::count_plastic_work(const Contact &contact) {
    double plastic, *taken = contact.history + TAKEN;
    const PLM::Step &step = contact.step;
    plm_contact_energy(contact.balls->contact, step.indentation, step.force, step.memory, &plastic);
    account->add(FixPLMEnergy::PLASTIC, contact.share, (plastic - *taken) / contact.balls->energy, contact.i,
                 contact.j);
    *taken = plastic;
}

/* Warns of a start inside of each other, and of a dent beyond the data. */
void PairPLM::warn_once(const Contact &contact, double overlap, bool is_new) {
    const int i = contact.i, j = contact.j;
    if (is_new && !is_inside) {
        double apart[3];
        for (int k = 0; k < 3; k++) apart[k] = atom->v[i][k] - atom->v[j][k];
        const double way = sqrt(dot(apart, apart)) * update->dt;
        const double smaller = std::min(atom->radius[i], atom->radius[j]);
        // the velocities of ghost atoms are known with friction alone
        const bool is_known = j < atom->nlocal || comm->ghost_velocity;
        if (is_known && overlap > MAX_FIRST_OVERLAP_STEPS * way + ROUNDING * smaller) {
            is_inside = true;
            error->warning(
                FLERR,
                "Pair plm: the initial overlap adds spurious energy. Spheres {} and {} overlap by {:.3g} when "
                "they first touch, and move by {:.3g} in a step. Place spheres apart",
                atom->tag[i], atom->tag[j], overlap, way);
        }
    }
    if (!is_deep && contact.step.indentation > contact.balls->validated) {
        is_deep = true;
        error->warning(
            FLERR,
            "Pair plm: force, dent and e of spheres {} and {} are estimates: their overlap {:.3g} exceeds the "
            "validated {:.3g} for these radii",
            atom->tag[i], atom->tag[j], overlap, contact.balls->validated / contact.balls->length);
    }
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

/* For compute pair/local: stored energy, and force, overlap, dent depth, plastic work, size of the friction, radius of
   the contact's effective sphere. */
double PairPLM::single(int i, int j, int itype, int jtype, double rsq, double, double, double &fforce) {
    std::fill_n(svector, single_extra, 0.0);
    fforce = 0.0;
    const double sum = atom->radius[i] + atom->radius[j];
    const double *history = rsq < sum * sum ? history_of(i, j) : nullptr;
    if (!history) return 0.0;
    const bool is_in_order = itype <= jtype;
    const PLM::Balls &balls =
        finder->find(law[itype][jtype], atom->radius[is_in_order ? i : j], atom->radius[is_in_order ? j : i]);
    double memory[] = {history[MEMORY], history[MEMORY + 1], history[MEMORY + 2]}, plastic;
    const double of_contact = plm_contact_force(balls.contact, history[NOW], memory);
    const double stored = plm_contact_energy(balls.contact, history[NOW], of_contact, memory, &plastic) / balls.energy;
    svector[0] = of_contact / balls.force;
    svector[1] = history[NOW] / balls.length;
    svector[2] = (memory[0] - memory[2]) / balls.length;
    svector[3] = plastic / balls.energy;
    if (friction >= 0.0) svector[4] = sqrt(dot(history + FRICTION, history + FRICTION)) / balls.force;
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
            const bool is_in_order = atom->type[i] <= atom->type[j];
            const PLM::Balls &balls = finder->find(law[atom->type[i]][atom->type[j]], atom->radius[is_in_order ? i : j],
                                                   atom->radius[is_in_order ? j : i]);
            const double *history = fix_history->firstvalue[i] + size * jj;
            double memory[] = {history[MEMORY], history[MEMORY + 1], history[MEMORY + 2]};
            const double of_contact = plm_contact_force(balls.contact, history[NOW], memory);
            const double share = force->newton_pair || j < atom->nlocal ? 1.0 : 0.5;
            stored +=
                share * plm_contact_energy(balls.contact, history[NOW], of_contact, memory, nullptr) / balls.energy;
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
