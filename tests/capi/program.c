/* Calls the contact law along a path of indentations and prints the bits of the results; see tests/capi.rs. */
#include <inttypes.h>
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>

#include "plm_impact.h"

#define STEPS 400

static const plm_contact *contact;

static uint64_t bits(double number) {
    uint64_t word;
    memcpy(&word, &number, sizeof word);
    return word;
}

/* Indentation: to 30 um, back to 26 um, to 35 um, and out. */
static double path(int step) {
    const double turns[] = {0.0, 30e-6, 26e-6, 35e-6, -1e-6};
    int leg = step / (STEPS / 4);
    double share = (double)(step % (STEPS / 4)) / (STEPS / 4);
    return turns[leg] + share * (turns[leg + 1] - turns[leg]);
}

/* Writes the forces along the path to its argument. */
static void *along(void *forces) {
    double memory[3] = {0.0, 0.0, 0.0};
    for (int step = 0; step < STEPS; step++) {
        ((double *)forces)[step] = plm_contact_force(contact, path(step), memory);
    }
    return NULL;
}

static void refused(const char *text, size_t room) {
    char error[512] = "";
    if (plm_contact_from_toml(text, error, room) != NULL) {
        strcpy(error, "accepted");
    }
    puts(error);
}

#define BODIES \
    "sphere = { radius = \"5 mm\", youngs_modulus = \"210 GPa\", poissons_ratio = 0.3, density = 7850 }\n" \
    "half_space = { youngs_modulus = \"210 GPa\", poissons_ratio = 0.3, yield_strength = \"345 MPa\", " \
    "rate = { johnson_cook = { c = 0.03 } } }\n" \
    "law = { plm = { unloading_exponent = \"pressure-shape\" } }\n"

/* A strength that rises with the strain rate is that of one speed. */
static void rated(void) {
    char error[512] = "";
    plm_contact *own = plm_contact_from_toml(BODIES "impact = { speed = \"3 m/s\" }\n", error, sizeof error);
    double memory[3] = {0.0, 0.0, 0.0}, restitution;
    double time = plm_contact_time(own, 3.0, &restitution);
    double down = plm_contact_force(own, 30e-6, memory), up = plm_contact_force(own, 29e-6, memory);
    printf("rated %016" PRIx64 " %016" PRIx64 " %016" PRIx64 " %016" PRIx64 "\n", bits(time), bits(restitution),
           bits(down), bits(up));
    plm_contact_free(own);
    refused(BODIES, 512);
}

/* Two balls of 5 and 3 mm at 1 m/s: by their own scenario, and by the bodies of another one with two radii. Then a loop
 * of steps. */
static void meet(void) {
    char error[512] = "";
    plm_contact *balls = plm_contact_from_toml(
        "sphere = { radius = 5e-3, youngs_modulus = 2.1e11, poissons_ratio = 0.3, density = 7850, yield_strength = "
        "3.45e8 }\n"
        "half_space = { radius = 3e-3, mass = \"ball\", youngs_modulus = 2.1e11, poissons_ratio = 0.3, density = 7850, "
        "yield_strength = 3.45e8 }\nlaw = { plm = { unloading_exponent = \"pressure-shape\" } }\n",
        error, sizeof error);
    plm_contact *alike = plm_contact_of_one_material(contact, error, sizeof error);
    plm_contact *between = plm_contact_between(alike, 5e-3, 3e-3);
    double own, same, heavy, memory[3] = {0.0, 0.0, 0.0}, indentation = 0.0, speed = 1.0, force = 0.0;
    const double time = plm_contact_time(balls, 1.0, &own), dt = 1e-8, mass = plm_contact_reduced_mass(balls);
    plm_contact_time(between, 1.0, &same);
    /* four times the mass at half the speed has the same energy, the same path, and twice the time */
    const double twice = plm_contact_time_of_mass(balls, 4.0 * mass, 0.5, &heavy);
    do {
        speed -= 0.5 * dt * force / mass;
        indentation += dt * speed;
        force = plm_contact_force(balls, indentation, memory);
        speed -= 0.5 * dt * force / mass;
    } while (indentation > 0.0);
    printf("balls %016" PRIx64 " %d %d %d %d %.3e\n", bits(own), fabs(same - own) < 1e-12, fabs(heavy - own) < 1e-12,
           fabs(twice - 2.0 * time) < 1e-12 * time, mass < plm_contact_mass(balls), fabs(-speed - own));
    plm_contact *other = plm_contact_between(balls, 3e-3, 5e-3);
    plm_contact_time(other, 1.0, &same);
    printf("order %d nothing %d %d %d %d\n", fabs(same - own) < 1e-12, plm_contact_between(balls, 0.0, 3e-3) == NULL,
           plm_contact_between(balls, 5e-3, NAN) == NULL, plm_contact_between(NULL, 5e-3, 3e-3) == NULL,
           isnan(plm_contact_time_of_mass(balls, NAN, 1.0, NULL)));
    plm_contact_free(other);
    plm_contact_free(between);
    plm_contact_free(alike);
    plm_contact_free(balls);
    printf("%s\n", plm_contact_of_one_material(NULL, error, sizeof error) == NULL ? error : "accepted");
}

/* An alumina ball on aluminium is not of one material. */
static void two_materials(const plm_contact *waves) {
    char error[512] = "";
    printf("%s\n", plm_contact_of_one_material(waves, error, sizeof error) == NULL ? error : "accepted");
}

/* Friction along the path, with slip in two directions of which one changes its sign, and what the sphere is. */
static void rubbed(void) {
    double memory[3] = {0.0, 0.0, 0.0}, history[3] = {0.0, 0.0, 0.0}, previous_indentation = 0.0;
    for (int step = 0; step < STEPS; step++) {
        const double slip[3] = {2e-8, step < STEPS / 2 ? 1e-8 : -3e-8, 0.0};
        double indentation = path(step), force = plm_contact_force(contact, indentation, memory);
        if (plm_contact_friction(contact, 0.2, previous_indentation, indentation, force, memory, slip, history) != 0) {
            puts("friction fails");
        }
        previous_indentation = indentation;
        if (step % 50 == 49) {
            printf("friction %016" PRIx64 " %016" PRIx64 " %016" PRIx64 "\n", bits(history[0]), bits(history[1]),
                   bits(history[2]));
        }
    }
    double kept[3] = {history[0], history[1], history[2]};
    int failures = plm_contact_friction(NULL, 0.2, 0.0, 1e-6, 1.0, memory, kept, history) +
                   plm_contact_friction(contact, 0.2, 0.0, 1e-6, 1.0, memory, NULL, history) +
                   plm_contact_friction(contact, 0.2, 0.0, 1e-6, 1.0, NULL, kept, history);
    /* a coefficient, a slip, a force, an indentation, a memory that no contact has */
    const double wrong[] = {NAN, INFINITY, -INFINITY, -0.1};
    const double slip[3] = {2e-8, 0.0, 0.0}, empty[3] = {1e-6, -1.0, 0.0};
    double lost[3] = {0.0, 0.0, 0.0};
    for (int i = 0; i < 4; i++) {
        failures += plm_contact_friction(contact, wrong[i], 1e-6, 1e-6, 1.0, memory, slip, history);
    }
    for (int i = 0; i < 3; i++) {
        failures += plm_contact_friction(contact, 0.2, wrong[i], 1e-6, 1.0, memory, slip, history);
        failures += plm_contact_friction(contact, 0.2, 1e-6, wrong[i], 1.0, memory, slip, history);
        failures += plm_contact_friction(contact, 0.2, 1e-6, 1e-6, wrong[i], memory, slip, history);
        lost[1] = wrong[i];
        failures += plm_contact_friction(contact, 0.2, 1e-6, 1e-6, 1.0, memory, lost, history);
    }
    failures += plm_contact_friction(contact, 0.2, 1e-6, 1e-6, 1.0, empty, slip, history);
    /* a friction whose square is too large for a double */
    lost[1] = 1e300;
    failures += plm_contact_friction(contact, 0.2, memory[0], memory[0], 1.0, memory, lost, history);
    printf("%d frictions fail\n", failures);
    puts(memcmp(kept, history, sizeof kept) ? "friction without a contact" : "no friction without a contact");
    printf("sphere %016" PRIx64 " %016" PRIx64 " %016" PRIx64 "\n", bits(plm_contact_radius(contact)),
           bits(plm_contact_mass(contact)), bits(plm_contact_yield_speed(contact)));
    printf("%d %d %d of no contact\n", isnan(plm_contact_radius(NULL)), isnan(plm_contact_mass(NULL)),
           isnan(plm_contact_yield_speed(NULL)));
}

int main(int count, char **arguments) {
    char error[512] = "no scenario named";
    contact = count > 1 ? plm_contact_open(arguments[1], error, sizeof error) : NULL;
    if (contact == NULL) {
        fputs(error, stderr);
        return 1;
    }
    const plm_contact *waves = count > 2 ? plm_contact_open(arguments[2], error, sizeof error) : NULL;
    double restitution;
    double time = plm_contact_time(contact, 3.0, &restitution);
    printf("time %016" PRIx64 "\nrestitution %016" PRIx64 "\n", bits(time), bits(restitution));
    double memory[3] = {0.0, 0.0, 0.0};
    for (int step = 0; step < STEPS; step++) {
        double indentation = path(step);
        double stiffness = plm_contact_stiffness(contact, indentation, memory);
        double force = plm_contact_force(contact, indentation, memory);
        double plastic, stored = plm_contact_energy(contact, indentation, force, memory, &plastic);
        printf("%016" PRIx64 " %016" PRIx64 " %016" PRIx64 " %016" PRIx64 "\n", bits(stiffness), bits(force),
               bits(stored), bits(plastic));
    }

    refused("sphere = { radius = \"-5 mm\" }", 512);
    refused("sphere = { radius = \"5 mm\", youngs_modulus = \"210 GPa\", poissons_ratio = 0.3, density = 7850 }\n"
            "half_space = { youngs_modulus = \"210 GPa\", poissons_ratio = 0.3 }\n"
            "gravity = { acceleration = 9.81 }\n",
            512);
    refused("sphere = { radius = \"5 mm\", youngs_modulus = \"210 GPa\", poissons_ratio = 0.3, density = 7850 }\n"
            "half_space = { youngs_modulus = \"210 GPa\", poissons_ratio = 0.3 }\n"
            "sweep.\"impact.speed\" = [1.0, 2.0]\n",
            512);
    puts(plm_contact_open("no-such-file.toml", error, sizeof error) == NULL ? error : "accepted");
    refused(NULL, 512);
    refused(NULL, 10);
    plm_contact_free(NULL);
    printf("%g %g %g\n", fabs(plm_contact_force(NULL, 1.0, memory)), fabs(plm_contact_force(contact, 1.0, NULL)),
           fabs(plm_contact_force(contact, NAN, memory)));

    /* a memory or an indentation that is not finite gives no force, and spoils no memory */
    const double hostile[] = {NAN, INFINITY, -INFINITY};
    int spoilt = 0;
    for (int i = 0; i < 3; i++) {
        double kept[3] = {0.0, 0.0, 0.0};
        plm_contact_force(contact, 20e-6, kept);
        const double before[3] = {kept[0], kept[1], kept[2]};
        spoilt |= !isnan(plm_contact_force(contact, hostile[i], kept)) || memcmp(kept, before, sizeof kept) != 0;
        for (int part = 0; part < 3; part++) {
            double lost[3] = {kept[0], kept[1], kept[2]};
            lost[part] = hostile[i];
            spoilt |=
                !isnan(plm_contact_force(contact, 30e-6, lost)) || !isnan(plm_contact_stiffness(contact, 1e-6, lost));
        }
    }
    puts(spoilt ? "a memory is spoilt" : "no memory is spoilt");
    printf("validated_indentation %016" PRIx64 "\nwaves %016" PRIx64 "\n",
           bits(plm_contact_validated_indentation(contact)), bits(plm_contact_restitution_with_waves(waves, 3.0)));
    printf("%d %d %d\n", isnan(plm_contact_restitution_with_waves(contact, 3.0)),
           isnan(plm_contact_restitution_with_waves(NULL, 3.0)), isnan(plm_contact_validated_indentation(NULL)));

    /* the effective radius is that of the sphere on a flat half-space, and less on a convex one: 5 mm on 15 mm has 3.75
     * mm */
    plm_contact *convex = plm_contact_from_toml(
        "sphere = { radius = \"5 mm\", youngs_modulus = \"210 GPa\", poissons_ratio = 0.3, density = 7850 }\n"
        "half_space = { youngs_modulus = \"210 GPa\", poissons_ratio = 0.3, radius = \"15 mm\" }\n",
        error, sizeof error);
    printf("radii %d %.12g %.12g\n", plm_contact_effective_radius(contact) == plm_contact_radius(contact),
           plm_contact_radius(convex), plm_contact_effective_radius(convex));
    plm_contact_free(convex);

    meet();
    two_materials(waves);
    plm_contact_free((plm_contact *)waves);
    rated();
    rubbed();

    /* several threads use one contact, then one call for many contacts */
    double alone[STEPS], beside[4][STEPS];
    along(alone);
    pthread_t threads[4];
    for (int i = 0; i < 4; i++) {
        pthread_create(&threads[i], NULL, along, beside[i]);
    }
    int differ = 0;
    for (int i = 0; i < 4; i++) {
        pthread_join(threads[i], NULL);
        differ |= memcmp(alone, beside[i], sizeof alone);
    }
    double memories[3 * STEPS] = {0.0}, indentations[STEPS], forces[STEPS];
    for (int step = 0; step < STEPS; step++) {
        indentations[step] = path(step);
    }
    int failed = plm_contact_forces(contact, STEPS, indentations, memories, forces);
    for (int step = 0; step < STEPS; step++) {
        double fresh[3] = {0.0, 0.0, 0.0};
        differ |= bits(forces[step]) != bits(plm_contact_force(contact, path(step), fresh));
        differ |= memcmp(fresh, memories + 3 * step, sizeof fresh);
    }
    puts(differ ? "threads differ" : "threads agree");
    /* of three contacts that in the middle has no force, and the others have theirs */
    const double depths[3] = {30e-6, NAN, 30e-6};
    double three[9] = {0.0}, loads[3] = {0.0};
    int one_failed = plm_contact_forces(contact, 3, depths, three, loads);
    int is_right = loads[0] > 0.0 && isnan(loads[1]) && loads[2] == loads[0] && three[3] == 0.0 && three[6] == three[0];
    printf("forces %d %d %d %d %d %d\n", failed, one_failed, is_right,
           plm_contact_forces(contact, 3, NULL, three, loads), plm_contact_forces(NULL, 0, depths, three, loads),
           plm_contact_forces(contact, 0, NULL, NULL, NULL));
    printf("version %s %s %d\n", PLM_IMPACT_VERSION, plm_impact_version(), PLM_IMPACT_VERSION_MAJOR);
    /* of the same contact, of another one, and of none */
    plm_contact *again = plm_contact_open(arguments[1], error, sizeof error);
    plm_contact *other = plm_contact_open(arguments[2], error, sizeof error);
    uint64_t own = plm_contact_fingerprint(contact);
    printf("fingerprints %d %d %d\n", own == plm_contact_fingerprint(again), own == plm_contact_fingerprint(other),
           plm_contact_fingerprint(NULL) == 0);
    plm_contact_free(again);
    plm_contact_free(other);
    plm_contact_free((plm_contact *)contact);
    return 0;
}
