// What the peers' programs share: rows of doubles in files, times of operations in blocks that take turns, results on the output.
//
//     PROGRAM MODEL STATES OUT BLOCK_MS ROUNDS
//
// reads STATES_q.f64, _v.f64, _a.f64 and _tau.f64 (little-endian doubles, row after row), writes the forces of inverse dynamics to
// OUT_rnea.f64 and the accelerations of forward dynamics to OUT_aba.f64, and says `RESULT<TAB>operation<TAB>median ns<TAB>least ns`.
#pragma once
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

inline std::vector<double> read_rows(const std::string &path) {
    FILE *file = std::fopen(path.c_str(), "rb");
    if (!file) {
        std::perror(path.c_str());
        std::exit(1);
    }
    std::fseek(file, 0, SEEK_END);
    std::vector<double> rows(std::ftell(file) / sizeof(double));
    std::rewind(file);
    if (std::fread(rows.data(), sizeof(double), rows.size(), file) != rows.size()) std::exit(1);
    std::fclose(file);
    return rows;
}

inline void write_rows(const std::string &path, const std::vector<double> &rows) {
    FILE *file = std::fopen(path.c_str(), "wb");
    if (!file || std::fwrite(rows.data(), sizeof(double), rows.size(), file) != rows.size()) {
        std::perror(path.c_str());
        std::exit(1);
    }
    std::fclose(file);
}

struct Operation {
    std::string name;
    std::function<void(size_t)> call;
    // How many states one call answers.
    double states = 1;
    size_t repeats = 1;
    std::vector<double> times;
};

inline double time_of(Operation &operation, size_t states) {
    auto start = std::chrono::steady_clock::now();
    for (size_t i = 0, state = 0; i < operation.repeats; i++) {
        operation.call(state);
        if (++state == states) state = 0;
    }
    return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
}

inline void run(std::vector<Operation> &operations, size_t states, double block_ms, int rounds) {
    for (auto &operation : operations) {
        double taken;
        while ((taken = time_of(operation, states)) < block_ms * 5e5) operation.repeats *= 2;
        operation.repeats = std::max<size_t>(1, operation.repeats * block_ms * 1e6 / taken);
    }
    for (int round = 0; round < rounds; round++)
        for (auto &operation : operations)
            operation.times.push_back(time_of(operation, states) / operation.repeats / operation.states);
    for (auto &operation : operations) {
        std::sort(operation.times.begin(), operation.times.end());
        std::printf("RESULT\t%s\t%.2f\t%.2f\n", operation.name.c_str(), operation.times[operation.times.size() / 2], operation.times[0]);
    }
}
