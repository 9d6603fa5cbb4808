#pragma once

#include "common/types.hpp"

namespace common {

/// A = U diag(S) Vᵀ with U and V orthogonal (of either determinant), S ≥ 0 and falling.
struct SingularValues {
  Mat3 U;
  Vec3 S;
  Mat3 V;
};

/// The singular value decomposition of a 3 x 3 matrix, to rounding (two-sided Jacobi). Compiled
/// once here, since the decomposition is slow to compile and beside the point of the labs.
/// Throws std::invalid_argument where an entry is NaN or infinite.
SingularValues singular_values(const Mat3& matrix);

/// The inverse of a 3 x 3 matrix by cofactors, compiled once here for the same reason. Entries that
/// are not finite come of a matrix that has none.
Mat3 inverse(const Mat3& matrix);

}  // namespace common
