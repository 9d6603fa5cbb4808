#pragma once

#include "common/bernstein.hpp"
#include "common/exact_roots.hpp"
#include "common/types.hpp"

/// Without rounding: points that move straight on, their products as polynomials in time, and a
/// polynomial's coefficients in Bernstein's form.
namespace common {

/// A point of the yz-plane.
struct ExactPath {
  ExactPolynomial y, z;
};

/// x + s step for s from 0 to 1, with step = duration v.
ExactPath exact_path(const Vec3& x, const Vec3& v, double duration);

ExactPath operator-(const ExactPath& a, const ExactPath& b);
ExactPolynomial dot(const ExactPath& a, const ExactPath& b);
/// a_y b_z − a_z b_y.
ExactPolynomial cross(const ExactPath& a, const ExactPath& b);

/// The coefficients over [0, 1] of a polynomial of degree 4 at most, times a number above zero by
/// which the largest is in [1/2, 1]: each to 4 u², u² = 2⁻¹⁰⁶. Of zero all are zero.
Bernstein<DoubleDouble, 4> bernstein(const ExactPolynomial& polynomial);

/// How far off they are after up to 50 halvings, each of which costs four sums: 604 u².
inline constexpr double bernstein_error = 1e-29;

}  // namespace common
