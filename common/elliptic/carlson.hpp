#pragma once

namespace common {

/// Carlson's symmetric elliptic integrals, to a few ulp: Carlson 1995, Numerical Algorithms 10.

/// Returns R_C(x, y) = ½ ∫₀^∞ dt / (√(t + x) (t + y)), for x ≥ 0 and y > 0.
double carlson_rc(double x, double y);

/// Returns R_F(x, y, z) = ½ ∫₀^∞ dt / √((t + x)(t + y)(t + z)), for arguments ≥ 0, at most one of
/// them 0.
double carlson_rf(double x, double y, double z);

/// Returns R_J(x, y, z, p) = 3/2 ∫₀^∞ dt / ((t + p) √((t + x)(t + y)(t + z))), for x, y, z ≥ 0, at
/// most one of them 0, and p > 0.
double carlson_rj(double x, double y, double z, double p);

}  // namespace common
