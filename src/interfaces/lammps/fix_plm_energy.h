/* fix plm/energy: where the energy of the contacts of pair_style plm is.
   SPDX-License-Identifier: GPL-2.0-or-later */

#ifndef LMP_FIX_PLM_ENERGY_H
#define LMP_FIX_PLM_ENERGY_H

#include "fix.h"

namespace LAMMPS_NS {

class FixPLMEnergy : public Fix {
  public:
    /* The work that contacts take: of dents, of friction and of rolling. */
    enum Work { PLASTIC, FRICTION, ROLLING, WORKS };

    FixPLMEnergy(class LAMMPS *, int, char **);
    ~FixPLMEnergy() override;
    int setmask() override;
    void init() override;
    void setup_pre_force(int) override;
    void pre_force(int) override;
    void setup(int) override;
    void post_force(int) override;

    /* The work of one contact in one step, of which each sphere gets a half. A contact that two ranks compute counts
       half in each. */
    void add(Work work, double share, double energy, int i, int j);
    /* The pair style is gone. */
    void forget(const class PairPLM *);

    double compute_scalar() override;
    double compute_vector(int) override;
    double memory_usage() override;

    void grow_arrays(int) override;
    void copy_arrays(int, int, int) override;
    void set_arrays(int) override;
    int pack_reverse_comm(int, int, double *) override;
    void unpack_reverse_comm(int, int *, double *) override;
    int pack_exchange(int, double *) override;
    int unpack_exchange(int, double *) override;
    int pack_restart(int, double *) override;
    void unpack_restart(int, int) override;
    int size_restart(int) override;
    int maxsize_restart() override;
    void write_restart(FILE *) override;
    void restart(char *) override;

  private:
    class PairPLM *pair;
    double done[WORKS]; // of this rank since the start; rank 0 has that of the runs before a restart
    double of_restart;  // fingerprint in the restart file; 0 without one
    double **work;      // of every sphere: plastic work, and the work of friction and rolling
};

} // namespace LAMMPS_NS

#endif
