// A person walks to a point and stops there: a frame sixty times a second, and the forces of its joints at the end.
//
// cc crates/ffi/examples/walk.c -I crates/ffi/include target/release/libsolaris_ffi.a -lm -lpthread -ldl -o walk
#include "solaris.h"

#include <stdio.h>
#include <stdlib.h>

static void check(SolarisStatus status) {
    if (status != SOLARIS_STATUS_OK) {
        fprintf(stderr, "%s\n", solaris_last_error());
        exit(1);
    }
}

int main(void) {
    SolarisFigure *ann = NULL;
    SolarisWalker *walker = NULL;
    SolarisDynamics *dynamics = NULL;
    check(solaris_figure_human(1.65, 58.0, &ann));
    check(solaris_walker_new(ann, &walker));
    check(solaris_dynamics_new(ann, NULL, &dynamics));

    size_t nq = solaris_figure_nq(ann), nv = solaris_figure_nv(ann), links = solaris_figure_links(ann);
    double *q = calloc(nq, sizeof *q), *zero = calloc(nv, sizeof *zero), *tau = calloc(nv, sizeof *tau);
    double *poses = calloc(links * SOLARIS_POSE_NUMBERS, sizeof *poses);

    SolarisCommand command = {0};
    command.go = SOLARIS_GO_TO_POINT;
    command.x = 1.0;
    command.z = 4.0;
    command.speed = 1.3;
    for (int frame = 0; frame < 900; frame++) {
        check(solaris_walker_step(walker, 1.0 / 60.0, &command, q, nq));
        // What an engine draws: place and quaternion of every link.
        check(solaris_link_poses(dynamics, q, nq, poses, links * SOLARIS_POSE_NUMBERS));
    }
    SolarisWhereabouts there;
    check(solaris_walker_whereabouts(walker, &there));
    check(solaris_inverse_dynamics(dynamics, q, nq, zero, zero, tau, nv));
    printf("%s stands at (%.1f, %.1f): %d; her weight is %.1f N\n", solaris_figure_name(ann), there.x, there.z,
           there.is_standing, tau[1]);

    // What is wrong is said.
    if (solaris_walker_step(walker, 9.0, &command, q, nq) == SOLARIS_STATUS_REFUSED)
        printf("refused: %s\n", solaris_last_error());
    if (solaris_walker_step(walker, 0.01, &command, q, 3) == SOLARIS_STATUS_BAD_ARGUMENT)
        printf("refused: %s\n", solaris_last_error());

    free(q);
    free(zero);
    free(tau);
    free(poses);
    solaris_dynamics_free(dynamics);
    solaris_walker_free(walker);
    solaris_figure_free(ann);
    return 0;
}
