// MuJoCo's kernel without constraints, as far as an operation needs it: see timing.h. The figures have slides and hinges alone, in the
// order of their coordinates. `mj_inverse` and `mj_forward` do more than is asked here, and take longer.
#include "timing.h"

#include <cstring>
#include <mujoco/mujoco.h>

int main(int, char **arguments) {
    char error[1000] = "";
    mjModel *model = mj_loadXML(arguments[1], nullptr, error, sizeof error);
    if (!model) {
        std::fprintf(stderr, "%s\n", error);
        return 1;
    }
    const std::string states = arguments[2], out = arguments[3];
    const size_t nq = model->nq, nv = model->nv;
    const auto q = read_rows(states + "_q.f64"), v = read_rows(states + "_v.f64"), a = read_rows(states + "_a.f64"),
               tau = read_rows(states + "_tau.f64");
    const size_t count = q.size() / nq;
    mjData *data = mj_makeData(model);
    std::vector<double> forces(count * nv), accelerations(count * nv), full(nv * nv), left(nv);
    auto place = [&](size_t i) {
        std::memcpy(data->qpos, &q[i * nq], nq * sizeof(double));
        mj_kinematics(model, data);
        mj_comPos(model, data);
    };
    auto move = [&](size_t i) {
        std::memcpy(data->qvel, &v[i * nv], nv * sizeof(double));
        mj_comVel(model, data);
    };
    auto inverse = [&](size_t i) {
        std::memcpy(data->qacc, &a[i * nv], nv * sizeof(double));
        place(i), move(i), mj_rne(model, data, 1, &forces[i * nv]);
    };
    auto forward = [&](size_t i) {
        place(i), move(i);
        mj_makeM(model, data), mj_factorM(model, data);
        mj_rne(model, data, 0, left.data());
        for (size_t k = 0; k < nv; k++) left[k] = tau[i * nv + k] - left[k];
        mj_solveM(model, data, &accelerations[i * nv], left.data(), 1);
    };
    for (size_t i = 0; i < count; i++) inverse(i), forward(i);
    write_rows(out + "_rnea.f64", forces);
    write_rows(out + "_aba.f64", accelerations);
    std::vector<Operation> operations = {
        {"rnea", inverse},
        {"aba", forward},
        {"crba", [&](size_t i) { place(i), mj_makeM(model, data), mj_fullM(model, data, full.data()); }},
        {"rnea_batch", [&](size_t) { for (size_t i = 0; i < count; i++) inverse(i); }, double(count)},
        {"aba_batch", [&](size_t) { for (size_t i = 0; i < count; i++) forward(i); }, double(count)},
    };
    run(operations, std::min<size_t>(count, 1024), std::atof(arguments[4]), std::atoi(arguments[5]));
}
