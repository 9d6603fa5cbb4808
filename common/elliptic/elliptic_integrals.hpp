#pragma once

#include "common/elliptic/jacobi_elliptic.hpp"

namespace common {

/// Legendre's elliptic integrals from 0 to an argument u of Jacobi's functions, |u| ≤ K. They take
/// the functions at u. In Carlson's forms every term is positive, so nothing cancels.

/// Returns u itself: this is the inverse of the functions.
double first_kind(const JacobiFunctions& at, double complementary_parameter);

/// Returns ∫ du / (cn² u + r sn² u), for r > 0: the third kind, Π(n; am u, k) with n = 1 − r.
double third_kind(const JacobiFunctions& at, double r, double complementary_parameter);

/// Returns ∫ cn² u du / (cn² u + r sn² u), for r ≥ 1.
double cosine_share(const JacobiFunctions& at, double r, double complementary_parameter);

}  // namespace common
