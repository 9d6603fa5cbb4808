#pragma once

#include "codec.hpp"
#include "contract.hpp"
#include "multi_contact.hpp"

namespace grading {

namespace student = lab::multi_contact;

template <>
inline constexpr int fields_of<common::RigidBody> = 5;
template <>
inline constexpr int fields_of<student::Contact> = 4;
template <>
inline constexpr int fields_of<student::ContactSystem> = 2;
template <>
inline constexpr int fields_of<student::Impulses> = 3;
template <>
inline constexpr int enumerators_of<student::FrictionRule> = 3;

/// The answers: a matrix with a row and a column for each of some hundred contacts.
using LabContract =
    Contract<1U << 22, &student::contact_system, &student::with_impulses, &student::energy_gained,
             &student::sequential_impulses, &student::gauss_seidel, &student::residual,
             &student::simultaneous_impulses, &student::generalized_reflections,
             &student::inelastic_projection, &student::limited, &student::friction_sweeps,
             &student::coulomb_residual, &student::accelerated>;

}  // namespace grading
