#pragma once

#include <cmath>

namespace common {

/// Jacobi's elliptic functions of an argument u and a modulus k. The modulus is always given by its
/// complementary parameter k'² = 1 − k² in [0, 1]. Near the separatrix k² rounds to 1, and then
/// only k'² has the digits that matter.
struct JacobiFunctions {
  double sn = 0.0;
  double cn = 1.0;
  double dn = 1.0;
};

/// Returns sn u, cn u and dn u, for |u| up to the quarter period K. Beyond K they lose digits that
/// the reduction by K keeps. If k'² = 0, every u is allowed. Gauss's transformation of the
/// arithmetic-geometric mean; Bulirsch 1965, Numerische Mathematik 7.
JacobiFunctions jacobi_functions(double u, double complementary_parameter);

/// Returns the quarter period K(k) = π / (2 agm(1, k')). It is infinite for k' = 0.
double quarter_period(double complementary_parameter);

/// Returns sn K, cn K and dn K.
inline JacobiFunctions functions_at_quarter_period(double complementary_parameter) {
  return {1.0, 0.0, std::sqrt(complementary_parameter)};
}

/// u = within + 2 K half_turns, with |within| ≤ K. sn u and cn u have the sign (−1)^half_turns of
/// those at `within`.
struct ReducedArgument {
  double within = 0.0;
  double half_turns = 0.0;
};

ReducedArgument reduced_argument(double u, double complementary_parameter);

/// Returns the functions of the sum u + v, by the addition theorem (DLMF 22.8.1 to 22.8.3), scaled
/// back to sn² + cn² = 1 and dn² = cn² + k'² sn². If k' = 0, both cn must be above zero, like sech.
JacobiFunctions jacobi_functions_of_sum(const JacobiFunctions& of_u, const JacobiFunctions& of_v,
                                        double complementary_parameter);

}  // namespace common
