/* The contacts of two spheres of any radii, of one scenario.
   SPDX-License-Identifier: GPL-2.0-or-later */

#ifndef LMP_PLM_BALLS_H
#define LMP_PLM_BALLS_H

#include "plm_common.h"

#include <cstdint>
#include <map>
#include <vector>

namespace LAMMPS_NS {
namespace PLM {

/* The contact of two spheres. Its numbers are those of spheres of another size, with the same ratio of radii: multiply
   a length of LAMMPS by length to get that of the contact, and a force and an energy of the contact by per_force and
   per_energy to get those of LAMMPS. */
struct Balls {
    const plm_contact *contact;
    double length, per_force, per_energy;
    double validated; // the indentation of the contact up to which the data behind the law reach
};

/* The law of two types of spheres. With one material the larger sphere is the sphere of the scenario, so that a pair
   has the same contact from both sides. */
class PairLaw {
  public:
    PairLaw(plm_contact *of_scenario, bool has_one_material);
    ~PairLaw();
    PairLaw(const PairLaw &) = delete;
    PairLaw &operator=(const PairLaw &) = delete;

    /* The contact of two radii in metres, of the first and of the second type; nullptr if there is none. Its ratio of
       radii is exact, or that of the nearest of STEPS_A_DECADE in a decade. */
    const plm_contact *between(double first, double second, bool is_exact);

    const plm_contact *scenario() const { return base; }

  private:
    plm_contact *base;
    bool has_one_material;
    std::map<double, plm_contact *> made; // by ratio of radii
};

/* Finds the contact of two spheres in every step: a table by the radii. */
class Finder {
  public:
    explicit Finder(const Units &units) : units(units), found(SIZE), last(&found[0]) {}
    Finder(const Finder &) = delete;
    Finder &operator=(const Finder &) = delete;
    /* The radii that have an exact contact, in units of LAMMPS and sorted. */
    void set_exact(const std::vector<double> &radii);
    double memory_usage() const { return found.size() * sizeof(Entry); }
    const Balls &find(PairLaw *law, double first, double second) {
        if (!last->is_of(law, first, second)) {
            last = &found[place(law, first, second)];
            if (!last->is_of(law, first, second)) make(*last, law, first, second);
        }
        return last->balls;
    }

  private:
    struct Entry {
        PairLaw *law = nullptr;
        double first = 0.0, second = 0.0;
        Balls balls{nullptr, 0.0, 0.0, 0.0, 0.0};
        bool is_of(const PairLaw *one, double a, double b) const { return law == one && first == a && second == b; }
    };
    static constexpr int BITS = 13, SIZE = 1 << BITS;
    static std::size_t place(const PairLaw *law, double first, double second);
    void make(Entry &entry, PairLaw *law, double first, double second);

    Units units;
    std::vector<Entry> found;
    Entry *last; // many contacts in a row are of the same radii
    std::vector<double> exact;
};

} // namespace PLM
} // namespace LAMMPS_NS

#endif
