#pragma once

#include "codec.hpp"
#include "contract.hpp"
#include "impulse_response.hpp"

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
using LabContract =
    Contract<1U << 20, &student::normal_impulse, &student::friction_impulse,
             &student::normal_correction, &student::tangential_correction,
             &student::step_by_projection, &student::step_to_impact,
             &student::inverse_effective_mass, &student::contact_impulse, &student::with_impulse>;

}  // namespace grading
