#pragma once

#include <cmath>

namespace common {

/// Jacobi's elliptic functions of one argument u and one modulus k. The modulus is given by its
/// complementary parameter k'² = 1 − k² in [0, 1] throughout: near the separatrix, where k² rounds
/// to 1, all that matters is in k'².
struct JacobiFunctions {
  double sn = 0.0;
  double cn = 1.0;
  double dn = 1.0;
};

/// sn u, cn u and dn u, for |u| up to the quarter period K (beyond it they lose what the reduction
/// by K would keep); k'² = 0 takes every u. Gauss's transformation of the arithmetic-geometric
/// mean; Bulirsch 1965, Numerische Mathematik 7.
JacobiFunctions jacobi_functions(double u, double complementary_parameter);

/// The quarter period K(k) = π / (2 agm(1, k')); infinite for k' = 0.
double quarter_period(double complementary_parameter);

/// sn K, cn K and dn K.
inline JacobiFunctions functions_at_quarter_period(double complementary_parameter) {
  return {1.0, 0.0, std::sqrt(complementary_parameter)};
}

/// u = within + 2 K half_turns, with |within| ≤ K: sn and cn have the sign (−1)^half_turns there.
struct ReducedArgument {
  double within = 0.0;
  double half_turns = 0.0;
};

ReducedArgument reduced_argument(double u, double complementary_parameter);

/// The functions of the sum u + v, by the addition theorem (DLMF 22.8.1 to 22.8.3), put back on
/// sn² + cn² = 1 and dn² = cn² + k'² sn². With k' = 0 both cn must be above zero, as sech is.
JacobiFunctions jacobi_functions_of_sum(const JacobiFunctions& of_u, const JacobiFunctions& of_v,
                                        double complementary_parameter);

}  // namespace common
