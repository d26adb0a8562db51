/* fix plm/wall: spheres against a flat wall by the contact law of plm-impact.
   SPDX-License-Identifier: GPL-2.0-or-later */

#ifndef LMP_FIX_PLM_WALL_H
#define LMP_FIX_PLM_WALL_H

#include "fix.h"
#include "plm_impact.h"

#include <map>
#include <vector>
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
  void touch(int i, double nx, double ny, double nz, double distance, double *slot);
  void leave(int i, double *slot);
  void advise();
  double scale_of(int i) const;
  double of_energy(double scale) const;

  double height;                              // of the plane
  char *region_name;                          // or the region whose surface is the wall
  class Region *region;
  int walls;                                  // contacts that a sphere can have at once
  int values;                                 // doubles of a sphere: the columns below, and a slot for each of its contacts
  std::map<int, plm_contact *> contacts;      // by atom type; 0 stands for all others
  struct Law {
    const plm_contact *contact;
    double radius;                            // of the sphere of its scenario
  };
  std::vector<Law> laws;                      // of every atom type
  double length_unit, force_unit, mass_unit, time_unit;    // of LAMMPS, in SI
  double **state;                             // dent depth, plastic work of ended contacts, then the slots
  bool is_advised;
  bool is_curved;                             // and that was said
};

}    // namespace LAMMPS_NS

#endif
