#pragma once

#include "codec.hpp"
#include "functions.hpp"

namespace grading {

namespace student = lab::bvh_traversal;

template <>
inline constexpr int fields_of<common::TriangleMesh> = 2;
template <>
inline constexpr int fields_of<common::RigidTransform> = 2;
template <>
inline constexpr int fields_of<student::Box> = 2;
template <>
inline constexpr int fields_of<student::BvhNode> = 3;
template <>
inline constexpr int fields_of<student::Bvh> = 3;
template <>
inline constexpr int fields_of<student::NodePair> = 2;
template <>
inline constexpr int fields_of<student::Traversal> = 2;
template <>
inline constexpr int fields_of<student::TrianglePair> = 2;
template <>
inline constexpr int fields_of<student::Intersections> = 3;

/// The answers: trees of some 200 bytes a triangle.
using LabContract = ContractOf<1U << 26>;

}  // namespace grading
