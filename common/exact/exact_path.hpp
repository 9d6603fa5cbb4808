#pragma once

#include "common/exact/bernstein.hpp"
#include "common/exact/exact_roots.hpp"
#include "common/types.hpp"

/// Points on straight paths, their products as polynomials in time, and a polynomial's coefficients
/// in Bernstein's form. Nothing is rounded except these coefficients.
namespace common {

/// A moving point of the yz-plane.
struct ExactPath {
  ExactPolynomial y, z;
};

/// Returns x + s step for s from 0 to 1, with step = duration v.
ExactPath exact_path(const Vec3& x, const Vec3& v, double duration);

ExactPath operator-(const ExactPath& a, const ExactPath& b);
ExactPolynomial dot(const ExactPath& a, const ExactPath& b);
/// Returns a_y b_z − a_z b_y.
ExactPolynomial cross(const ExactPath& a, const ExactPath& b);

/// Returns the coefficients over [0, 1] of a polynomial of degree 4 at most. They are scaled by a
/// number above zero, so that the largest is in [1/2, 1], and right to 4 u², u² = 2⁻¹⁰⁶. For zero
/// all are zero.
Bernstein<DoubleDouble, 4> bernstein(const ExactPolynomial& polynomial);

/// The error after up to 50 halvings, each of which costs four sums: 604 u².
inline constexpr double bernstein_error = 1e-29;

}  // namespace common
