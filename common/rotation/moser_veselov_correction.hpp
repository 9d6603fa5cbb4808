#pragma once

#include "common/rotation/spin.hpp"

namespace common {

/// A change of the inverse moments of inertia: 1/Ĩ_i = (1 + scale) / I_i + shift.
struct MomentCorrection {
  double scale = 0.0;
  double shift = 0.0;  ///< [1/(kg m²)]
};

/// Returns the correction that raises the discrete Moser-Veselov step from order 2 to a higher one.
/// A step turns the body by the unit quaternion p with
///
///   dt m_i = 2 (p₀ p_i Ĩ_i + (Ĩ_k − Ĩ_j) p_j p_k),  (i, j, k) cyclic,  m = I ω in the body,
///
/// and then turns m by p backwards. With order 2 that is Moser and Veselov's step. With corrected
/// moments it still keeps energy and momentum to rounding. The correction depends only on energy,
/// momentum and moments, so it holds until the next impulse.
///
/// Hairer & Vilmart 2006, Journal of Physics A 39, "Preprocessed discrete Moser-Veselov algorithm
/// for the full dynamics of a rigid body".
///
/// order  2, 4, 6, 8 or 10; the series in |ω| dt behind it is valid below π/2
/// Any moments are allowed, equal ones too, and any state, including a principal spin and rest.
/// Throws std::invalid_argument if no body can have the moments and for another order.
MomentCorrection moser_veselov_correction(const Vec3& moments, const Spin& spin, double dt,
                                          int order);

}  // namespace common
