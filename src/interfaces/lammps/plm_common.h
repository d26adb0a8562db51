/* Shared by fix plm/wall and pair_style plm: units, scenarios, the start inside, the advice on the time step.
   SPDX-License-Identifier: GPL-2.0-or-later */

#ifndef LMP_PLM_COMMON_H
#define LMP_PLM_COMMON_H

#include "plm_impact.h"

namespace LAMMPS_NS {

class LAMMPS;

namespace PLM {

/* Units of LAMMPS, in SI units. */
struct Units {
    double length, mass, time, force;
};

/* The units of this simulation; an error for units without a length in metres. */
Units units_of(LAMMPS *lmp, const char *style);

/* The contact of a scenario file. An error of LAMMPS has the message of the library. */
plm_contact *open_contact(LAMMPS *lmp, const char *style, const char *file);

/* A coefficient of friction from an input script. Friction turns spheres, which need a spin. */
double friction_of(LAMMPS *lmp, const char *style, const char *word);

/* True if a first overlap is no step of a motion from outside: way is that of one step, radius that of the smaller
   sphere. */
bool starts_inside(double overlap, double way, double radius);

/* The record number nth of a sphere in a restart file. A record begins with its number of doubles. */
inline double *restart_record(double *records, int nth) {
    for (; nth > 0; nth--) records += static_cast<int>(*records);
    return records;
}

/* The restitution of the shortest contact and the largest loss by waves, over all ranks. */
class Advice {
  public:
    /* A contact that lasts this long; e of it, and e with elastic waves or NaN. */
    void add(double time, double restitution, double with_waves);
    /* Reports once, on all ranks. */
    void report(LAMMPS *lmp, const char *style);

  private:
    double shortest = 1e300, lost = 0.0, of_law = 0.0;
    bool is_reported = false;
};

} // namespace PLM
} // namespace LAMMPS_NS

#endif
