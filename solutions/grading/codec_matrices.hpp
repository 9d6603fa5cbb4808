#pragma once

#include <cstdint>
#include <limits>
#include <type_traits>

#include "codec_scalars.hpp"
#include "common/types.hpp"

/// Matrices, vectors and quaternions as bytes.
namespace grading {

template <typename Value>
concept AnyMatrix = std::is_base_of_v<Eigen::MatrixBase<Value>, Value>;

/// Matrices and quaternions of fixed size: their numbers as they lie in memory.
template <AnyMatrix Value>
requires(Value::SizeAtCompileTime > 0) struct Codec<Value> {
  static constexpr std::size_t size = Value::SizeAtCompileTime * sizeof(typename Value::Scalar);
  static void write(Writer& to, const Value& value) { to.add(value.data(), size); }
  static void read(Reader& from, Value& value) { from.take(value.data(), size); }
};

/// Matrices and vectors of any size: rows, columns, numbers. No size asks for more memory than the
/// bytes that have arrived.
template <AnyMatrix Value>
requires(Value::SizeAtCompileTime == Eigen::Dynamic) struct Codec<Value> {
  using Scalar = typename Value::Scalar;
  static void write(Writer& to, const Value& value) {
    Codec<std::int64_t>::write(to, value.rows());
    Codec<std::int64_t>::write(to, value.cols());
    to.add(value.data(), static_cast<std::size_t>(value.size()) * sizeof(Scalar));
  }
  static void read(Reader& from, Value& value) {
    std::int64_t rows = 0;
    std::int64_t cols = 0;
    Codec<std::int64_t>::read(from, rows);
    Codec<std::int64_t>::read(from, cols);
    require_size(rows, Value::RowsAtCompileTime);
    require_size(cols, Value::ColsAtCompileTime);
    const auto size = static_cast<std::uint64_t>(rows * cols);  // below 2 to the 62
    if (size > from.left() / sizeof(Scalar)) throw Malformed();
    value.resize(rows, cols);
    from.take(value.data(), static_cast<std::size_t>(size) * sizeof(Scalar));
  }

 private:
  static void require_size(std::int64_t size, int at_compile_time) {
    constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
    if (size < 0 || size > most) throw Malformed();
    if (at_compile_time != Eigen::Dynamic && size != at_compile_time) throw Malformed();
  }
};

template <typename Scalar>
struct Codec<Eigen::Quaternion<Scalar>> {
  using Coefficients = Eigen::Matrix<Scalar, 4, 1>;
  static void write(Writer& to, const Eigen::Quaternion<Scalar>& value) {
    Codec<Coefficients>::write(to, value.coeffs());
  }
  static void read(Reader& from, Eigen::Quaternion<Scalar>& value) {
    Codec<Coefficients>::read(from, value.coeffs());
  }
};

}  // namespace grading
