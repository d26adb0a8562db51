/* The contacts of two spheres of any radii, of one scenario.
   SPDX-License-Identifier: GPL-2.0-or-later */

#include "plm_balls.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

using namespace LAMMPS_NS;

namespace {
// contacts of a decade of the ratio of radii: e changes by less than 1e-5 from one to the next
// (tests/lammps/test_pair.py)
constexpr double STEPS_A_DECADE = 1024.0;
} // namespace

PLM::PairLaw::PairLaw(plm_contact *of_scenario, bool has_one_material)
    : base(of_scenario), has_one_material(has_one_material) {}

PLM::PairLaw::~PairLaw() {
    for (const auto &entry : made) plm_contact_free(entry.second);
    plm_contact_free(base);
}

const plm_contact *PLM::PairLaw::between(double first, double second, bool is_exact) {
    if (has_one_material && first < second) std::swap(first, second);
    double ratio = first / second;
    if (!is_exact) ratio = pow(10.0, std::round(log10(ratio) * STEPS_A_DECADE) / STEPS_A_DECADE);
    plm_contact *&contact = made[ratio];
    const double radius = plm_contact_radius(base);
    if (!contact) contact = plm_contact_between(base, radius, radius / ratio);
    return contact;
}

void PLM::Finder::set_exact(const std::vector<double> &radii) {
    exact = radii;
    std::fill(found.begin(), found.end(), Entry());
}

std::size_t PLM::Finder::place(const PairLaw *law, double first, double second) {
    std::uint64_t one, other;
    std::memcpy(&one, &first, sizeof(one));
    std::memcpy(&other, &second, sizeof(other));
    const std::uint64_t mixed = (one * 3 + other + reinterpret_cast<std::uintptr_t>(law)) * 0x9e3779b97f4a7c15ULL;
    return mixed >> (64 - BITS);
}

void PLM::Finder::make(Entry &entry, PairLaw *law, double first, double second) {
    const auto has = [&](double radius) { return std::binary_search(exact.begin(), exact.end(), radius); };
    const plm_contact *contact = law->between(first * units.length, second * units.length, has(first) && has(second));
    const double effective = first * second / (first + second) * units.length;
    const double scale = contact ? plm_contact_effective_radius(contact) / effective : 0.0;
    entry.law = law;
    entry.first = first;
    entry.second = second;
    entry.balls = {contact, units.length * scale, 1.0 / (scale * scale * units.force),
                   1.0 / (scale * scale * scale * units.force * units.length),
                   contact ? plm_contact_validated_indentation(contact) : 0.0};
}
