#pragma once

#include "codec.hpp"
#include "continuous_particle_cylinder.hpp"
#include "contract.hpp"

namespace grading {

namespace student = lab::continuous_particle_cylinder;

template <>
inline constexpr int fields_of<common::Cylinder> = 1;
template <>
inline constexpr int fields_of<common::ParticleContact> = 5;
template <>
inline constexpr int fields_of<student::MovingParticle> = 3;
template <>
inline constexpr int fields_of<student::Advancement> = 2;
template <>
inline constexpr int fields_of<student::MovingParticles> = 5;
template <>
inline constexpr int fields_of<student::MovingEdge> = 5;

/// The answers: times of up to 100,000 particles.
using LabContract =
    Contract<1U << 22, &student::time_of_impact_textbook, &student::difference_of_products,
             &student::time_of_impact, &student::time_of_impact_certified,
             &student::conservative_advancement, &student::contact_at, &student::times_of_impact,
             &student::time_of_impact_of_edge>;

}  // namespace grading
