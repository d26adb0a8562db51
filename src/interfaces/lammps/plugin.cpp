/* The interface of the plug-in to LAMMPS.
   SPDX-License-Identifier: GPL-2.0-or-later */

#include "fix_plm_wall.h"
#include "library.h"

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

void *make(void *lmp, int narg, char **arg) {
    return new LAMMPS_NS::FixPLMWall(static_cast<LAMMPS_NS::LAMMPS *>(lmp), narg, arg);
}

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
    Plugin plugin{};
    plugin.version = PLM_LAMMPS_NAME;
    plugin.style = "fix";
    plugin.name = "plm/wall";
    plugin.info = "spheres against a wall by the contact law of plm-impact";
    plugin.author = "plm-impact";
    plugin.creator.v2 = &make;
    plugin.handle = handle;
    reinterpret_cast<void (*)(Plugin *, void *)>(regfunc)(&plugin, lmp);
}
