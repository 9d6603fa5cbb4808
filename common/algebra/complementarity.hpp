#pragma once

#include "common/algebra/dense.hpp"

namespace common {

/// λ with 0 ≤ λ, A λ + b ≥ 0 and λ·(A λ + b) = 0, to rounding.
///
/// A is symmetric and positive semi-definite. If A is singular, λ need not be unique, but A λ is.
/// By an active set, which takes an entry in only if A λ + b is below zero there by more than
/// rounding: 1e-12 of the largest |b_i|. So ties do no harm.
/// Throws std::domain_error if there is no such λ, std::invalid_argument as require_system does.
Vector complementary(const Matrix& A, const Vector& b);

/// The shortest x with A x = b; it is unique, and no entry has a sign that is asked for.
///
/// A is symmetric and positive semi-definite.
/// Throws std::domain_error if no x solves it to 1e-9 of the largest |b_i|, or to rounding if x is
/// large; std::invalid_argument as require_system does.
Vector least_norm_solution(const Matrix& A, const Vector& b);

}  // namespace common
