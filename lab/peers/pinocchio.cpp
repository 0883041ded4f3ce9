// Pinocchio's kernel on the flat model text of the driver: see timing.h and lab/src/peers/model.rs. Its headers alone: a library that
// was built without the processor's options does not go with code that was built with them.
#include "timing.h"

#include <fstream>
#include <pinocchio/algorithm/aba-derivatives.hpp>
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/centroidal.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/frames.hpp>
#include <pinocchio/algorithm/jacobian.hpp>
#include <pinocchio/algorithm/regressor.hpp>
#include <pinocchio/algorithm/rnea-derivatives.hpp>
#include <pinocchio/algorithm/rnea.hpp>
#include <pinocchio/multibody.hpp>
#include <pinocchio/multibody/joint.hpp>

using namespace pinocchio;

static JointModel joint_of(const std::string &type, const Eigen::Vector3d &axis) {
    if (type == "RX") return JointModelRX();
    if (type == "RY") return JointModelRY();
    if (type == "RZ") return JointModelRZ();
    if (type == "PX") return JointModelPX();
    if (type == "PY") return JointModelPY();
    if (type == "PZ") return JointModelPZ();
    if (type == "RU") return JointModelRevoluteUnaligned(axis);
    if (type == "PU") return JointModelPrismaticUnaligned(axis);
    if (type == "T3") return JointModelTranslation();
    if (type == "SZYX") return JointModelSphericalZYX();
    if (type == "FF") return JointModelFreeFlyer();
    std::fprintf(stderr, "no joint of the type %s\n", type.c_str());
    std::exit(1);
}

static Model read_model(const char *path) {
    std::ifstream file(path);
    std::string name, type;
    int count, nq, nv, parent;
    Eigen::Vector3d gravity;
    file >> name >> count >> nq >> nv >> gravity[0] >> gravity[1] >> gravity[2];
    Model model;
    model.name = name;
    model.gravity.linear() = gravity;
    for (int joint = 0; joint < count; joint++) {
        double x[25];
        file >> name >> type >> parent;
        for (double &number : x) file >> number;
        Eigen::Matrix3d rotation, inertia;
        rotation << x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], x[8];
        inertia << x[19], x[20], x[21], x[20], x[22], x[23], x[21], x[23], x[24];
        Eigen::Vector3d place(x[9], x[10], x[11]), axis(x[12], x[13], x[14]), com(x[16], x[17], x[18]);
        auto id = model.addJoint(parent + 1, joint_of(type, axis), SE3(rotation, place), name);
        model.appendBodyToJoint(id, Inertia(x[15], com, inertia), SE3::Identity());
    }
    if (!file || model.nq != nq || model.nv != nv) {
        std::fprintf(stderr, "%s is no model\n", path);
        std::exit(1);
    }
    return model;
}

int main(int, char **arguments) {
    const Model model = read_model(arguments[1]);
    const std::string states = arguments[2], out = arguments[3];
    const size_t nq = model.nq, nv = model.nv;
    const auto qs = read_rows(states + "_q.f64"), vs = read_rows(states + "_v.f64"), as = read_rows(states + "_a.f64"),
               taus = read_rows(states + "_tau.f64");
    const size_t count = qs.size() / nq;
    using Row = Eigen::Map<const Eigen::VectorXd>;
    auto q = [&](size_t i) { return Row(&qs[i * nq], nq); };
    auto v = [&](size_t i) { return Row(&vs[i * nv], nv); };
    auto a = [&](size_t i) { return Row(&as[i * nv], nv); };
    auto tau = [&](size_t i) { return Row(&taus[i * nv], nv); };
    Data data(model);
    std::vector<double> forces(count * nv), accelerations(count * nv);
    auto row = [&](std::vector<double> &rows, size_t i) { return Eigen::Map<Eigen::VectorXd>(&rows[i * nv], nv); };
    auto inverse = [&](size_t i) { row(forces, i) = rnea(model, data, q(i), v(i), a(i)); };
    auto forward = [&](size_t i, Convention convention) { row(accelerations, i) = aba(model, data, q(i), v(i), tau(i), convention); };
    for (size_t i = 0; i < count; i++) inverse(i), forward(i, Convention::WORLD);
    write_rows(out + "_rnea.f64", forces);
    write_rows(out + "_aba.f64", accelerations);

    const auto tip = JointIndex(model.njoints - 1);
    Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(6, nv), inverse_mass(nv, nv);
    std::vector<Operation> operations = {
        {"rnea", inverse},
        {"aba", [&](size_t i) { forward(i, Convention::WORLD); }},
        {"aba", [&](size_t i) { forward(i, Convention::LOCAL); }},
        {"crba", [&](size_t i) { crba(model, data, q(i), Convention::WORLD); }},
        {"crba", [&](size_t i) { crba(model, data, q(i), Convention::LOCAL); }},
        {"minverse", [&](size_t i) { computeMinverse(model, data, q(i)); }},
        {"rnea_derivatives", [&](size_t i) { computeRNEADerivatives(model, data, q(i), v(i), a(i)); }},
        {"aba_derivatives", [&](size_t i) { computeABADerivatives(model, data, q(i), v(i), tau(i)); }},
        {"jacobian",
         [&](size_t i) {
             computeJointJacobians(model, data, q(i));
             getJointJacobian(model, data, tip, LOCAL_WORLD_ALIGNED, jacobian);
         }},
        {"jacobian_alone", [&](size_t i) { computeJointJacobian(model, data, q(i), tip, jacobian); }},
        {"jacobian_rate",
         [&](size_t i) {
             computeJointJacobiansTimeVariation(model, data, q(i), v(i));
             getJointJacobianTimeVariation(model, data, tip, LOCAL_WORLD_ALIGNED, jacobian);
         }},
        {"centroidal_map", [&](size_t i) { ccrba(model, data, q(i), v(i)); }},
        {"regressor", [&](size_t i) { computeJointTorqueRegressor(model, data, q(i), v(i), a(i)); }},
        {"rnea_batch", [&](size_t) { for (size_t i = 0; i < count; i++) inverse(i); }, double(count)},
        {"aba_batch", [&](size_t) { for (size_t i = 0; i < count; i++) forward(i, Convention::WORLD); }, double(count)},
        {"aba_batch", [&](size_t) { for (size_t i = 0; i < count; i++) forward(i, Convention::LOCAL); }, double(count)},
    };
    run(operations, std::min<size_t>(count, 1024), std::atof(arguments[4]), std::atoi(arguments[5]));
}
