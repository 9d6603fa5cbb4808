#pragma once

#include <cmath>
#include <concepts>
#include <limits>
#include <string>

#include "common/algebra/dense.hpp"
#include "common/types.hpp"

/// Functions by which tests compare and print the values that contracts return. Every test file
/// includes them, so what is no template is compiled once, in values.cpp.
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
double length(const Vec3& value);
double length(const Quat& value);
double length(const Mat3& value);

/// What has no three entries. These types themselves are meant, because an expression would fit all
/// of them.
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
double difference(const Vec3& a, const Vec3& b);
double difference(const Mat3& a, const Mat3& b);
/// q and −q are the same attitude.
double difference(const Quat& a, const Quat& b);

/// Returns the shortest decimal that reads back as the same double: 17 digits if 15 are too few.
std::string text(double value);
/// Return C++ that a student can paste.
std::string text(const Vec3& v);
std::string text(const Quat& q);
std::string text(const Mat3& m);
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
