/* Vectors of three doubles.
   SPDX-License-Identifier: GPL-2.0-or-later */

#ifndef LMP_PLM_VECTORS_H
#define LMP_PLM_VECTORS_H

#include <cmath>

namespace LAMMPS_NS {
namespace PLM {

inline double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

inline double length(const double *vector) { return std::sqrt(dot(vector, vector)); }

inline void cross(const double *a, const double *b, double *result) {
    result[0] = a[1] * b[2] - a[2] * b[1];
    result[1] = a[2] * b[0] - a[0] * b[2];
    result[2] = a[0] * b[1] - a[1] * b[0];
}

/* Removes the part of a vector that is normal to the surface. */
inline void project(double *vector, const double *normal) {
    const double off = dot(vector, normal);
    for (int k = 0; k < 3; k++) vector[k] -= off * normal[k];
}

/* Turns a vector into the surface and keeps its length, as the force of a spring that turns with the contact. */
inline void turn(double *vector, const double *normal) {
    const double old = dot(vector, vector);
    project(vector, normal);
    const double left = dot(vector, vector);
    if (left > 0.0 && left != old) {
        const double factor = std::sqrt(old / left);
        for (int k = 0; k < 3; k++) vector[k] *= factor;
    }
}

} // namespace PLM
} // namespace LAMMPS_NS

#endif
