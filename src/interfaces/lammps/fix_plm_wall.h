/* fix plm/wall: spheres against a flat wall by the contact law of plm-impact.
   SPDX-License-Identifier: GPL-2.0-or-later */

#ifndef LMP_FIX_PLM_WALL_H
#define LMP_FIX_PLM_WALL_H

#include "fix.h"
#include "plm_common.h"

#include <map>
#include <string>
#include <vector>

namespace LAMMPS_NS {

class FixPLMWall : public Fix {
  public:
    FixPLMWall(class LAMMPS *, int, char **);
    ~FixPLMWall() override;
    int setmask() override;
    void init() override;
    void setup(int) override;
    void post_force(int) override;

    double compute_scalar() override;
    double compute_vector(int) override;
    double memory_usage() override;

    void grow_arrays(int) override;
    void copy_arrays(int, int, int) override;
    void set_arrays(int) override;
    int pack_exchange(int, double *) override;
    int unpack_exchange(int, double *) override;
    int pack_restart(int, double *) override;
    void unpack_restart(int, int) override;
    int size_restart(int) override;
    int maxsize_restart() override;

  private:
    /* Columns of a sphere, of which the first two are shown; ENDED is the plastic work of ended contacts. */
    enum { DENT, PLASTIC, ENDED, FIRST_SLOT };
    /* Places in a slot: the number of the wall (0: no contact), the state of the law, and with friction the friction on
       the sphere. All but the first belong to the sphere of the scenario. */
    enum { WALL, STATE, FRICTION = STATE + sizeof(plm_history) / sizeof(double) };
    static constexpr int slot_size_of(bool has_friction) {
        return has_friction ? FRICTION + 3 : static_cast<int>(FRICTION);
    }

    void update_contact(int i, const double *normal, double distance, double *slot, bool is_new);
    void slip_of(int i, const double *normal, double scale, double *slip) const;
    void warn_once(int i, double overlap, double indentation, bool is_new);
    void end_contact(int i, double *slot);
    void advise();
    double scale_of(int i) const;
    double energy_scale(double scale) const;

    int axis;          // direction of the normal of the plane: 0, 1 or 2
    double side;       // 1 for spheres above the plane, -1 below
    double height;     // position of the plane along its normal
    char *region_name; // id of the region whose surface is the wall; null for a plane
    class Region *region;
    int walls;                             // largest number of contacts of one sphere at the same time
    double friction;                       // coefficient of friction; below 0: none
    int slot_size;                         // doubles of a slot
    int values;                            // doubles per sphere: the columns below, and a slot for each contact
    std::map<int, plm_contact *> contacts; // by atom type; type 0 stands for all other types
    struct Law {
        const plm_contact *contact;
        double radius;                // radius of the sphere in the scenario, in units of LAMMPS
        double validated_indentation; // its indentation up to which the data behind the law reach, in metres
        double fingerprint;           // of the contact, for restart files
    };
    std::vector<Law> laws; // the law of every atom type
    PLM::Units units;
    PLM::Advice advice;
    double load[3];                     // force on the wall, of the spheres of this rank
    double **state;                     // per sphere: dent depth, plastic work, that of ended contacts, slots
    bool is_curved, is_deep, is_inside; // what was warned of: a curved region, a dent beyond the data, a start inside
};

} // namespace LAMMPS_NS

#endif
