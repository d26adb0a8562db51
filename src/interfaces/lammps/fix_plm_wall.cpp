/* fix plm/wall: spheres against a flat wall by the contact law of plm-impact.
   SPDX-License-Identifier: GPL-2.0-or-later

   A contact keeps its state in a slot of each sphere. The state belongs to the sphere of the scenario, with radius R.
   The law of a sphere of another radius r follows by scaling, so one scenario serves all radii: with s = R/r, the
   indentation is multiplied by s and the force is divided by s^2.

   This file reads the command; fix_plm_wall_force.cpp has the forces of a step, and fix_plm_wall_state.cpp what each
   sphere keeps. */

#include "fix_plm_wall.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "memory.h"
#include "plm_vectors.h"
#include "region.h"
#include "update.h"
#include "utils.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using namespace FixConst;

namespace {
constexpr const char *STYLE = "Fix plm/wall";
} // namespace

FixPLMWall::FixPLMWall(LAMMPS *lmp, int narg, char **arg)
    : Fix(lmp, narg, arg), axis(2), side(1.0), height(0.0), region_name(nullptr), region(nullptr), walls(1),
      friction(-1.0), slot_size(slot_size_of(false)), load{0.0, 0.0, 0.0}, state(nullptr), is_curved(false),
      is_deep(false), is_inside(false) {
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
            slot_size = slot_size_of(true);
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
        double speed = PLM::length(atom->v[i]) * units.length / units.time;
        const double scale = scale_of(i);
        const double denser = sqrt(atom->rmass[i] * units.mass * scale * scale * scale / plm_contact_mass(contact));
        if (speed == 0.0) speed = plm_contact_yield_speed(contact) / denser;
        double e;
        const double time = plm_contact_time(contact, speed * denser, &e) * denser / scale / units.time;
        advice.add(time, e, plm_contact_restitution_with_waves(contact, speed * denser));
    }
    advice.report(lmp, STYLE);
}
