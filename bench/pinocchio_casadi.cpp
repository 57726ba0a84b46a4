// pinocchio_casadi.cpp: writes the C of Pinocchio's articulated-body algorithm run on casadi::SX.
//
//   pinocchio_casadi <function> < joints      one line of numbers per joint; C on the standard output
#include <pinocchio/autodiff/casadi.hpp>

#include <pinocchio/algorithm/aba.hpp>

#include <iostream>
#include <vector>

#include <casadi/casadi.hpp>

#include "pinocchio_chain.hpp"

typedef casadi::SX SX;
typedef Eigen::Matrix<SX, Eigen::Dynamic, 1> Vector;

static Vector entries(const SX &x)
{
    Vector out(x.size1());
    for (int i = 0; i < out.size(); ++i) {
        out[i] = x(i);
    }
    return out;
}

// Instructions that compute something.
static int operations(const casadi::Function &f)
{
    int count = 0;
    for (casadi_int k = 0; k < f.n_instructions(); ++k) {
        const casadi_int id = f.instruction_id(k);
        count += id != casadi::OP_INPUT && id != casadi::OP_OUTPUT && id != casadi::OP_CONST;
    }
    return count;
}

int main(int argc, char **argv)
{
    std::vector<double> numbers;
    for (double x; std::cin >> x;) {
        numbers.push_back(x);
    }
    const int n = static_cast<int>(numbers.size()) / JOINT_NUMBERS;
    if (argc != 2 || n == 0) {
        std::cerr << "usage: pinocchio_casadi <function> < joints\n";
        return 2;
    }
    const auto joints = reinterpret_cast<const double(*)[JOINT_NUMBERS]>(numbers.data());
    const auto model = chain_model(n, joints).cast<SX>();
    pinocchio::DataTpl<SX> data(model);
    const SX q = SX::sym("q", n), v = SX::sym("v", n), tau = SX::sym("tau", n);
    pinocchio::aba(model, data, entries(q), entries(v), entries(tau));
    SX vdot(n, 1);
    for (int i = 0; i < n; ++i) {
        vdot(i) = data.ddq[i];
    }
    const casadi::Function f(argv[1], { q, v, tau }, { vdot });
    casadi::CodeGenerator generator(std::string(argv[1]) + ".c");
    generator.add(f);
    std::cout << "/* operations: " << operations(f) << " */\n" << generator.dump();
    return 0;
}
