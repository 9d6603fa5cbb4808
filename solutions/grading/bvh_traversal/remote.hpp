#pragma once

#include "bvh_traversal.hpp"
#include "codec.hpp"
#include "contract.hpp"

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
using LabContract =
    Contract<1U << 26, &student::box_of, &student::merged, &student::overlap,
             &student::surface_area, &student::build_median, &student::traverse_as_first_written,
             &student::traverse, &student::triangles_meet, &student::find_intersections,
             &student::build_sah, &student::find_intersections_moved, &student::refit>;

}  // namespace grading
