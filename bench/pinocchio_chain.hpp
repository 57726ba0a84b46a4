// pinocchio_chain.hpp: a rigid chain of revolute joints as a Pinocchio model.
#pragma once

#include <pinocchio/multibody.hpp>

#include <string>

#include "pinocchio_aba.h"

inline pinocchio::Model chain_model(int n, const double (*joints)[JOINT_NUMBERS])
{
    pinocchio::Model model;
    pinocchio::JointIndex parent = 0;
    for (int i = 0; i < n; ++i) {
        const double *x = joints[i];
        const pinocchio::SE3 place(Eigen::Matrix3d::Identity(), Eigen::Vector3d(x[1], 0, 0));
        const std::string name = "joint" + std::to_string(i);
        if (x[0] == 0) {
            parent = model.addJoint(parent, pinocchio::JointModelRX(), place, name);
        } else if (x[0] == 1) {
            parent = model.addJoint(parent, pinocchio::JointModelRY(), place, name);
        } else {
            parent = model.addJoint(parent, pinocchio::JointModelRZ(), place, name);
        }
        const Eigen::Matrix3d inertia = Eigen::Vector3d(x[4], x[5], x[6]).asDiagonal();
        model.appendBodyToJoint(parent, pinocchio::Inertia(x[2], Eigen::Vector3d(x[3], 0, 0), inertia));
    }
    return model; // gravity: Pinocchio's default, (0, 0, -9.81)
}
