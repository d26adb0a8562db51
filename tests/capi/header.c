/* The header of a contact beside the C functions, in one program: the largest deviation of the force relative to the
   peak force, and the time of a force. Arguments: the scenario that the header was made of. See tests/capi.rs. */
#define _POSIX_C_SOURCE 199309L
#include <stdio.h>
#include <time.h>

#include "plm_impact.h"
#include "plm_steel.h"

enum { STATES = 4000, ROUNDS = 25, REPEATS = 20 };

static double now(void) {
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return 1e9 * (double)time.tv_sec + (double)time.tv_nsec;
}

/* Loading, unloading, reloading beyond the old peak, and unloading until the sphere has left. */
static double path(int i, double deepest) {
    static const double turns[] = {0.0, 0.6, 0.45, 1.0, -0.01};
    const int leg = i / (STATES / 4);
    const double share = (double)(i % (STATES / 4)) / (STATES / 4);
    return deepest * (turns[leg] + share * (turns[leg + 1] - turns[leg]));
}

int main(int argc, char **argv) {
    char error[512] = "";
    plm_contact *contact = plm_contact_open(argc > 1 ? argv[1] : "", error, sizeof error);
    static double indentations[STATES];
    double deviation = 0.0, peak = 0.0, best[2] = {1e300, 1e300}, sum = 0.0;
    int round, repeat, i;
    if (contact == NULL) {
        puts(error);
        return 1;
    }
    for (i = 0; i < STATES; i++) {
        indentations[i] = path(i, 0.5 * PLM_STEEL_VALIDATED);
    }
    for (round = 0; round < ROUNDS; round++) {
        double begin = now(), middle, end;
        for (repeat = 0; repeat < REPEATS; repeat++) {
            double memory[3] = {0.0, 0.0, 0.0};
            for (i = 0; i < STATES; i++) {
                sum += plm_contact_force(contact, indentations[i], memory);
            }
        }
        middle = now();
        for (repeat = 0; repeat < REPEATS; repeat++) {
            plm_steel_memory memory = {0.0, 0.0, 0.0};
            for (i = 0; i < STATES; i++) {
                sum -= plm_steel_force(indentations[i], &memory);
            }
        }
        end = now();
        best[0] = middle - begin < best[0] ? middle - begin : best[0];
        best[1] = end - middle < best[1] ? end - middle : best[1];
    }
    {
        double memory[3] = {0.0, 0.0, 0.0};
        plm_steel_memory own = {0.0, 0.0, 0.0};
        for (i = 0; i < STATES; i++) {
            const double a = plm_contact_force(contact, indentations[i], memory);
            const double b = plm_steel_force(indentations[i], &own);
            peak = memory[1] > peak ? memory[1] : peak;
            deviation = fabs(a - b) > deviation ? fabs(a - b) : deviation;
        }
    }
    printf("deviation %.1e, a force takes %.1f ns by the function, %.1f ns by the header (%.0e)\n", deviation / peak,
           best[0] / (STATES * REPEATS), best[1] / (STATES * REPEATS), sum);
    plm_contact_free(contact);
    return 0;
}
