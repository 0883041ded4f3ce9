// A pendulum, step by step, with a snapshot: from C++, handles freed by themselves.
//
// c++ crates/ffi/examples/swing.cpp -I crates/ffi/include target/release/libsolaris_ffi.a -lm -lpthread -ldl -o swing
#include "solaris.h"

#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <vector>

static void check(SolarisStatus status) {
    if (status != SOLARIS_STATUS_OK) throw std::runtime_error(solaris_last_error());
}

struct Free {
    void operator()(SolarisSimulation *it) const { solaris_simulation_free(it); }
};
using Simulation = std::unique_ptr<SolarisSimulation, Free>;

static Simulation begin(const char *text) {
    SolarisSimulation *made = nullptr;
    check(solaris_simulation_from_text(text, &made));
    return Simulation(made);
}

static double angle(const Simulation &it) {
    double q = 0.0, v = 0.0;
    check(solaris_simulation_state(it.get(), &q, 1, &v, 1));
    return q;
}

int main() try {
    Simulation pendulum = begin(
        "Scene(version: 1, duration: 1.0, figures: {\"it\": Figure(links: [Link(name: \"rod\", mass: 1.0,"
        " joint: Joint(name: \"pivot\", axes: [rx]), com: (0, -1, 0))])})");
    const double start = 0.01, still = 0.0;
    check(solaris_simulation_set_state(pendulum.get(), &start, 1, &still, 1));
    SolarisSimulation *copy = nullptr;
    check(solaris_simulation_copy(pendulum.get(), &copy));
    Simulation twin(copy);

    // Half a small swing takes pi sqrt(l/g).
    const double half = 3.14159265358979 * std::sqrt(1.0 / 9.80665);
    check(solaris_simulation_step(pendulum.get(), half));
    std::printf("after half a swing: %.4f rad\n", angle(pendulum));
    check(solaris_simulation_step(twin.get(), half));
    std::printf("its twin: %s\n", angle(twin) == angle(pendulum) ? "the same" : "another");

    try {
        begin("Scene(version: 1, durtion: 1.0)");
    } catch (const std::runtime_error &error) {
        std::printf("refused: %s\n", error.what());
    }
    return 0;
} catch (const std::exception &error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
