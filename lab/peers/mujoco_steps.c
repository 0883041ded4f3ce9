// Steps MuJoCo through a time and says how long that took and where it ended; driven by `cargo lab report stepping`.
//
// In, a line each:  model FILE | duration S | settle S | q … | v … | run INTEGRATOR STEP TIMECONST IMPEDANCE
// Out:              version … | result SECONDS q … v …        for each `run`, the least time of several
//
// With `settle`, a body lies at rest for so long (not timed) before it gets its velocity, and then begins at `q` along the
// ground. A TIMECONST above zero makes contacts as hard as it says, with IMPEDANCE throughout; zero leaves what the model says.

#include <mujoco/mujoco.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { MOST = 1024 };

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return t.tv_sec + 1e-9 * t.tv_nsec;
}

// Settings that blow up are measured too, and their errors say so.
static void quiet(const char *text) { (void)text; }

static void fail(const char *why, const char *what) {
  fprintf(stderr, "%s: %s\n", why, what);
  exit(1);
}

static int numbers(char *text, double *out) {
  int count = 0;
  for (char *word = strtok(text, " \n"); word && count < MOST; word = strtok(NULL, " \n")) {
    out[count++] = atof(word);
  }
  return count;
}

static int integrator(const char *name) {
  const char *names[] = {"euler", "rk4", "implicit", "implicitfast", "discrete"};
  const int values[] = {mjINT_EULER, mjINT_RK4, mjINT_IMPLICIT, mjINT_IMPLICITFAST, mjINT_DISCRETE};
  for (int i = 0; i < 5; i++) {
    if (!strcmp(name, names[i])) return values[i];
  }
  fail("no such integrator", name);
  return 0;
}

static void steps(const mjModel *m, mjData *d, long count) {
  for (long i = 0; i < count; i++) mj_step(m, d);
}

int main(void) {
  static char line[1 << 16];
  static double q[MOST], v[MOST];
  char error[1000] = "";
  double duration = 1, settle = 0;
  mjModel *m = NULL;
  mjData *d = NULL;
  mju_user_warning = quiet;
  printf("version %s\n", mj_versionString());
  while (fgets(line, sizeof line, stdin)) {
    char *rest = strchr(line, ' ');
    if (!rest) continue;
    *rest++ = 0;
    if (!strcmp(line, "model")) {
      rest[strcspn(rest, "\n")] = 0;
      mj_deleteData(d);
      mj_deleteModel(m);
      m = mj_loadXML(rest, NULL, error, sizeof error);
      if (!m) fail(rest, error);
      d = mj_makeData(m);
    } else if (!strcmp(line, "duration")) {
      duration = atof(rest);
    } else if (!strcmp(line, "settle")) {
      settle = atof(rest);
    } else if (!strcmp(line, "q")) {
      if (numbers(rest, q) != m->nq) fail("q", "a wrong number of positions");
    } else if (!strcmp(line, "v")) {
      if (numbers(rest, v) != m->nv) fail("v", "a wrong number of velocities");
    } else if (!strcmp(line, "run")) {
      char name[32];
      double step, constant, impedance;
      if (sscanf(rest, "%31s %lf %lf %lf", name, &step, &constant, &impedance) != 4) fail("run", rest);
      m->opt.integrator = integrator(name);
      m->opt.timestep = step;
      for (int i = 0; constant > 0 && i < m->ngeom; i++) {
        mju_zero(m->geom_solref + mjNREF * i, mjNREF);
        m->geom_solref[mjNREF * i] = constant;
        m->geom_solref[mjNREF * i + 1] = 1;
        m->geom_solimp[mjNIMP * i] = m->geom_solimp[mjNIMP * i + 1] = impedance;
      }
      const long count = (long)(duration / step + 0.5);
      static double begin[MOST];
      mj_resetData(m, d);
      mju_copy(d->qpos, q, m->nq);
      steps(m, d, (long)(settle / step + 0.5));
      mju_copy(begin, d->qpos, m->nq);
      double least = 1e300, spent = 0;
      for (int round = 0; spent < 0.08 ? round < 1000 : round < 3 && spent < 0.3; round++) {
        mj_resetData(m, d);
        mju_copy(d->qpos, begin, m->nq);
        mju_copy(d->qvel, v, m->nv);
        const double from = now();
        steps(m, d, count);
        const double took = now() - from;
        least = took < least ? took : least;
        spent += took;
      }
      printf("result %.9e", least);
      for (int i = 0; i < m->nq; i++) printf(" %.17g", d->qpos[i]);
      for (int i = 0; i < m->nv; i++) printf(" %.17g", d->qvel[i]);
      printf("\n");
      fflush(stdout);
    }
  }
  return 0;
}
