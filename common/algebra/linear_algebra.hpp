#pragma once

#include "common/types.hpp"

namespace common {

/// A = U diag(S) Vᵀ with U and V orthogonal (of either determinant), and S ≥ 0 in falling order.
struct SingularValues {
  Mat3 U;
  Vec3 S;
  Mat3 V;
};

/// Returns the singular value decomposition of a 3 x 3 matrix, to rounding (two-sided Jacobi). It
/// is compiled once here, because it is slow to compile and not a subject of the labs.
/// Throws std::invalid_argument if an entry is NaN or infinite.
SingularValues singular_values(const Mat3& matrix);

/// Returns the inverse of a 3 x 3 matrix by cofactors, compiled once here for the same reason. If
/// the matrix has no inverse, entries are not finite.
Mat3 inverse(const Mat3& matrix);

}  // namespace common
