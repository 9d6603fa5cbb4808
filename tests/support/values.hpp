#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdio>
#include <limits>
#include <string>

#include "common/algebra/dense.hpp"
#include "common/types.hpp"

/// Functions by which tests compare and print the values that contracts return.
namespace tests {

using common::Mat3;
using common::Quat;
using common::Vec3;

/// The distance from 1 to the next double. A rounded operation has at most half of it as its
/// relative error.
inline constexpr double eps = std::numeric_limits<double>::epsilon();

inline bool is_finite(double value) { return std::isfinite(value); }
inline bool is_finite(const Quat& value) { return value.coeffs().allFinite(); }
template <typename Derived>
bool is_finite(const Eigen::MatrixBase<Derived>& value) {
  return value.allFinite();
}

/// Return the length of all entries together, without overflow or underflow on the way.
inline double length(double value) { return std::abs(value); }
inline double length(const Vec3& value) { return value.stableNorm(); }
inline double length(const Quat& value) { return value.coeffs().stableNorm(); }
inline double length(const Mat3& value) {
  return Eigen::Map<const Eigen::Matrix<double, 9, 1>>(value.data()).stableNorm();
}

/// What has no three entries, in values.cpp: these types themselves, as an expression fits them
/// all.
template <typename Value>
concept OtherSize = std::same_as<Value, Eigen::Vector2d> || std::same_as<Value, Eigen::VectorXd> ||
    std::same_as<Value, common::Matrix>;
double length_of(const double* entries, Eigen::Index count);
std::string text_of(const Eigen::Vector2d& v);
std::string text_of(const Eigen::VectorXd& v);
std::string text_of(const common::Matrix& m);

template <OtherSize Value>
double length(const Value& value) {
  return length_of(value.data(), value.size());
}
/// Infinite if the sizes are not the same.
template <OtherSize Value>
double difference(const Value& a, const Value& b) {
  if (a.rows() != b.rows() || a.cols() != b.cols()) return std::numeric_limits<double>::infinity();
  return length(Value(a - b));
}

inline double difference(double a, double b) { return length(a - b); }
inline double difference(const Vec3& a, const Vec3& b) { return length(Vec3(a - b)); }
inline double difference(const Mat3& a, const Mat3& b) { return length(Mat3(a - b)); }
/// q and −q are the same attitude.
inline double difference(const Quat& a, const Quat& b) {
  return std::min((a.coeffs() - b.coeffs()).norm(), (a.coeffs() + b.coeffs()).norm());
}

/// Returns the shortest decimal that reads back as the same double: 17 digits if 15 are too few.
inline std::string text(double value) {
  char digits[32];
  for (const int precision : {6, 15, 17}) {
    std::snprintf(digits, sizeof digits, "%.*g", precision, value);
    if (std::strtod(digits, nullptr) == value) break;
  }
  return digits;
}
/// Return C++ that a student can paste.
inline std::string text(const Vec3& v) {
  return "Vec3(" + text(v.x()) + ", " + text(v.y()) + ", " + text(v.z()) + ")";
}
inline std::string text(const Quat& q) {
  return "Quat(" + text(q.w()) + ", " + text(q.x()) + ", " + text(q.y()) + ", " + text(q.z()) + ")";
}
inline std::string text(const Mat3& m) {
  std::string rows = "Mat3{";
  for (int i = 0; i < 3; ++i) {
    rows += i == 0 ? "{" : ", {";
    rows += text(m(i, 0)) + ", " + text(m(i, 1)) + ", " + text(m(i, 2)) + "}";
  }
  return rows + "}";
}
template <OtherSize Value>
std::string text(const Value& value) {
  return text_of(value);
}

/// Text that stands for an argument, printed as it is.
struct Code {
  std::string words;
};
inline std::string text(const Code& code) { return code.words; }

/// A decision as a value.
struct Decision {
  bool yes = false;
};
inline bool is_finite(const Decision&) { return true; }
inline double length(const Decision&) { return 1.0; }
inline double difference(const Decision& a, const Decision& b) {
  return a.yes == b.yes ? 0.0 : 1.0;
}
inline std::string text(const Decision& v) { return v.yes ? "true" : "false"; }

}  // namespace tests
