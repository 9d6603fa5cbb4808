#pragma once

#include "codec.hpp"
#include "functions.hpp"

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
using LabContract = ContractOf<1U << 22>;

}  // namespace grading
