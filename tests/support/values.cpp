#include "values.hpp"

namespace tests {
namespace {

std::string listed(const Eigen::VectorXd& v) {
  std::string list;
  for (Eigen::Index i = 0; i < v.size(); ++i) list += (i == 0 ? "" : ", ") + text(v[i]);
  return "{" + list + "}";
}

}  // namespace

double length_of(const double* entries, Eigen::Index count) {
  return Eigen::Map<const Eigen::VectorXd>(entries, count).stableNorm();
}

std::string text_of(const Eigen::Vector2d& v) {
  return "Vec2(" + text(v.x()) + ", " + text(v.y()) + ")";
}

std::string text_of(const Eigen::VectorXd& v) {
  if (v.size() == 0) return "Vector(0)";
  return "Vector{" + listed(v) + "}";  // braces twice: once is a size
}

std::string text_of(const common::Matrix& m) {
  if (m.size() == 0) {
    return "Matrix(" + std::to_string(m.rows()) + ", " + std::to_string(m.cols()) + ")";
  }
  std::string rows;
  for (Eigen::Index i = 0; i < m.rows(); ++i) rows += (i == 0 ? "" : ", ") + listed(m.row(i));
  return "Matrix{" + rows + "}";
}

}  // namespace tests
