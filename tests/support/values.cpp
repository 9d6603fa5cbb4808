#include "values.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace tests {
namespace {

std::string listed(const Eigen::VectorXd& v) {
  std::string list;
  for (Eigen::Index i = 0; i < v.size(); ++i) list += (i == 0 ? "" : ", ") + text(v[i]);
  return "{" + list + "}";
}

}  // namespace

double length(const Vec3& value) { return length_of(value.data(), value.size()); }
double length(const Quat& value) { return length_of(value.coeffs().data(), 4); }
double length(const Mat3& value) { return length_of(value.data(), value.size()); }

double length_of(const double* entries, Eigen::Index count) {
  return Eigen::Map<const Eigen::VectorXd>(entries, count).stableNorm();
}

double difference(const Vec3& a, const Vec3& b) { return length(Vec3(a - b)); }
double difference(const Mat3& a, const Mat3& b) { return length(Mat3(a - b)); }
double difference(const Quat& a, const Quat& b) {
  return std::min((a.coeffs() - b.coeffs()).norm(), (a.coeffs() + b.coeffs()).norm());
}

std::string text(double value) {
  char digits[32];
  for (const int precision : {6, 15, 17}) {
    std::snprintf(digits, sizeof digits, "%.*g", precision, value);
    if (std::strtod(digits, nullptr) == value) break;
  }
  return digits;
}
std::string text(const Vec3& v) {
  return "Vec3(" + text(v.x()) + ", " + text(v.y()) + ", " + text(v.z()) + ")";
}
std::string text(const Quat& q) {
  return "Quat(" + text(q.w()) + ", " + text(q.x()) + ", " + text(q.y()) + ", " + text(q.z()) + ")";
}
std::string text(const Mat3& m) {
  std::string rows = "Mat3{";
  for (int i = 0; i < 3; ++i) {
    rows += i == 0 ? "{" : ", {";
    rows += text(m(i, 0)) + ", " + text(m(i, 1)) + ", " + text(m(i, 2)) + "}";
  }
  return rows + "}";
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
