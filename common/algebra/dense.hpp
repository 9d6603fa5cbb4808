#pragma once

#include <functional>
#include <vector>

#include "common/types.hpp"

/// Matrices and vectors whose size is known at run time only, and what is slow to compile of their
/// algebra, compiled once.
namespace common {

/// Row by row in memory, because the solvers take one row at a time.
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Vector = Eigen::VectorXd;

/// A x.
Vector product(const Matrix& A, const Vector& x);
/// Row i of A, times x.
double row_product(const Matrix& A, int i, const Vector& x);

/// The largest |x_i|; 0 if there are none.
double largest_entry(const Vector& x);

/// The entries with these numbers, in this order: x_V.
Vector entries(const Vector& x, const std::vector<int>& rows);
/// The other way: a vector of this size with x at these numbers, and 0 elsewhere.
Vector spread(const Vector& x, const std::vector<int>& rows, Eigen::Index size);
/// These rows and the same columns, in this order: A_VV.
Matrix block(const Matrix& A, const std::vector<int>& rows);

/// The largest eigenvalue of a symmetric matrix; 0 if it has no rows.
double largest_eigenvalue(const Matrix& A);
/// The same of a matrix with so many rows that is known by its products with vectors; no entry is
/// larger than `largest_entry` in size.
double largest_eigenvalue(Eigen::Index rows, double largest_entry,
                          const std::function<Vector(const Vector&)>& product);

/// Each throws std::invalid_argument, and lets NaN pass nowhere, see common/course/require.hpp.
///
/// Of this size, every entry finite.
void require_entries(const Vector& x, Eigen::Index size, const char* name);
/// A is finite, square, symmetric to 1e-9 of its largest entry, and above zero all along its
/// diagonal; b is finite, with an entry for each row of A.
void require_system(const Matrix& A, const Vector& b);
/// The same, and lambda has this size, too, every entry finite.
void require_system(const Matrix& A, const Vector& b, const Vector& lambda);

}  // namespace common
