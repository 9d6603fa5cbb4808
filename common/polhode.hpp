#pragma once

#include <array>

#include "common/jacobi_elliptic.hpp"
#include "common/types.hpp"

namespace common {

/// The polhode: the closed curve on which the angular momentum of a torque-free body runs in the
/// body, and the constants of the motion along it. The axes are renamed (c, s, d): s has the
/// intermediate moment, d is the outer axis that the momentum circles, and c the other one; along
/// −c where that is needed to keep them right-handed.
///
///   m = L (a cn u, b sn u, g dn u),  u = u₀ + λ t        Landau & Lifshitz, Mechanics, §37
///
/// A body whose angular velocity stays constant in the body (a principal spin, a spherical body, a
/// symmetric body turning about its equator, rest) has `steady` set.
struct Polhode {
  bool steady = true;
  std::array<int, 3> axes{0, 1, 2};      ///< the body's numbers of the axes c, s and d
  double sign_c = 1.0;                   ///< −1 where c points along the body's negative axis
  Vec3 amplitudes = Vec3::Zero();        ///< (a, b, g), of the momentum over its length
  Vec3 rates = Vec3::Zero();             ///< L over the moments about c, s and d [rad/s]
  double lambda = 0.0;                   ///< λ [rad/s]; 0 where no small wobble swings
  double complementary_parameter = 1.0;  ///< k'², 0 on the separatrix
  double excess = 0.0;                   ///< b²/a² − 1 ≥ 0, of the moments alone
  double ratio = 1.0;                    ///< b / a, which a principal spin (a = b = 0) has as well
  JacobiFunctions start;                 ///< at u₀
};

/// From where a body is and turns, body frame [rad/s]. The rounding of D = L² − 2 E I_s would pass
/// into the time of the flip, so it is formed without any.
/// requires  moments as checked_moments lets pass; finite angular_velocity
Polhode polhode(const Vec3& moments, const Vec3& angular_velocity);

/// A vector of the axes (c, s, d) in the body frame.
Vec3 in_body(const Polhode& polhode, const Vec3& of_axes);

/// The same as a rotation.
Quat body_from_axes(const Polhode& polhode);

/// How far the motion gets along the polhode in a time, from u = 0.
struct PolhodeAdvance {
  JacobiFunctions functions;  ///< at u = λ t
  double precession = 0.0;    ///< turn about the momentum, from the line of nodes of m [rad]
};

/// requires  a polhode that is not steady
PolhodeAdvance polhode_advance(const Polhode& polhode, double time);

}  // namespace common
