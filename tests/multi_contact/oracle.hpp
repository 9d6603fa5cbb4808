#pragma once

#include <optional>

#include "multi_contact.hpp"

/// The complementarity problem once more, by trying which contacts push, in rational arithmetic.
namespace tests {

using lab::multi_contact::Contact;
using lab::multi_contact::ContactSystem;
using lab::multi_contact::Impulses;
using lab::multi_contact::Matrix;
using lab::multi_contact::RigidBody;
using lab::multi_contact::Vector;

using Real = long double;
inline Real wide(double x) { return static_cast<Real>(x); }

struct Solution {
  Vector lambda;  ///< one of them, if A is singular
  Vector u;       ///< A λ + b: there is only one
};

/// 0 ≤ λ, A λ + b ≥ 0, λ·(A λ + b) = 0 with no rounding but of what is returned; none if no λ
/// obeys.
///
/// All sets of contacts are tried, so there are up to 12 of these. A is taken as it is: where it is
/// to be singular it has to be so without rounding.
std::optional<Solution> exact_solution(const Matrix& A, const Vector& b);

/// A λ + b in rational arithmetic, rounded once; NaN if one of them is not finite.
Vector exact_row_sums(const Matrix& A, const Vector& lambda, const Vector& b);

}  // namespace tests
