/* fix plm/wall: spheres against a flat wall by the contact law of plm-impact.
   SPDX-License-Identifier: GPL-2.0-or-later

   The memory of a contact is three doubles in a slot of each sphere. They belong to the sphere of the scenario, with
   radius R. The law of a sphere of another radius r follows by scaling, so one scenario serves all radii: with s = R/r,
   the indentation is multiplied by s and the force is divided by s^2. With friction a slot has three more doubles: the
   friction on the sphere. */

#include "fix_plm_wall.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "group.h"
#include "memory.h"
#include "region.h"
#include "update.h"
#include "utils.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using namespace FixConst;

namespace {
enum { DENT, PLASTIC, ENDED, FIRST_SLOT }; // columns of a sphere; ENDED is the plastic work of ended contacts
// doubles of a slot: number of the wall (0: no contact), memory (3), plastic work, indentation, and with friction the
// friction (3); all but the first belong to the sphere of the scenario
enum { WALL, MEMORY, TAKEN = 4, NOW, FRICTION };
constexpr int SLOT_SIZE = FRICTION, SLOT_SIZE_FRICTION = FRICTION + 3;
// doubles of a sphere in a restart file before its state
constexpr int RESTART_HEADER = 2;
constexpr const char *STYLE = "Fix plm/wall";
// a first overlap beyond this multiple of the way of one step, and this share of the radius, is a start inside the wall
constexpr double MAX_FIRST_OVERLAP_STEPS = 2.0, ROUNDING = 1e-6;
// below this radius of a region, over the radius of the sphere, a warning is given: the relative radius is off by 2 %
constexpr double CURVED = 50.0;
} // namespace

FixPLMWall::FixPLMWall(LAMMPS *lmp, int narg, char **arg)
    : Fix(lmp, narg, arg), axis(2), side(1.0), height(0.0), region_name(nullptr), region(nullptr), walls(1),
      friction(-1.0), slot_size(SLOT_SIZE), load{0.0, 0.0, 0.0}, state(nullptr), is_curved(false), is_deep(false),
      is_inside(false) {
    const char *usage =
        "expected: fix ID group plm/wall (plane Z | plane AXIS POSITION above|below | region NAME) scenario FILE "
        "[type N FILE] ... [friction MU]";
    if (narg < 7) error->all(FLERR, "Fix plm/wall: {}", usage);
    if (!atom->radius_flag || !atom->rmass_flag)
        error->all(FLERR, "Fix plm/wall needs spheres with radius and mass: use atom_style sphere");
    if (!atom->tag_enable) error->all(FLERR, "Fix plm/wall needs atom IDs");

    units = PLM::units_of(lmp, STYLE);

    int at = 3;
    if (strcmp(arg[at], "plane") == 0) {
        const char *found = strlen(arg[at + 1]) == 1 ? strchr("xyz", arg[at + 1][0]) : nullptr;
        if (found) {
            if (narg < 9) error->all(FLERR, "Fix plm/wall: {}", usage);
            axis = arg[at + 1][0] - 'x';
            height = utils::numeric(FLERR, arg[at + 2], false, lmp);
            if (strcmp(arg[at + 3], "below") == 0)
                side = -1.0;
            else if (strcmp(arg[at + 3], "above") != 0)
                error->all(FLERR, "Fix plm/wall: the spheres are above or below a plane, and not {}; {}", arg[at + 3],
                           usage);
            at += 2;
        } else
            height = utils::numeric(FLERR, arg[at + 1], false, lmp);
        if (domain->periodicity[axis])
            error->all(FLERR, "Fix plm/wall: a plane needs a box that is not periodic in {} (boundary)", "xyz"[axis]);
    } else if (strcmp(arg[at], "region") == 0) {
        region_name = utils::strdup(arg[at + 1]);
        region = domain->get_region_by_id(region_name);
        if (!region) error->all(FLERR, "Fix plm/wall: there is no region {}", region_name);
        walls = region->tmax;
    } else
        error->all(FLERR, "Fix plm/wall: unknown wall {}; {}", arg[at], usage);

    for (at += 2; at < narg;) {
        int type = 0;
        const char *file = nullptr;
        if (strcmp(arg[at], "scenario") == 0 && at + 1 < narg) {
            file = arg[at + 1];
            at += 2;
        } else if (strcmp(arg[at], "type") == 0 && at + 2 < narg) {
            type = utils::inumeric(FLERR, arg[at + 1], false, lmp);
            if (type < 1 || type > atom->ntypes)
                error->all(FLERR, "Fix plm/wall: type {} is not one of the {} atom types", type, atom->ntypes);
            file = arg[at + 2];
            at += 3;
        } else if (strcmp(arg[at], "friction") == 0 && at + 1 < narg) {
            friction = PLM::friction_of(lmp, STYLE, arg[at + 1]);
            slot_size = SLOT_SIZE_FRICTION;
            at += 2;
            continue;
        } else
            error->all(FLERR, "Fix plm/wall: unknown or incomplete keyword {}; {}", arg[at], usage);
        if (contacts.count(type))
            error->all(FLERR, "Fix plm/wall: two scenarios for the same spheres; the second is {}", file);
        plm_contact *contact = PLM::open_contact(lmp, STYLE, file);
        if (plm_contact_effective_radius(contact) != plm_contact_radius(contact))
            error->all(FLERR,
                       "Fix plm/wall: {}: half_space.radius curves the wall, and the law of a curved wall does not "
                       "scale to spheres of "
                       "other radii; leave it out",
                       file);
        contacts[type] = contact;
    }

    for (int type = 0; type <= atom->ntypes; type++) {
        const auto found = contacts.count(type) ? contacts.find(type) : contacts.find(0);
        const plm_contact *contact = found == contacts.end() ? nullptr : found->second;
        // 52 bits, which a double holds exactly
        laws.push_back({contact, contact ? plm_contact_radius(contact) / units.length : 0.0,
                        contact ? plm_contact_validated_indentation(contact) : 0.0,
                        static_cast<double>(plm_contact_fingerprint(contact) >> 12)});
    }

    values = FIRST_SLOT + slot_size * walls;
    scalar_flag = vector_flag = 1;
    size_vector = 5;
    extscalar = extvector = 1;
    global_freq = 1;
    energy_global_flag = 1;
    peratom_flag = 1;
    size_peratom_cols = ENDED; // dent depth and plastic work
    peratom_freq = 1;
    restart_peratom = 1;
    create_attribute = 1;
    maxexchange = values;

    FixPLMWall::grow_arrays(atom->nmax);
    atom->add_callback(Atom::GROW);
    atom->add_callback(Atom::RESTART);
    for (int i = 0; i < atom->nlocal; i++) FixPLMWall::set_arrays(i);
}

FixPLMWall::~FixPLMWall() {
    atom->delete_callback(id, Atom::GROW);
    atom->delete_callback(id, Atom::RESTART);
    memory->destroy(state);
    delete[] region_name;
    for (const auto &entry : contacts) plm_contact_free(entry.second);
}

int FixPLMWall::setmask() { return POST_FORCE; }

void FixPLMWall::init() {
    if (region_name) {
        region = domain->get_region_by_id(region_name);
        if (!region) error->all(FLERR, "Fix plm/wall: region {} is gone", region_name);
        if (region->dynamic_check() || region->varshape)
            error->all(FLERR, "Fix plm/wall: region {} moves; the law is that of a wall at rest", region_name);
    }
    if (utils::strmatch(update->integrate_style, "^respa"))
        error->all(FLERR, "Fix plm/wall: run_style respa is not supported");
}

void FixPLMWall::setup(int vflag) {
    post_force(vflag);
    advise();
}

/* Reports once which time step is needed for the shortest contact, and what waves would take of the fastest impact. By
   the same scaling, a speed v is v sqrt(density ratio) for the sphere of the scenario. */
void FixPLMWall::advise() {
    for (int i = 0; i < atom->nlocal; i++) {
        if (!(atom->mask[i] & groupbit)) continue;
        const plm_contact *contact = laws[atom->type[i]].contact;
        if (!contact) error->one(FLERR, "Fix plm/wall: no scenario for atoms of type {}", atom->type[i]);
        const double *v = atom->v[i];
        double speed = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) * units.length / units.time;
        const double scale = scale_of(i);
        const double denser = sqrt(atom->rmass[i] * units.mass * scale * scale * scale / plm_contact_mass(contact));
        if (speed == 0.0) speed = plm_contact_yield_speed(contact) / denser;
        double e;
        const double time = plm_contact_time(contact, speed * denser, &e) * denser / scale / units.time;
        advice.add(time, e, plm_contact_restitution_with_waves(contact, speed * denser));
    }
    advice.report(lmp, STYLE);
}

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
    const plm_contact *contact = law.contact;
    if (!contact) error->one(FLERR, "Fix plm/wall: no scenario for atoms of type {}", atom->type[i]);
    const double scale = scale_of(i);
    const double overlap = atom->radius[i] - distance;
    const double indentation = overlap * units.length * scale;
    if (is_new && !is_inside) {
        const double *v = atom->v[i];
        const double way = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) * update->dt;
        if (overlap > MAX_FIRST_OVERLAP_STEPS * way + ROUNDING * atom->radius[i]) {
            is_inside = true;
            error->warning(FLERR,
                           "Fix plm/wall: the initial overlap adds spurious energy. Sphere {} is {:.3g} deep in the "
                           "wall when it first touches it, "
                           "and moves {:.3g} in a step. Place spheres outside of the wall",
                           atom->tag[i], overlap, way);
        }
    }
    const double peak = slot[MEMORY], previous_indentation = slot[NOW];
    const double of_contact = plm_contact_force(contact, indentation, slot + MEMORY);
    const double force = of_contact / (scale * scale) / units.force;
    if (!std::isfinite(force))
        error->one(FLERR, "Fix plm/wall: the force on sphere {} is not finite: is the timestep too long?",
                   atom->tag[i]);
    double *f = atom->f[i];
    for (int k = 0; k < 3; k++) {
        f[k] += force * normal[k];
        load[k] -= force * normal[k];
    }
    if (friction >= 0.0)
        add_friction(i, contact, normal, {previous_indentation, indentation, of_contact, slot + MEMORY}, slot);

    if (indentation > law.validated_indentation && !is_deep) {
        is_deep = true;
        error->warning(FLERR,
                       "Fix plm/wall: force, dent and e of sphere {} are estimates: its overlap {:.3g} exceeds the "
                       "validated {:.3g} for this "
                       "radius",
                       atom->tag[i], overlap, law.validated_indentation / scale / units.length);
    }
    // the plastic work changes only if the dent grows
    if (slot[MEMORY] != peak) plm_contact_energy(contact, indentation, of_contact, slot + MEMORY, slot + TAKEN);
    slot[NOW] = indentation;
    state[i][DENT] = (slot[MEMORY] - slot[MEMORY + 2]) / scale / units.length;
    state[i][PLASTIC] += slot[TAKEN] / energy_scale(scale);
}

/* Adds friction and its torque: one tangential spring, whose force is its memory. The lever arm is the radius. */
void FixPLMWall::add_friction(int i, const plm_contact *contact, const double *n, const PLM::Step &step, double *slot) {
    const double scale = scale_of(i), radius = atom->radius[i], *v = atom->v[i], *w = atom->omega[i];
    double *history = slot + FRICTION;
    // velocity of the contact point, v - w x R n, along the wall
    double slip[] = {v[0] - radius * (w[1] * n[2] - w[2] * n[1]), v[1] - radius * (w[2] * n[0] - w[0] * n[2]),
                     v[2] - radius * (w[0] * n[1] - w[1] * n[0])};
    PLM::project(slip, n, false);
    for (double &part : slip) part *= update->dt * units.length * scale;
    // the setup of a run has no step before it
    if (!update->setupflag && !PLM::update_friction(contact, friction, n, step, slip, history))
        error->one(FLERR, "Fix plm/wall: the friction on sphere {} is not finite: is the timestep too long?",
                   atom->tag[i]);
    double *f = atom->f[i], *torque = atom->torque[i], t[3];
    for (int k = 0; k < 3; k++) {
        t[k] = history[k] / (scale * scale) / units.force;
        f[k] += t[k];
        load[k] -= t[k];
    }
    torque[0] -= radius * (n[1] * t[2] - n[2] * t[1]);
    torque[1] -= radius * (n[2] * t[0] - n[0] * t[2]);
    torque[2] -= radius * (n[0] * t[1] - n[1] * t[0]);
}

/* Radius of the sphere of the scenario over the radius of sphere i. */
double FixPLMWall::scale_of(int i) const { return laws[atom->type[i]].radius / atom->radius[i]; }

/* Divides an energy of the scenario's contact, to get the energy of a sphere of another radius in units of LAMMPS. */
double FixPLMWall::energy_scale(double scale) const { return scale * scale * scale * units.force * units.length; }

/* The sphere has left the surface: its plastic work is kept, and the next contact is a fresh one. */
void FixPLMWall::end_contact(int i, double *slot) {
    const double taken = slot[TAKEN] / energy_scale(scale_of(i));
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
            const plm_contact *contact = laws[atom->type[i]].contact;
            double memory[] = {slot[MEMORY], slot[MEMORY + 1], slot[MEMORY + 2]};
            const double force = plm_contact_force(contact, slot[NOW], memory);
            energy += plm_contact_energy(contact, slot[NOW], force, memory, nullptr) / energy_scale(scale_of(i));
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
    double *extra = atom->extra[i];
    int at = 0;
    for (int skipped = 0; skipped < nth; skipped++) at += static_cast<int>(extra[at]);
    if (static_cast<int>(extra[at]) != values + RESTART_HEADER)
        error->one(FLERR, "Fix plm/wall: the restart file was written with another wall, with or without friction, or "
                          "by an older version; give "
                          "this fix another ID to begin with fresh contacts");
    if (extra[at + 1] != laws[atom->type[i]].fingerprint)
        error->one(FLERR,
                   "Fix plm/wall: the restart file was written with another scenario for atoms of type {}, and the "
                   "dents in it belong to that "
                   "one; use its file, or give this fix another ID to begin with fresh contacts",
                   atom->type[i]);
    std::copy_n(extra + at + RESTART_HEADER, values, state[i]);
}

int FixPLMWall::size_restart(int /*i*/) { return values + RESTART_HEADER; }

int FixPLMWall::maxsize_restart() { return values + RESTART_HEADER; }
