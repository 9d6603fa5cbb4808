#pragma once

#include "codec.hpp"
#include "contract.hpp"
#include "discrete_particle_cylinder.hpp"

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
using LabContract =
    Contract<1U << 22, &student::gap, &student::gap_gradient, &student::contact,
             &student::particles_in_contact, &student::first_sampled_contact, &student::edge_gap,
             &student::triangle_gap, &student::sheet_contacts, &student::particle_margin>;

}  // namespace grading
