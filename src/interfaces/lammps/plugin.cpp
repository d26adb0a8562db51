/* The interface of the plug-in to LAMMPS.
   SPDX-License-Identifier: GPL-2.0-or-later */

#include "fix_plm_energy.h"
#include "fix_plm_wall.h"
#include "library.h"
#include "pair_plm.h"

#include <cstdio>

namespace {

/* The structure that LAMMPS needs from a plug-in, as in its manual (section "Writing plugins"). */
struct Plugin {
    const char *version, *style, *name, *info, *author;
    union {
        void *(*v1)(void *);
        void *(*v2)(void *, int, char **);
    } creator;
    void *handle;
};

template <typename Made> void *make_fix(void *lmp, int narg, char **arg) {
    return new Made(static_cast<LAMMPS_NS::LAMMPS *>(lmp), narg, arg);
}

void *make_pair(void *lmp) { return new LAMMPS_NS::PairPLM(static_cast<LAMMPS_NS::LAMMPS *>(lmp)); }

} // namespace

/* PLM_LAMMPS_VERSION and PLM_LAMMPS_NAME are number and name of the LAMMPS whose headers were used; see build.py. */
extern "C" void lammpsplugin_init(void *lmp, void *handle, void *regfunc) {
    const int version = lammps_version(lmp);
    if (version != PLM_LAMMPS_VERSION) {
        fprintf(stderr,
                "plm-impact: this plug-in is for LAMMPS %d and was loaded by LAMMPS %d; it is left out. "
                "Build it again with src/interfaces/lammps/build.py\n",
                PLM_LAMMPS_VERSION, version);
        return;
    }
    const auto add = reinterpret_cast<void (*)(Plugin *, void *)>(regfunc);
    Plugin plugin{};
    plugin.version = PLM_LAMMPS_NAME;
    plugin.author = "plm-impact";
    plugin.handle = handle;
    plugin.style = "fix";
    plugin.name = "plm/wall";
    plugin.info = "spheres against a wall by the contact law of plm-impact";
    plugin.creator.v2 = &make_fix<LAMMPS_NS::FixPLMWall>;
    add(&plugin, lmp);
    plugin.name = "plm/energy";
    plugin.info = "where the energy of the contacts of pair_style plm is";
    plugin.creator.v2 = &make_fix<LAMMPS_NS::FixPLMEnergy>;
    add(&plugin, lmp);
    plugin.style = "pair";
    plugin.name = "plm";
    plugin.info = "spheres against spheres by the contact law of plm-impact";
    plugin.creator.v1 = &make_pair;
    add(&plugin, lmp);
}
