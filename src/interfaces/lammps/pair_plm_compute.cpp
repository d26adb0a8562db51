/* The forces of pair_style plm in a step: normal force, friction and rolling, and the work that they take.
   SPDX-License-Identifier: GPL-2.0-or-later */

#include "pair_plm.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix_plm_energy.h"
#include "force.h"
#include "neigh_history.h"
#include "neigh_list.h"
#include "plm_history.h"
#include "plm_vectors.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using PLM::cross;
using PLM::dot;
using namespace PLM::History;

/* The motion of the contact point along the surface in this step, in metres of the contact. As in LAMMPS it is that of
   whole radii. */
inline void PairPLM::slip_of(const Contact &contact, double *slip) const {
    const int i = contact.i, j = contact.j;
    const double *wi = atom->omega[i], *wj = atom->omega[j], *vi = atom->v[i], *vj = atom->v[j];
    const double radius_i = atom->radius[i], radius_j = atom->radius[j];
    double turn[3], roll[3];
    for (int k = 0; k < 3; k++) turn[k] = radius_i * wi[k] + radius_j * wj[k];
    cross(turn, contact.normal, roll);
    for (int k = 0; k < 3; k++) slip[k] = vi[k] - vj[k] - roll[k];
    PLM::project(slip, contact.normal);
    const double scale = update->dt * contact.balls->length;
    for (int k = 0; k < 3; k++) slip[k] *= scale;
}

/* Adds the friction on i to its force, and its moment about the centre over the lever. */
inline void PairPLM::add_friction(const Contact &contact, double *force, double *moment) {
    double friction_force[3];
    for (int k = 0; k < 3; k++) {
        friction_force[k] = contact.history[FRICTION + k] * contact.balls->per_force;
        force[k] += friction_force[k];
    }
    cross(contact.normal, friction_force, moment);
}

/* Moves the history of a contact to its overlap. Returns the stored energy in units of LAMMPS, if it is asked for. */
inline double PairPLM::advance(const Contact &contact, bool has_energy) {
    const PLM::Balls &balls = *contact.balls;
    double *history = contact.history, *of_friction = history + FRICTION, stored = 0.0;
    plm_history &state = PLM::state_of(history);
    // the setup of a run has no step before it
    const bool has_slip = friction >= 0.0 && !update->setupflag;
    double slip[3] = {0.0, 0.0, 0.0}, before[3];
    if (has_slip) {
        slip_of(contact, slip);
        std::copy_n(of_friction, 3, before);
        PLM::turn(of_friction, contact.normal);
    }
    if (plm_contact_step(balls.contact, contact.overlap * balls.length, &state, friction, has_slip ? slip : nullptr,
                         has_slip ? of_friction : nullptr, has_energy ? &stored : nullptr) != 0)
        error->one(FLERR,
                   "Pair plm: force or friction between spheres {} and {} is not finite: is the timestep too long?",
                   atom->tag[contact.i], atom->tag[contact.j]);
    if (account) {
        if (state.plastic != history[TAKEN]) count_plastic_work(contact);
        if (has_slip) count_friction(contact, slip, before);
    }
    return stored * balls.per_energy;
}

void PairPLM::compute(int eflag, int vflag) {
    ev_init(eflag, vflag);
    double **x = atom->x, **f = atom->f, **torque = atom->torque;
    const double *radius = atom->radius;
    const int nlocal = atom->nlocal, newton = force->newton_pair;
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
            const bool is_new = touches[jj] == 0, is_mine = newton || j < nlocal;
            touches[jj] = 1;
            const PLM::Balls &balls = balls_of(i, j);
            const double r = sqrt(rsq), overlap = sum - r, per_r = 1.0 / r;
            const Contact contact{
                i, j, {d[0] * per_r, d[1] * per_r, d[2] * per_r}, overlap, is_mine ? 1.0 : 0.5, &balls, history};
            const double stored = advance(contact, account || eflag);
            if (is_new || overlap * balls.length > balls.validated) warn_once(contact, is_new);
            const double normal_force = PLM::state_of(history).force * balls.per_force;
            // the levers of the friction end in the middle of the overlap, which keeps the angular momentum
            const double lever_i = radius[i] - 0.5 * overlap, lever_j = radius[j] - 0.5 * overlap;
            // force on i; moment of the friction about its centre over the lever, and the couple of rolling on i
            double total[3], moment[] = {0.0, 0.0, 0.0}, couple[] = {0.0, 0.0, 0.0};
            for (int k = 0; k < 3; k++) total[k] = normal_force * contact.normal[k];
            if (friction >= 0.0) add_friction(contact, total, moment);
            if (rolling >= 0.0) add_rolling(contact, normal_force, couple);
            for (int k = 0; k < 3; k++) {
                f[i][k] += total[k];
                torque[i][k] += couple[k] - lever_i * moment[k];
            }
            if (is_mine)
                for (int k = 0; k < 3; k++) {
                    f[j][k] -= total[k];
                    torque[j][k] -= couple[k] + lever_j * moment[k];
                }
            if (evflag) ev_tally_xyz(i, j, nlocal, newton, stored, 0.0, total[0], total[1], total[2], d[0], d[1], d[2]);
        }
    }
}

/* The work of the friction in this step, which is that of the levers. */
void PairPLM::count_friction(const Contact &contact, const double *slip, const double *before) {
    double turn[3], back[3], of_levers[3];
    const double half = 0.5 * contact.overlap * contact.balls->length * update->dt;
    for (int k = 0; k < 3; k++) turn[k] = atom->omega[contact.i][k] + atom->omega[contact.j][k];
    cross(turn, contact.normal, back);
    for (int k = 0; k < 3; k++) of_levers[k] = slip[k] + half * back[k];
    const double sum = dot(before, of_levers) + dot(contact.history + FRICTION, of_levers);
    account->add(FixPLMEnergy::FRICTION, contact.share, -0.5 * sum * contact.balls->per_energy, contact.i, contact.j);
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
        PLM::turn(rolled, n);
        for (int k = 0; k < 3; k++) rolled[k] += way[k];
        const double length = PLM::length(rolled), most = rolling * normal_force / rolling_stiffness;
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
    double &taken = contact.history[TAKEN];
    const double plastic = PLM::state_of(contact.history).plastic;
    account->add(FixPLMEnergy::PLASTIC, contact.share, (plastic - taken) * contact.balls->per_energy, contact.i,
                 contact.j);
    taken = plastic;
}

/* Warns once of a start inside of each other, and once of a dent beyond the data. */
void PairPLM::warn_once(const Contact &contact, bool is_new) {
    const int i = contact.i, j = contact.j;
    const double overlap = contact.overlap;
    if (is_new && !is_inside) {
        double apart[3];
        for (int k = 0; k < 3; k++) apart[k] = atom->v[i][k] - atom->v[j][k];
        const double way = PLM::length(apart) * update->dt;
        // the velocities of ghost atoms are known with friction alone
        const bool is_known = j < atom->nlocal || comm->ghost_velocity;
        if (is_known && PLM::starts_inside(overlap, way, std::min(atom->radius[i], atom->radius[j]))) {
            is_inside = true;
            error->warning(
                FLERR,
                "Pair plm: the initial overlap adds spurious energy. Spheres {} and {} overlap by {:.3g} when "
                "they first touch, and move by {:.3g} in a step. Place spheres apart",
                atom->tag[i], atom->tag[j], overlap, way);
        }
    }
    if (!is_deep && overlap * contact.balls->length > contact.balls->validated) {
        is_deep = true;
        error->warning(
            FLERR,
            "Pair plm: force, dent and e of spheres {} and {} are estimates: their overlap {:.3g} exceeds the "
            "validated {:.3g} for these radii",
            atom->tag[i], atom->tag[j], overlap, contact.balls->validated / contact.balls->length);
    }
}
