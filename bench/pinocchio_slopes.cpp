// pinocchio_slopes.cpp: Pinocchio's forward dynamics and its derivatives in loops, timed by the thread's own clock.
#include <pinocchio/algorithm/aba-derivatives.hpp>
#include <pinocchio/algorithm/aba.hpp>

#include <ctime>

#include "pinocchio_data.hpp"

namespace {

typedef Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> Rows;

double seconds()
{
    timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return t.tv_sec + 1e-9 * t.tv_nsec;
}

// Seconds that so many calls of an algorithm take at a state.
template <typename Algorithm>
double timed(void *chain, const double *q, const double *v, const double *tau, long calls, Algorithm algorithm)
{
    Chain *x = static_cast<Chain *>(chain);
    const int n = x->model.nv;
    const double begin = seconds();
    for (long k = 0; k < calls; ++k) {
        algorithm(x->model, x->data, Vector(q, n), Vector(v, n), Vector(tau, n));
    }
    return seconds() - begin;
}

} // namespace

extern "C" {

void *peer_chain(int n, const double (*joints)[JOINT_NUMBERS])
{
    return new Chain(chain_model(n, joints));
}

double peer_dynamics(void *chain, const double *q, const double *v, const double *tau, long calls)
{
    return timed(chain, q, v, tau, calls, [](const auto &model, auto &data, const auto &...at) {
        pinocchio::aba(model, data, at...);
    });
}

double peer_derivatives(void *chain, const double *q, const double *v, const double *tau, long calls)
{
    return timed(chain, q, v, tau, calls, [](const auto &model, auto &data, const auto &...at) {
        pinocchio::computeABADerivatives(model, data, at...);
    });
}

// Accelerations (n), and the changes with q, v and tau (n by n, row by row).
void peer_results(const void *chain, double *vdot, double *by_q, double *by_v, double *by_tau)
{
    const pinocchio::Data &data = static_cast<const Chain *>(chain)->data;
    const int n = data.ddq.size();
    Eigen::Map<Eigen::VectorXd>(vdot, n) = data.ddq;
    Rows(by_q, n, n) = data.ddq_dq;
    Rows(by_v, n, n) = data.ddq_dv;
    Rows(by_tau, n, n) = Eigen::MatrixXd(data.Minv.selfadjointView<Eigen::Upper>());
}
}
