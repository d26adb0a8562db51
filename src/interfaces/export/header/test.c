/* Proves a build of plm_{name}.h: cc plm_{name}_test.c -lm -o prove && ./prove plm_{name}_vectors.csv
   It follows the states of the file and prints the largest deviation; -DPLM_REAL=float tests the header in float. */
#include <stdio.h>

#include "plm_{name}.h"

static double largest = 0.0;

static void compare(double value, double expected, double scale) {
    const double deviation = fabs(value - expected) / scale;
    largest = deviation > largest || deviation != deviation ? deviation : largest;
}

int main(int argc, char **argv) {
    plm_{name}_memory memory = {0, 0, 0}, scaled = {0, 0, 0};
    const double limit = sizeof(PLM_REAL) == sizeof(double) ? 1e-13 : 1e-5;
    double row[8];
    int n = 0;
    FILE *file = fopen(argc > 1 ? argv[1] : "plm_{name}_vectors.csv", "r");
    char line[512];
    while (file != NULL && fgets(line, sizeof line, file) != NULL) {
        if (sscanf(line, "%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf", row, row + 1, row + 2, row + 3, row + 4, row + 5, row + 6,
                   row + 7) == 8) {
            PLM_REAL stored, plastic, force = plm_{name}_force((PLM_REAL)row[0], &memory);
            const double peak = row[3] > row[1] ? row[3] : row[1], length = row[2] > row[0] ? row[2] : row[0];
            plm_{name}_energy((PLM_REAL)row[0], &memory, &stored, &plastic);
            compare(force, row[1], peak > 0 ? peak : 1);
            compare(memory.peak_indentation, row[2], length > 0 ? length : 1);
            compare(memory.peak_force, row[3], peak > 0 ? peak : 1);
            compare(memory.elastic_approach, row[4], length > 0 ? length : 1);
            compare(stored, row[5], peak > 0 ? peak * length : 1);
            compare(plastic, row[6], peak > 0 ? peak * length : 1);
            /* the slope of a polynomial has two digits less than its value */
            compare(plm_{name}_stiffness((PLM_REAL)row[0], &memory) * row[0], row[7] * row[0], peak > 0 ? 100 * peak : 1);
            force = plm_{name}_scaled_force((PLM_REAL)(2 * row[0]), 2 * PLM_{NAME}_RADIUS, &scaled);
            compare(force / 4, row[1], peak > 0 ? peak : 1);
            if (row[0] <= 0) { /* the sphere has left: the next contact is a fresh one */
                memory.peak_indentation = memory.peak_force = memory.elastic_approach = 0;
                scaled = memory;
            }
            n++;
        }
    }
    printf("%d states, largest deviation %.1e\n", n, largest);
    return n == 0 || !(largest < limit);
}
