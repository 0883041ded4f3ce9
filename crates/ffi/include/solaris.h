// The C interface of Solaris. Made of crates/ffi/src; change it there.

#ifndef SOLARIS_H
#define SOLARIS_H

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

// Numbers of a pose: place (m) and quaternion (x, y, z, w).
#define SOLARIS_POSE_NUMBERS 7

// To come to a stand, or to stay.
#define SOLARIS_GO_STOP 0

// To walk with the velocity (`x`, `z`) in the world (m/s).
#define SOLARIS_GO_VELOCITY 1

// To walk with the velocity (`x` to the left, `z` forward) of the way it faces (m/s).
#define SOLARIS_GO_OWN_VELOCITY 2

// To walk to the point (`x`, `z`) (m) with `speed` (m/s), and to stop there.
#define SOLARIS_GO_TO_POINT 3

// To face where it goes.
#define SOLARIS_FACE_WAY 0

// To face `heading` (rad, to the left of z).
#define SOLARIS_FACE_HEADING 1

// To face the point (`face_x`, `face_z`) (m).
#define SOLARIS_FACE_POINT 2

// What a call came to.
typedef enum SolarisStatus {
  // It is done.
  SOLARIS_STATUS_OK = 0,
  // An argument is `NULL`, of the wrong length, or not one of those that are known; nothing has changed.
  SOLARIS_STATUS_BAD_ARGUMENT = 1,
  // What was asked cannot be, and `solaris_last_error` says why and what can; nothing has changed.
  SOLARIS_STATUS_REFUSED = 2,
  // A file or text cannot be read.
  SOLARIS_STATUS_UNREADABLE = 3,
  // A fault of the library itself.
  SOLARIS_STATUS_PANIC = 4,
} SolarisStatus;

// The dynamics of a figure, with scratch memory: calls allocate nothing but in errors.
typedef struct SolarisDynamics SolarisDynamics;

// An articulated figure. It never changes, and may be used by many threads at once.
typedef struct SolarisFigure SolarisFigure;

// A scene on its way.
typedef struct SolarisSimulation SolarisSimulation;

// A figure that walks as it is told while it walks. Frames allocate nothing but in errors.
typedef struct SolarisWalker SolarisWalker;

// What a walker is to do from now on. All of it is level: x to the left and z forward of the world. All zeros is to stand.
typedef struct SolarisCommand {
  // One of `SOLARIS_GO_…`.
  uint32_t go;
  // One of `SOLARIS_FACE_…`.
  uint32_t face;
  // See `go`.
  double x;
  // See `go`.
  double z;
  // See `go`.
  double speed;
  // See `face`.
  double heading;
  // See `face`.
  double face_x;
  // See `face`.
  double face_z;
} SolarisCommand;

// Where a walker is.
typedef struct SolarisWhereabouts {
  // The middle between its feet's coming prints (m).
  double x;
  // The same.
  double z;
  // Which way it faces (rad, to the left of z, not wrapped).
  double heading;
  // The velocity that the present step makes (m/s).
  double velocity_x;
  // The same.
  double velocity_z;
  // Whether both feet stand and no step has begun.
  bool is_standing;
} SolarisWhereabouts;

// What the ground does to a foot, in the axes of the world.
typedef struct SolarisContact {
  // N.
  double force[3];
  // About the world's origin (N m).
  double moment[3];
  // Where it is pressed (m).
  double center[3];
} SolarisContact;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// Why the last call on this thread failed; empty where none has. It stays valid until the next failure on this thread.
const char *solaris_last_error(void);

// Makes a person of this height (m) and mass (kg), whose root turns by its heading first, as `solaris_walker_new` needs it.
enum SolarisStatus solaris_figure_human(double height,
                                        double mass,
                                        struct SolarisFigure **out);

// Reads a figure from a file: `.ron`, `.urdf`, `.sdf`, `.xml` of `MuJoCo`, `.osim` or `.bvh`.
enum SolarisStatus solaris_figure_read(const char *path, struct SolarisFigure **out);

// Reads a figure from its text (RON).
enum SolarisStatus solaris_figure_from_text(const char *source, struct SolarisFigure **out);

// Frees a figure; what was made of it stays.
void solaris_figure_free(struct SolarisFigure *figure);

// Its name; `NULL` of `NULL`. It is valid as long as the figure.
const char *solaris_figure_name(const struct SolarisFigure *figure);

// Total mass (kg); 0 of `NULL`.
double solaris_figure_mass(const struct SolarisFigure *figure);

// Length of a configuration `q`; 0 of `NULL`.
size_t solaris_figure_nq(const struct SolarisFigure *figure);

// Number of degrees of freedom, the length of `v`, `a` and `tau`; 0 of `NULL`.
size_t solaris_figure_nv(const struct SolarisFigure *figure);

// Number of links; 0 of `NULL`.
size_t solaris_figure_links(const struct SolarisFigure *figure);

// Name of a link; `NULL` where there is none. It is valid as long as the figure.
const char *solaris_figure_link_name(const struct SolarisFigure *figure, size_t link);

// Index of a link's parent; -1 of the root, and where there is no such link.
ptrdiff_t solaris_figure_link_parent(const struct SolarisFigure *figure, size_t link);

// Name of an entry of `q`; `NULL` where there is none. It is valid as long as the figure.
const char *solaris_figure_q_name(const struct SolarisFigure *figure, size_t index);

// Name of a degree of freedom; `NULL` where there is none. It is valid as long as the figure.
const char *solaris_figure_v_name(const struct SolarisFigure *figure, size_t index);

// Writes the configuration in which every joint is at zero.
enum SolarisStatus solaris_figure_neutral(const struct SolarisFigure *figure, double *q, size_t nq);

// Makes the dynamics of a figure under its own gravity, or under `gravity` (three numbers, m/s²) where that is not `NULL`.
enum SolarisStatus solaris_dynamics_new(const struct SolarisFigure *figure,
                                        const double *gravity,
                                        struct SolarisDynamics **out);

// Frees it.
void solaris_dynamics_free(struct SolarisDynamics *dynamics);

// Inverse dynamics: the generalized forces `tau` (N m, N) of a motion.
enum SolarisStatus solaris_inverse_dynamics(struct SolarisDynamics *dynamics,
                                            const double *q,
                                            size_t nq,
                                            const double *v,
                                            const double *a,
                                            double *tau,
                                            size_t nv);

// Forward dynamics: the accelerations `a` that forces bring about.
enum SolarisStatus solaris_forward_dynamics(struct SolarisDynamics *dynamics,
                                            const double *q,
                                            size_t nq,
                                            const double *v,
                                            const double *tau,
                                            double *a,
                                            size_t nv);

// The mass matrix, `nv * nv` numbers; it is symmetric.
enum SolarisStatus solaris_mass_matrix(struct SolarisDynamics *dynamics,
                                       const double *q,
                                       size_t nq,
                                       double *matrix,
                                       size_t length);

// Where all links stand in the world: `SOLARIS_POSE_NUMBERS` numbers a link, its place (m) and its quaternion (x, y, z, w).
enum SolarisStatus solaris_link_poses(struct SolarisDynamics *dynamics,
                                      const double *q,
                                      size_t nq,
                                      double *poses,
                                      size_t length);

// Makes a walker that stands at the origin and faces along z; it plans for some dozens of milliseconds.
enum SolarisStatus solaris_walker_new(const struct SolarisFigure *figure,
                                      struct SolarisWalker **out);

// Another walker that goes on from where this one is, to the same bits under the same commands; plans are shared.
enum SolarisStatus solaris_walker_copy(const struct SolarisWalker *walker,
                                       struct SolarisWalker **out);

// Frees a walker.
void solaris_walker_free(struct SolarisWalker *walker);

// Goes on by `dt` (s, up to a quarter) under a command, and writes the configuration there.
enum SolarisStatus solaris_walker_step(struct SolarisWalker *walker,
                                       double dt,
                                       const struct SolarisCommand *command,
                                       double *q,
                                       size_t nq);

// Where it is, which way it faces, how fast it goes.
enum SolarisStatus solaris_walker_whereabouts(const struct SolarisWalker *walker,
                                              struct SolarisWhereabouts *out);

// Gives a coordinate of trunk, head or arms (`left_elbow.rx`) a value (rad) from now on, beside the walk. It goes over to it within 0.3 s; one that moves smoothly is
// followed.
enum SolarisStatus solaris_walker_set(struct SolarisWalker *walker,
                                      const char *coordinate,
                                      double value);

// Takes a coordinate back into the walk, within 0.3 s.
enum SolarisStatus solaris_walker_hold(struct SolarisWalker *walker, const char *coordinate);

// A point of a link (three numbers, m, in its frame) reaches for a place (three numbers, m, in the world) from now on, by the joints of its arm, or of neck and head. What moves is
// told anew each frame.
enum SolarisStatus solaris_walker_reach(struct SolarisWalker *walker,
                                        const char *link,
                                        const double *point,
                                        const double *place);

// The z axis of a link, which is forward, turns towards a place (three numbers, m, in the world) as it is seen from a point of the link (m, in its frame), by the same joints.
enum SolarisStatus solaris_walker_look(struct SolarisWalker *walker,
                                       const char *link,
                                       const double *point,
                                       const double *place);

// A link that reaches or looks comes back into the walk, within 0.3 s.
enum SolarisStatus solaris_walker_withdraw(struct SolarisWalker *walker, const char *link);

// Lets a joint of trunk, head or arms hang loose, or takes it back.
enum SolarisStatus solaris_walker_loosen(struct SolarisWalker *walker,
                                         const char *joint,
                                         bool loose);

// Pushes a point of a link (three numbers, m, in its frame) with a force (three numbers, N, of the world) from now on.
enum SolarisStatus solaris_walker_push(struct SolarisWalker *walker,
                                       const char *link,
                                       const double *point,
                                       const double *force);

// Pushes no more.
enum SolarisStatus solaris_walker_let_go(struct SolarisWalker *walker);

// What the last frame asks of the ground under the left and the right foot (two of them in `feet`) and of the joints (`nv` forces in `tau`, N m and N).
enum SolarisStatus solaris_walker_forces(struct SolarisWalker *walker,
                                         struct SolarisContact *feet,
                                         double *tau,
                                         size_t nv);

// Begins a scene of a file (`.ron`), by its own method; where it leaves that open in steps of a millisecond, by impulses over ground or
// where links touch or are held together, else by Runge and Kutta's rule.
enum SolarisStatus solaris_simulation_read(const char *path,
                                           struct SolarisSimulation **out);

// Begins a scene of a text, which names no files.
enum SolarisStatus solaris_simulation_from_text(const char *source, struct SolarisSimulation **out);

// Frees it.
void solaris_simulation_free(struct SolarisSimulation *simulation);

// Another one that goes on from here, to the same bits.
enum SolarisStatus solaris_simulation_copy(const struct SolarisSimulation *simulation,
                                           struct SolarisSimulation **out);

// The figure of it, which is the caller's to free.
enum SolarisStatus solaris_simulation_figure(const struct SolarisSimulation *simulation,
                                             struct SolarisFigure **out);

// On by `dt` (s).
enum SolarisStatus solaris_simulation_step(struct SolarisSimulation *simulation, double dt);

// How long it has run (s); 0 of `NULL`.
double solaris_simulation_time(const struct SolarisSimulation *simulation);

// Writes positions and velocities.
enum SolarisStatus solaris_simulation_state(const struct SolarisSimulation *simulation,
                                            double *q,
                                            size_t nq,
                                            double *v,
                                            size_t nv);

// Puts the figure somewhere else.
enum SolarisStatus solaris_simulation_set_state(struct SolarisSimulation *simulation,
                                                const double *q,
                                                size_t nq,
                                                const double *v,
                                                size_t nv);

// Another constant force (N m, N) on a degree of freedom that is free, until something else is said.
enum SolarisStatus solaris_simulation_set_force(struct SolarisSimulation *simulation,
                                                size_t dof,
                                                double force);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* SOLARIS_H */
