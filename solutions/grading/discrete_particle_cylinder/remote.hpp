#pragma once

#include "codec.hpp"
#include "functions.hpp"

namespace grading {

namespace student = lab::discrete_particle_cylinder;

template <>
inline constexpr int fields_of<common::Cylinder> = 1;
template <>
inline constexpr int fields_of<common::ParticleContact> = 5;
template <>
inline constexpr int fields_of<student::StraightPath> = 3;
template <>
inline constexpr int fields_of<student::EdgeGap> = 2;
template <>
inline constexpr int fields_of<student::TriangleGap> = 2;
template <>
inline constexpr int fields_of<student::Sheet> = 4;
template <>
inline constexpr int fields_of<student::SheetContacts> = 3;

/// The answers: lists of up to 100,000 indices.
using LabContract = ContractOf<1U << 22>;

}  // namespace grading
