/* The forces of fix plm/wall in a step: which walls a sphere touches, normal force and friction.
   SPDX-License-Identifier: GPL-2.0-or-later */

#include "fix_plm_wall.h"

#include "atom.h"
#include "error.h"
#include "plm_history.h"
#include "plm_vectors.h"
#include "region.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

namespace {
// below this radius of a region, over the radius of the sphere, a warning is given: the relative radius is off by 2 %
constexpr double CURVED = 50.0;
} // namespace

void FixPLMWall::post_force(int /*vflag*/) {
    double **x = atom->x;
    const double *radius = atom->radius;
    double normal[] = {0.0, 0.0, 0.0};
    normal[axis] = side;
    std::fill_n(load, 3, 0.0);
    for (int i = 0; i < atom->nlocal; i++) {
        if (!(atom->mask[i] & groupbit)) continue;
        double *slots = state[i] + FIRST_SLOT;
        state[i][PLASTIC] = state[i][ENDED];
        if (!region) {
            const double distance = side * (x[i][axis] - height);
            if (distance < radius[i]) {
                const bool is_new = slots[WALL] == 0.0;
                slots[WALL] = 1.0;
                update_contact(i, normal, distance, slots, is_new);
            } else if (slots[WALL] != 0.0)
                end_contact(i, slots);
        } else if (region->match(x[i][0], x[i][1], x[i][2])) {
            const int n = region->surface(x[i][0], x[i][1], x[i][2], radius[i]);
            for (int k = 0; k < walls; k++) {
                double *slot = slots + slot_size * k;
                const bool is_open = slot[WALL] != 0.0;
                const auto is_this = [&](const Region::Contact &c) { return c.iwall + 1.0 == slot[WALL]; };
                if (is_open && std::none_of(region->contact, region->contact + n, is_this)) end_contact(i, slot);
            }
            for (int c = 0; c < n; c++) {
                const Region::Contact &at = region->contact[c];
                double *slot = nullptr;
                for (int k = walls - 1; k >= 0; k--)
                    if (slots[slot_size * k + WALL] == 0.0 && !slot) slot = slots + slot_size * k;
                for (int k = 0; k < walls; k++)
                    if (slots[slot_size * k + WALL] == at.iwall + 1.0) slot = slots + slot_size * k;
                if (!slot) error->one(FLERR, "Fix plm/wall: a sphere touches more than {} walls of the region", walls);
                const bool is_new = slot[WALL] == 0.0;
                slot[WALL] = at.iwall + 1.0;
                if (!is_curved && std::abs(at.radius) > 0.0 && std::abs(at.radius) < CURVED * radius[i]) {
                    is_curved = true;
                    error->warning(FLERR,
                                   "Fix plm/wall: region {} is curved like a sphere of radius {:.4g} where a sphere of "
                                   "radius {:.4g} touches it; "
                                   "the law takes it as flat",
                                   region_name, std::abs(at.radius), radius[i]);
                }
                const double of_region[] = {at.delx / at.r, at.dely / at.r, at.delz / at.r};
                update_contact(i, of_region, at.r, slot, is_new);
            }
        } else
            error->one(FLERR, "Fix plm/wall: the centre of sphere {} is outside of region {}", atom->tag[i],
                       region_name);
    }
}

/* Adds the force of a contact. The normal of the wall points towards the sphere. */
void FixPLMWall::update_contact(int i, const double *normal, double distance, double *slot, bool is_new) {
    const Law &law = laws[atom->type[i]];
    if (!law.contact) error->one(FLERR, "Fix plm/wall: no scenario for atoms of type {}", atom->type[i]);
    const double scale = scale_of(i), radius = atom->radius[i], overlap = radius - distance;
    const double indentation = overlap * units.length * scale, per_force = 1.0 / (scale * scale * units.force);
    plm_history &contact = PLM::state_of(slot + STATE);
    double *of_friction = slot + FRICTION, slip[3] = {0.0, 0.0, 0.0};
    // the setup of a run has no step before it
    const bool has_slip = friction >= 0.0 && !update->setupflag;
    if (has_slip) {
        slip_of(i, normal, scale, slip);
        PLM::turn(of_friction, normal);
    }
    double stored;
    if (plm_contact_step(law.contact, indentation, &contact, friction, has_slip ? slip : nullptr,
                         has_slip ? of_friction : nullptr, &stored) != 0)
        error->one(FLERR, "Fix plm/wall: force or friction on sphere {} is not finite: is the timestep too long?",
                   atom->tag[i]);
    warn_once(i, overlap, indentation, is_new);
    double on_sphere[3];
    for (int k = 0; k < 3; k++) on_sphere[k] = contact.force * per_force * normal[k];
    if (friction >= 0.0) {
        double of_slot[3], moment[3];
        for (int k = 0; k < 3; k++) {
            of_slot[k] = of_friction[k] * per_force;
            on_sphere[k] += of_slot[k];
        }
        // the lever arm is the radius
        PLM::cross(normal, of_slot, moment);
        for (int k = 0; k < 3; k++) atom->torque[i][k] -= radius * moment[k];
    }
    for (int k = 0; k < 3; k++) {
        atom->f[i][k] += on_sphere[k];
        load[k] -= on_sphere[k];
    }
    state[i][DENT] = (contact.memory[0] - contact.memory[2]) / scale / units.length;
    state[i][PLASTIC] += contact.plastic / energy_scale(scale);
}

/* The motion of the contact point along the wall in this step, v - w x R n, in metres of the scenario's contact. */
void FixPLMWall::slip_of(int i, const double *normal, double scale, double *slip) const {
    double roll[3];
    PLM::cross(atom->omega[i], normal, roll);
    for (int k = 0; k < 3; k++) slip[k] = atom->v[i][k] - atom->radius[i] * roll[k];
    PLM::project(slip, normal);
    for (int k = 0; k < 3; k++) slip[k] *= update->dt * units.length * scale;
}

/* Warns of a start inside of the wall, and of a dent beyond the data. */
void FixPLMWall::warn_once(int i, double overlap, double indentation, bool is_new) {
    if (is_new && !is_inside) {
        const double way = PLM::length(atom->v[i]) * update->dt;
        if (PLM::starts_inside(overlap, way, atom->radius[i])) {
            is_inside = true;
            error->warning(FLERR,
                           "Fix plm/wall: the initial overlap adds spurious energy. Sphere {} is {:.3g} deep in the "
                           "wall when it first touches it, "
                           "and moves {:.3g} in a step. Place spheres outside of the wall",
                           atom->tag[i], overlap, way);
        }
    }
    const Law &law = laws[atom->type[i]];
    if (indentation > law.validated_indentation && !is_deep) {
        is_deep = true;
        error->warning(FLERR,
                       "Fix plm/wall: force, dent and e of sphere {} are estimates: its overlap {:.3g} exceeds the "
                       "validated {:.3g} for this "
                       "radius",
                       atom->tag[i], overlap, law.validated_indentation / scale_of(i) / units.length);
    }
}
