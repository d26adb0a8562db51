/* {title}
 *
 * Made by plm-impact {version}; SPDX-License-Identifier: MIT
 * {command}
 * scenario {scenario}, SHA-256 {sha256}
 *
 * Law: {law}
 * Pair: {pair}
 * Validated up to an indentation of {validated}. From there the force is an estimate. The polynomials end at {end}.
 * Units are SI: m, N, N/m, J. The force has no damping, gravity or elastic waves.
 *
 * C99, C++, CUDA and HIP. Before this header is included, these macros may be defined:
 *   PLM_REAL   double (the default) or float
 *   PLM_FN     how functions are declared: static inline, and __host__ __device__ where the compiler is that of a GPU
 *   PLM_POW, PLM_SQRT   powers and roots, such as powf and sqrtf for float
 *
 * A contact has a memory of three numbers, which are zero at first contact. Set the memory to zero when the sphere has left the
 * surface (indentation <= 0), not when the force becomes zero. The numbers are the three doubles of plm_impact.h.
 */
#ifndef PLM_{NAME}_H
#define PLM_{NAME}_H

#include <math.h>

#ifndef PLM_REAL
#define PLM_REAL double
#endif
#ifndef PLM_FN
#if defined(__CUDACC__) || defined(__HIPCC__)
#define PLM_FN static inline __host__ __device__
#else
#define PLM_FN static inline
#endif
#endif
#ifndef PLM_POW
#define PLM_POW(base, exponent) ((PLM_REAL)pow((base), (exponent)))
#endif
#ifndef PLM_SQRT
#define PLM_SQRT(x) ((PLM_REAL)sqrt(x))
#endif

#define PLM_{NAME}_RADIUS ((PLM_REAL){radius})             /* of the sphere [m] */
#define PLM_{NAME}_MASS ((PLM_REAL){mass})                 /* of the relative motion [kg] */
#define PLM_{NAME}_VALIDATED ((PLM_REAL){validated_value}) /* indentation up to which the law is validated [m] */
#define PLM_{NAME}_LENGTH ((PLM_REAL){length})             /* unit of lengths in the table [m] */
#define PLM_{NAME}_FORCE ((PLM_REAL){force})               /* unit of forces in the table [N] */
#define PLM_{NAME}_YIELDS {yields}
#define PLM_{NAME}_INTERVALS {n_intervals}
#define PLM_{NAME}_TERMS {n_terms}

/* Largest state of a contact so far. */
typedef struct {
    PLM_REAL peak_indentation; /* [m] */
    PLM_REAL peak_force;       /* [N] */
    PLM_REAL elastic_approach; /* part of the peak indentation that unloading recovers [m] */
} plm_{name}_memory;

/* The polynomials of an interval, in t = (x - middle)/half from -1 to 1. */
typedef struct {
    PLM_REAL middle, inverse_half;
    PLM_REAL force[PLM_{NAME}_TERMS];
    PLM_REAL elastic_approach[PLM_{NAME}_TERMS];
    PLM_REAL exponent[PLM_{NAME}_TERMS];
    PLM_REAL plastic[PLM_{NAME}_TERMS];{relaxed_fields}
} plm_{name}_interval;

/* x where the intervals begin; a contact that turns before the first one leaves no dent. */
PLM_FN PLM_REAL plm_{name}_start(int i) {
    static const PLM_REAL start[PLM_{NAME}_INTERVALS + 1] = {
{starts}    };
    return start[i];
}

PLM_FN const plm_{name}_interval *plm_{name}_table(int i) {
    static const plm_{name}_interval table[{table_size}] = {
{table}    };
    return &table[i];
}

/* The last interval that begins below x. */
PLM_FN const plm_{name}_interval *plm_{name}_interval_at(PLM_REAL x) {
    int low = 0, high = PLM_{NAME}_INTERVALS;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        if (plm_{name}_start(middle) <= x) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return plm_{name}_table(low);
}

PLM_FN PLM_REAL plm_{name}_parameter(const plm_{name}_interval *at, PLM_REAL x) {
    const PLM_REAL t = (x - at->middle) * at->inverse_half;
    return t < 1 ? t : 1;
}

/* Even and odd terms apart, so that neither waits for the other. */
PLM_FN PLM_REAL plm_{name}_value(const PLM_REAL *terms, PLM_REAL t) {
    const PLM_REAL square = t * t;
    PLM_REAL even = terms[PLM_{NAME}_TERMS - 2], odd = terms[PLM_{NAME}_TERMS - 1];
    int i;
    for (i = PLM_{NAME}_TERMS - 4; i >= 0; i -= 2) {
        even = even * square + terms[i];
        odd = odd * square + terms[i + 1];
    }
    return even + t * odd;
}

/* dp/dx of a polynomial. */
PLM_FN PLM_REAL plm_{name}_slope(const plm_{name}_interval *at, const PLM_REAL *terms, PLM_REAL t) {
    PLM_REAL sum = 0;
    int i;
    for (i = PLM_{NAME}_TERMS - 1; i > 0; i--) {
        sum = sum * t + (PLM_REAL)i * terms[i];
    }
    return sum * at->inverse_half;
}

PLM_FN PLM_REAL plm_{name}_loading(PLM_REAL x) {
    const plm_{name}_interval *at;
    PLM_REAL t, beyond;
    if (!(x > plm_{name}_start(0))) {
        return x * PLM_SQRT(x);
    }
    at = plm_{name}_interval_at(x);
    t = plm_{name}_parameter(at, x);
    beyond = x - plm_{name}_start(PLM_{NAME}_INTERVALS);
    /* beyond the last interval the force follows its tangent */
    return plm_{name}_value(at->force, t) + (beyond > 0 ? beyond * plm_{name}_slope(at, at->force, t) : 0);
}

/* The unloading branch from the peak of a memory: force = peak ((indentation - residual)/approach)^exponent. */
typedef struct {
    PLM_REAL peak, approach, exponent, plastic;
} plm_{name}_branch;

PLM_FN plm_{name}_branch plm_{name}_unload(const plm_{name}_memory *memory) {
    const PLM_REAL x = memory->peak_indentation / PLM_{NAME}_LENGTH;
    plm_{name}_branch branch;
    branch.peak = memory->peak_force;
    branch.approach = memory->elastic_approach;
    branch.exponent = (PLM_REAL)1.5;
    branch.plastic = 0;
    if (x > plm_{name}_start(0)) {
        const plm_{name}_interval *at = plm_{name}_interval_at(x);
        const PLM_REAL t = plm_{name}_parameter(at, x);
        const PLM_REAL plastic = plm_{name}_value(at->plastic, t);
        branch.exponent = plm_{name}_value(at->exponent, t);
        branch.plastic = plastic > 0 ? plastic * (PLM_{NAME}_FORCE * PLM_{NAME}_LENGTH) : 0;{relaxed_branch}
    }
    return branch;
}

/* Force [N] at an indentation [m]; a new largest state is stored in the memory. 0 for an indentation of 0 or less. */
PLM_FN PLM_REAL plm_{name}_force(PLM_REAL indentation, plm_{name}_memory *memory) {
    PLM_REAL x, force;
    if (!(indentation > 0)) {
        return indentation < 0 ? 0 : indentation; /* NaN stays NaN */
    }
    if (indentation == memory->peak_indentation) {
        return memory->peak_force;
    }
    if (indentation < memory->peak_indentation) {
        const plm_{name}_branch branch = plm_{name}_unload(memory);
        const PLM_REAL recovered = (indentation - memory->peak_indentation) + branch.approach;
        return recovered > 0 ? branch.peak * PLM_POW(recovered / branch.approach, branch.exponent) : 0;
    }
    x = indentation / PLM_{NAME}_LENGTH;
    force = plm_{name}_loading(x) * PLM_{NAME}_FORCE;{relaxed_loading}
    if (PLM_{NAME}_YIELDS) {
        memory->peak_indentation = indentation;
        memory->peak_force = force;
        memory->elastic_approach = indentation;
        if (x > plm_{name}_start(0)) {
            const plm_{name}_interval *at = plm_{name}_interval_at(x);
            const PLM_REAL approach = plm_{name}_value(at->elastic_approach, plm_{name}_parameter(at, x));
            memory->elastic_approach = approach * PLM_{NAME}_LENGTH;
        }
    }
    return force;
}

/* Tangent stiffness [N/m]: of the unloading branch up to the largest indentation so far, of the loading curve beyond it. */
PLM_FN PLM_REAL plm_{name}_stiffness(PLM_REAL indentation, const plm_{name}_memory *memory) {
    const PLM_REAL x = indentation / PLM_{NAME}_LENGTH;
    if (!(indentation > 0)) {
        return 0;
    }
    if (indentation <= memory->peak_indentation) {
        const plm_{name}_branch branch = plm_{name}_unload(memory);
        const PLM_REAL share = ((indentation - memory->peak_indentation) + branch.approach) / branch.approach;
        const PLM_REAL steepest = branch.exponent * branch.peak / branch.approach;
        return share > 0 ? steepest * PLM_POW(share, branch.exponent - 1) : 0;
    }
    if (x > plm_{name}_start(0)) {
        const plm_{name}_interval *at = plm_{name}_interval_at(x);
        const PLM_REAL slope = plm_{name}_slope(at, at->force, plm_{name}_parameter(at, x));
        return slope * (PLM_{NAME}_FORCE / PLM_{NAME}_LENGTH);
    }
    return (PLM_REAL)1.5 * PLM_SQRT(x) * (PLM_{NAME}_FORCE / PLM_{NAME}_LENGTH);
}

/* Energies [J] after plm_{name}_force gave this memory: the stored energy, which unloading gives back, and the plastic work. */
PLM_FN void plm_{name}_energy(PLM_REAL indentation, const plm_{name}_memory *memory, PLM_REAL *stored, PLM_REAL *plastic) {
    const PLM_REAL x = indentation / PLM_{NAME}_LENGTH;
    *stored = 0;
    *plastic = 0;
    if (!PLM_{NAME}_YIELDS) {
        if (x > 0) {
            *stored = (PLM_REAL)0.4 * x * plm_{name}_loading(x) * (PLM_{NAME}_FORCE * PLM_{NAME}_LENGTH);
        }
    } else if (memory->peak_indentation > 0) {
        const plm_{name}_branch branch = plm_{name}_unload(memory);
        const PLM_REAL share = ((indentation - memory->peak_indentation) + branch.approach) / branch.approach;
        const PLM_REAL whole = branch.peak * branch.approach / (branch.exponent + 1);
        *stored = share > 0 ? whole * PLM_POW(share, branch.exponent + 1) : 0;
        *plastic = branch.plastic;
    }
}

/* plm_{name}_force for a sphere of another radius [m], with a memory of its own. The law scales exactly with {what_scales}. */
PLM_FN PLM_REAL plm_{name}_scaled_force(PLM_REAL indentation, PLM_REAL radius, plm_{name}_memory *memory) {
    const PLM_REAL scale = PLM_{NAME}_RADIUS / radius;
    plm_{name}_memory own;
    PLM_REAL before, force;
    own.peak_indentation = memory->peak_indentation * scale;
    own.peak_force = memory->peak_force * scale * scale;
    own.elastic_approach = memory->elastic_approach * scale;
    before = own.peak_indentation;
    force = plm_{name}_force(indentation * scale, &own) / (scale * scale);
    if (own.peak_indentation != before) {
        memory->peak_indentation = indentation;
        memory->peak_force = force;
        memory->elastic_approach = own.elastic_approach / scale;
    }
    return force;
}

#endif
