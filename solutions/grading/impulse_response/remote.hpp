#pragma once

#include "codec.hpp"
#include "functions.hpp"

namespace grading {

namespace student = lab::impulse_response;

template <>
inline constexpr int fields_of<common::Plane> = 2;
template <>
inline constexpr int fields_of<common::Cylinder> = 1;
template <>
inline constexpr int fields_of<student::Material> = 2;
template <>
inline constexpr int fields_of<student::Particle> = 3;
template <>
inline constexpr int fields_of<student::Corrections> = 2;
template <>
inline constexpr int fields_of<student::ProjectedStep> = 2;
template <>
inline constexpr int fields_of<student::Impact> = 2;
template <>
inline constexpr int fields_of<student::ImpactStep> = 3;
template <>
inline constexpr int fields_of<student::RigidBody> = 5;
template <>
inline constexpr int fields_of<student::Contact> = 2;

/// The answers: lists of impacts.
using LabContract = ContractOf<1U << 20>;

}  // namespace grading
