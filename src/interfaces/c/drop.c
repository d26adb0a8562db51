/* Drops the ball of a scenario on its half-space at 3 m/s and prints e. SPDX-License-Identifier: MIT */
#include <stdio.h>

#include "plm_impact.h"

int main(int count, char **arguments) {
    char error[512] = "usage: drop SCENARIO";
    plm_contact *contact = count == 2 ? plm_contact_open(arguments[1], error, sizeof error) : NULL;
    if (contact == NULL) {
        fprintf(stderr, "%s\n", error);
        return 1;
    }
    const double start = 3.0, dt = 1e-8, mass = plm_contact_mass(contact);
    double indentation = 0.0, speed = start, force = 0.0; /* m, m/s, N */
    double memory[3] = {0.0, 0.0, 0.0};                   /* of this contact: zero when it begins */
    do { /* velocity Verlet, to the place where the ball leaves the surface */
        speed -= 0.5 * dt * force / mass;
        indentation += dt * speed;
        force = plm_contact_force(contact, indentation, memory);
        speed -= 0.5 * dt * force / mass;
    } while (indentation > 0.0);
    printf("e %.6f\n", -speed / start);
    plm_contact_free(contact);
    return 0;
}
