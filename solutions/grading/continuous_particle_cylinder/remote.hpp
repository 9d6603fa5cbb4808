#pragma once

#include "codec.hpp"
#include "functions.hpp"

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
using LabContract = ContractOf<1U << 22>;

}  // namespace grading
