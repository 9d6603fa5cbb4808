#pragma once

#include "codec.hpp"
#include "functions.hpp"

namespace grading {

namespace student = lab::rigid_body_kinematics;

template <>
inline constexpr int fields_of<student::RigidBodyState> = 4;
template <>
inline constexpr int fields_of<student::AppliedForce> = 2;
template <>
inline constexpr int fields_of<student::Wrench> = 2;

/// The answers: a few numbers.
using LabContract = ContractOf<1U << 12>;

}  // namespace grading
