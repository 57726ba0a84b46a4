// pinocchio_data.hpp: a rigid chain as a Pinocchio model, with what the algorithms keep of it.
#pragma once

#include "pinocchio_chain.hpp"

struct Chain {
    explicit Chain(const pinocchio::Model &m) : model(m), data(model) {}
    pinocchio::Model model;
    pinocchio::Data data;
};

typedef Eigen::Map<const Eigen::VectorXd> Vector;
