/* pair_style plm: spheres against spheres by the contact law of plm-impact.
   SPDX-License-Identifier: GPL-2.0-or-later */

#ifndef LMP_PAIR_PLM_H
#define LMP_PAIR_PLM_H

#include "atom.h"
#include "error.h"
#include "pair.h"
#include "plm_balls.h"

#include <memory>
#include <utility>
#include <vector>

namespace LAMMPS_NS {

class PairPLM : public Pair {
  public:
    explicit PairPLM(class LAMMPS *);
    ~PairPLM() override;
    void compute(int, int) override;
    void settings(int, char **) override;
    void coeff(int, char **) override;
    void init_style() override;
    double init_one(int, int) override;
    void setup() override;
    double single(int, int, int, int, double, double, double, double &) override;
    void transfer_history(double *, double *, int, int) override;
    double memory_usage() override;

    /* Energy stored in the contacts of this rank. */
    double stored_energy();
    /* Of the laws of all pairs of types, for restart files; 52 bits, which a double holds exactly. */
    double fingerprint() const;
    class FixPLMEnergy *account; // who counts plastic and friction work; null without fix plm/energy

  private:
    /* One contact in one step, in units of LAMMPS. The force acts on i, and the normal points to i. */
    struct Contact {
        int i, j;
        double normal[3], overlap, share;
        const PLM::Balls *balls;
        double *history;
    };
    void allocate();
    double advance(const Contact &contact, bool has_energy);
    void slip_of(const Contact &contact, double *slip) const;
    void count_friction(const Contact &contact, const double *slip, const double *before);
    static void add_friction(const Contact &contact, double *force, double *moment);
    void add_rolling(const Contact &contact, double normal_force, double *couple);
    void count_plastic_work(const Contact &contact);
    void warn_once(const Contact &contact, bool is_new);
    const PLM::Balls &balls_of(int i, int j);
    double *history_of(int i, int j);
    static double stored_energy_of(const PLM::Balls &balls, plm_history &state);

    double friction;                   // coefficient; below 0: none
    double rolling_stiffness, rolling; // of the rolling spring, and its coefficient; below 0: none
    int size;                          // doubles of the history of a contact; see PLM::History
    std::vector<std::unique_ptr<PLM::PairLaw>> laws;
    std::vector<std::vector<PLM::PairLaw *>> law; // by types
    std::vector<double> largest;                  // largest radius of every type
    class FixNeighHistory *fix_history;
    PLM::Units units;
    std::unique_ptr<PLM::Finder> finder;
    PLM::Advice advice;
    bool is_deep, is_inside; // what was warned of: a dent beyond the data, a start inside
};

/* The contact of two spheres, of which that of the lower type is the sphere of the scenario. */
inline const PLM::Balls &PairPLM::balls_of(int i, int j) {
    const int *type = atom->type;
    if (type[i] > type[j]) std::swap(i, j);
    const PLM::Balls &balls = finder->find(law[type[i]][type[j]], atom->radius[i], atom->radius[j]);
    if (!balls.contact)
        error->one(FLERR, "Pair plm: there is no contact between spheres of the radii {} and {}", atom->radius[i],
                   atom->radius[j]);
    return balls;
}

} // namespace LAMMPS_NS

#endif
