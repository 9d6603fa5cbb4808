#include "common/algebra/linear_algebra.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <stdexcept>

namespace common {

SingularValues singular_values(const Mat3& matrix) {
  if (!matrix.allFinite()) {
    throw std::invalid_argument("singular_values: an entry of the matrix is NaN or infinite");
  }
  const Eigen::JacobiSVD<Mat3> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return {svd.matrixU(), svd.singularValues(), svd.matrixV()};
}

Mat3 inverse(const Mat3& matrix) { return matrix.inverse(); }

}  // namespace common
