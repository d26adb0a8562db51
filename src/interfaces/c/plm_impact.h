/* The contact law of plm-impact for C. Made by cbindgen from src/interfaces/c; SPDX-License-Identifier: MIT */

#ifndef PLM_IMPACT_H
#define PLM_IMPACT_H

#include <stddef.h>
#include <stdint.h>

/* Version of this header. */
#define PLM_IMPACT_VERSION "0.1.0"
#define PLM_IMPACT_VERSION_MAJOR 0
#define PLM_IMPACT_VERSION_MINOR 1
#define PLM_IMPACT_VERSION_PATCH 0


/**
 * A sphere, a half-space and the law between them.
 */
typedef struct plm_contact plm_contact;

/**
 * The state of a contact between two time steps: seven doubles, zero for a fresh contact. Set them to zero when the sphere has
 * left the surface (indentation <= 0).
 */
typedef struct plm_history {
  /**
   * As of plm_contact_force.
   */
  double memory[3];
  /**
   * Exponent of the unloading branch. 0: not known yet; -1: the branch is no power law.
   */
  double exponent;
  /**
   * Indentation after the last step [m].
   */
  double indentation;
  /**
   * Force after the last step [N].
   */
  double force;
  /**
   * Plastic work of the dent [J]; it belongs to the memory if the exponent is not 0.
   */
  double plastic;
} plm_history;

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Version of the library, such as "0.1.0". Compare it with PLM_IMPACT_VERSION, the version of this header. Do not free it.
 */
const char *plm_impact_version(void);

/**
 * The contact of a scenario that is given as a TOML text. The keys are those of a scenario file, and [impact] may be
 * left out. A strength that depends on the strain rate is that of the speed of [impact], which is then needed. Gravity,
 * damping, plates, rods, and tables that ask for more than one impact ([sweep], ...) are refused. Two balls are a scenario with
 * half_space.radius and half_space.mass = "ball". Paths of files in the text are relative to the working directory.
 *
 * Returns NULL for a bad scenario, and writes the reason into error: at most length bytes with the final zero.
 * Free the contact with plm_contact_free.
 *
 * What the caller promises:
 * scenario_toml ends with a zero byte; error is NULL or has length bytes.
 */
struct plm_contact *plm_contact_from_toml(const char *scenario_toml,
                                          char *error,
                                          size_t length);

/**
 * The contact of a scenario file. Otherwise as plm_contact_from_toml, but paths in the scenario are relative to its
 * folder.
 *
 * What the caller promises:
 * As plm_contact_from_toml.
 */
struct plm_contact *plm_contact_open(const char *path,
                                     char *error,
                                     size_t length);

/**
 * Frees a contact; NULL is allowed.
 *
 * What the caller promises:
 * contact is NULL or comes from a function that returns a contact, is not yet freed, and is not used afterwards.
 */
void plm_contact_free(struct plm_contact *contact);

/**
 * Force [N] at an indentation [m] by the law alone. Updates memory (three doubles, zero for a fresh contact).
 *
 * The force is 0 for an indentation of 0 or less. Set the memory to zero when the sphere has left the surface
 * (indentation <= 0), not when the force becomes zero. Returns NaN if the indentation is NaN or infinite, if the force
 * would be, if no contact can have this memory (a number that is negative, NaN or infinite, or a third number larger
 * than the first), or if a pointer is NULL; the memory then stays as it was.
 *
 * The law has no elastic waves: see plm_contact_restitution_with_waves.
 *
 * What the caller promises:
 * contact is NULL or not yet freed; memory is NULL or has three doubles that no other thread uses at the same
 * time.
 */
double plm_contact_force(const struct plm_contact *contact,
                         double indentation,
                         double *memory);

/**
 * plm_contact_force for n contacts of one sphere and half-space: memory[3 i], memory[3 i + 1], memory[3 i + 2] and
 * force[i] belong to indentation[i].
 *
 * Returns 0 if every contact has a force. Returns 1 if a force is NaN, as of plm_contact_force: the memory of that contact
 * stays as it was, and all other forces are right. Returns 1 too if a pointer is NULL: then nothing is written. The arrays may
 * be NULL where n is 0.
 *
 * What the caller promises:
 * contact is NULL or not yet freed; the arrays are NULL or have n, 3 n and n doubles, and do not overlap.
 */
int plm_contact_forces(const struct plm_contact *contact,
                       size_t n,
                       const double *indentation,
                       double *memory,
                       double *force);

/**
 * Friction of a contact with this coefficient: one tangential spring, as LAMMPS mindlin_rescale/force. Call it in every
 * step after plm_contact_force gave force and memory at indentation; previous_indentation is the indentation of the
 * last step, 0 in the first. slip (three doubles) is how far the contact point moved along the surface since then [m].
 * history (three doubles, zero for a fresh contact) becomes the friction on the sphere [N]; its torque about the centre is
 * that of this force at the contact point.
 *
 * Returns 0, or 1 if there is no friction: the coefficient is negative, a number is NaN or infinite, no contact can have this
 * memory, or a pointer is NULL. The history then stays as it was.
 *
 * For a sphere of another radius multiply indentations and slip as for plm_contact_force, and divide the friction likewise.
 *
 * What the caller promises:
 * As plm_contact_stiffness; slip and history are NULL or have three doubles each.
 */
int plm_contact_friction(const struct plm_contact *contact,
                         double coefficient,
                         double previous_indentation,
                         double indentation,
                         double force,
                         const double *memory,
                         const double *slip,
                         double *history);

/**
 * Tangent stiffness dF/d(indentation) [N/m]: of the unloading branch up to the largest indentation so far, and of the
 * loading curve beyond it.
 *
 * What the caller promises:
 * contact is NULL or not yet freed; memory is NULL or has three doubles.
 */
double plm_contact_stiffness(const struct plm_contact *contact,
                             double indentation,
                             const double *memory);

/**
 * Energies of a contact [J], after plm_contact_force gave this force and memory at this indentation. Returns the
 * stored energy, which unloading gives back. Writes the plastic work of the dent into plastic if that is not NULL.
 *
 * What the caller promises:
 * As plm_contact_stiffness; plastic is NULL or points to a double.
 */
double plm_contact_energy(const struct plm_contact *contact,
                          double indentation,
                          double force,
                          const double *memory,
                          double *plastic);

/**
 * Radius of the sphere [m]. The law of a sphere of another radius r follows by scaling: with s = radius/r its force is
 * plm_contact_force at s times its indentation, divided by s squared. This holds on a flat half-space alone: of a curved one
 * it would scale the curvature too, so compare with plm_contact_effective_radius. For two balls use plm_contact_between.
 *
 * What the caller promises:
 * contact is NULL or not yet freed.
 */
double plm_contact_radius(const struct plm_contact *contact);

/**
 * Effective radius [m], with 1/R* = 1/R + 1/half_space.radius. It is the radius of the sphere where the half-space is flat.
 *
 * What the caller promises:
 * contact is NULL or not yet freed.
 */
double plm_contact_effective_radius(const struct plm_contact *contact);

/**
 * Mass of the sphere [kg].
 *
 * What the caller promises:
 * contact is NULL or not yet freed.
 */
double plm_contact_mass(const struct plm_contact *contact);

/**
 * Speed [m/s] of the slowest impact that yields; NaN for a contact that stays elastic and for a law that yields at
 * once.
 *
 * What the caller promises:
 * contact is NULL or not yet freed.
 */
double plm_contact_yield_speed(const struct plm_contact *contact);

/**
 * Coefficient of restitution at a speed [m/s] less what elastic waves in the half-space take, to first order. The
 * force has no waves: this is what a simulation with it leaves out. NaN if the scenario gives no half_space.density.
 *
 * What the caller promises:
 * contact is NULL or not yet freed.
 */
double plm_contact_restitution_with_waves(const struct plm_contact *contact,
                                          double speed);

/**
 * Indentation [m] up to which the data behind the law reach. Beyond it forces and dent are estimates.
 *
 * What the caller promises:
 * contact is NULL or not yet freed.
 */
double plm_contact_validated_indentation(const struct plm_contact *contact);

/**
 * Fingerprint of the bodies and of the law, for the restart file of a simulation: a memory belongs to the contact with the
 * same fingerprint alone. Two scenarios with the same contact have the same one, whatever their comments are; another version
 * of the library may have another one. 0 for NULL.
 *
 * What the caller promises:
 * contact is NULL or not yet freed.
 */
uint64_t plm_contact_fingerprint(const struct plm_contact *contact);

/**
 * The contact of two balls with the bodies and the law of contact: the sphere with sphere_radius [m], and the half-space as
 * a ball with half_space_radius [m]. Scaling by the effective radius is not this law: two balls of 5 and 3 mm differ from a
 * scaled sphere on a flat half-space by 0.2 to 3.5 % in e. But the law scales with both radii at once, as for plm_contact_force.
 *
 * Returns NULL if contact is NULL, or if there is no contact with these radii. Free the contact with plm_contact_free.
 *
 * What the caller promises:
 * contact is NULL or not yet freed.
 */
struct plm_contact *plm_contact_between(const struct plm_contact *contact,
                                        double sphere_radius,
                                        double half_space_radius);

/**
 * The contact of two bodies of one material, such as spheres of one kind: where one body of contact has no yield strength, it
 * has that of the other. With one strength alone the other body stays elastic, and e is several per cent too high.
 *
 * Returns NULL if the bodies have different elastic constants or different strengths, or a flow curve, and writes the reason into
 * error: at most length bytes with the final zero. Free the contact with plm_contact_free.
 *
 * What the caller promises:
 * contact is NULL or not yet freed; error is NULL or has length bytes.
 */
struct plm_contact *plm_contact_of_one_material(const struct plm_contact *contact,
                                                char *error,
                                                size_t length);

/**
 * Mass [kg] of the relative motion: m1 m2/(m1 + m2) for two balls, and the mass of the sphere on a fixed half-space.
 *
 * What the caller promises:
 * contact is NULL or not yet freed.
 */
double plm_contact_reduced_mass(const struct plm_contact *contact);

/**
 * Contact time [s] of the whole impact at a speed [m/s], of two balls at their closing speed; NaN if there is no result. Writes
 * the coefficient of restitution into restitution if that is not NULL.
 *
 * What the caller promises:
 * contact is NULL or not yet freed; restitution is NULL or points to a double.
 */
double plm_contact_time(const struct plm_contact *contact,
                        double speed,
                        double *restitution);

/**
 * plm_contact_time with a given mass of the relative motion [kg], such as that of two spheres of a simulation.
 *
 * What the caller promises:
 * As plm_contact_time.
 */
double plm_contact_time_of_mass(const struct plm_contact *contact,
                                double reduced_mass,
                                double speed,
                                double *restitution);

/**
 * One time step of a contact: moves it to an indentation [m], and writes the force [N] into the history. The force is that of
 * plm_contact_force up to rounding, in less time: the unloading branch is found once for each largest indentation.
 *
 * With slip and friction (three doubles each) the friction on the sphere [N] changes as by plm_contact_friction with this
 * coefficient, which is not used without them. With stored, the stored energy [J] is written there, and the plastic work into the
 * history; without it, the plastic work is that of the last unloading. Leave out what a step does not need: NULL.
 *
 * Returns 0, or 1 if a number is NaN or infinite, if no contact can have this memory, if the coefficient is negative, if contact or
 * history is NULL, or if only one of slip and friction is. Then nothing is written.
 *
 * What the caller promises:
 * contact is NULL or not yet freed; history is NULL or points to a plm_history, slip and friction are NULL or have three
 * doubles each, stored is NULL or points to a double. None of them overlap, and no other thread uses what is written at the same time.
 */
int plm_contact_step(const struct plm_contact *contact,
                     double indentation,
                     struct plm_history *history,
                     double coefficient,
                     const double *slip,
                     double *friction,
                     double *stored);

#ifdef __cplusplus
}
#endif

#endif  /* PLM_IMPACT_H */
