#pragma once

#include <array>

#include "common/elliptic/jacobi_elliptic.hpp"
#include "common/types.hpp"

namespace common {

/// The polhode and the constants of the motion along it. The polhode is the closed curve in the
/// body on which the angular momentum of a torque-free body moves. The axes are renamed (c, s, d):
/// s has the intermediate moment, d is the outer axis that the momentum circles, and c is the
/// third. c points along the negative axis if that is needed to keep them right-handed.
///
///   m = L (a cn u, b sn u, g dn u),  u = u₀ + λ t        Landau & Lifshitz, Mechanics, §37
///
/// `steady` is set if the angular velocity stays constant in the body: for a principal spin, a
/// spherical body, a symmetric body that turns about its equator, and at rest.
struct Polhode {
  bool steady = true;
  std::array<int, 3> axes{0, 1, 2};      ///< the body's numbers of the axes c, s and d
  double sign_c = 1.0;                   ///< −1 if c points along the body's negative axis
  Vec3 amplitudes = Vec3::Zero();        ///< (a, b, g), of the momentum over its length
  Vec3 rates = Vec3::Zero();             ///< L over the moments about c, s and d [rad/s]
  double lambda = 0.0;                   ///< λ [rad/s]; 0 if no small wobble swings
  double complementary_parameter = 1.0;  ///< k'², 0 on the separatrix
  double excess = 0.0;                   ///< b²/a² − 1 ≥ 0, from the moments alone
  double ratio = 1.0;                    ///< b / a, which a principal spin (a = b = 0) has, too
  JacobiFunctions start;                 ///< at u₀
};

/// Returns the polhode of a body with this angular velocity, body frame [rad/s]. The rounding error
/// of D = L² − 2 E I_s would shift the time of the flip, so D is computed without rounding.
/// requires  moments that checked_moments accepts, and a finite angular_velocity
Polhode polhode(const Vec3& moments, const Vec3& angular_velocity);

/// Returns a vector of the axes (c, s, d) in the body frame.
Vec3 in_body(const Polhode& polhode, const Vec3& of_axes);

/// Returns the same as a rotation.
Quat body_from_axes(const Polhode& polhode);

/// The way along the polhode in a time, from u = 0.
struct PolhodeAdvance {
  JacobiFunctions functions;  ///< at u = λ t
  double precession = 0.0;    ///< turn about the momentum, from the line of nodes of m [rad]
};

/// requires  a polhode that is not steady
PolhodeAdvance polhode_advance(const Polhode& polhode, double time);

}  // namespace common
