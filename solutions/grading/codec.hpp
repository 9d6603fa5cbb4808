#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "common/types.hpp"

/// Values as bytes, between two processes of one machine. Whoever reads trusts nothing: every size
/// is held against the bytes that are there, flags are 0 or 1, nothing is converted. NaN is a
/// value.
namespace grading {

/// The bytes are no value of the type that is read.
class Malformed : public std::runtime_error {
 public:
  Malformed() : std::runtime_error("the answer is malformed") {}
};

class Writer {
 public:
  void add(const void* value, std::size_t size) {
    bytes_.append(static_cast<const char*>(value), size);
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}

  void take(void* value, std::size_t size) {
    if (size > rest_.size()) throw Malformed();
    if (size > 0) std::memcpy(value, rest_.data(), size);
    rest_.remove_prefix(size);
  }
  [[nodiscard]] std::size_t left() const { return rest_.size(); }
  void require_end() const {
    if (!rest_.empty()) throw Malformed();
  }

 private:
  std::string_view rest_;
};

/// The number of members of a plain struct that crosses; a wrong number does not compile.
template <typename Struct>
inline constexpr int fields_of = 0;

/// The number of enumerators, 0, 1, ..., of an enumeration that crosses.
template <typename Enumeration>
inline constexpr int enumerators_of = 0;

/// References to the members, in order.
template <typename Struct>
auto fields(Struct& s) {
  constexpr int count = fields_of<std::remove_const_t<Struct>>;
  static_assert(count >= 1 && count <= 6, "say fields_of<Struct> in the lab's remote.hpp");
  if constexpr (count == 1) {
    auto& [a] = s;
    return std::tie(a);
  } else if constexpr (count == 2) {
    auto& [a, b] = s;
    return std::tie(a, b);
  } else if constexpr (count == 3) {
    auto& [a, b, c] = s;
    return std::tie(a, b, c);
  } else if constexpr (count == 4) {
    auto& [a, b, c, d] = s;
    return std::tie(a, b, c, d);
  } else if constexpr (count == 5) {
    auto& [a, b, c, d, e] = s;
    return std::tie(a, b, c, d, e);
  } else {
    auto& [a, b, c, d, e, f] = s;
    return std::tie(a, b, c, d, e, f);
  }
}

/// A plain struct, by its fields.
template <typename Value>
struct Codec {
  static void write(Writer& to, const Value& value) {
    std::apply(
        [&](const auto&... field) {
          (Codec<std::remove_cvref_t<decltype(field)>>::write(to, field), ...);
        },
        fields(value));
  }
  static void read(Reader& from, Value& value) {
    std::apply(
        [&](auto&... field) {
          (Codec<std::remove_cvref_t<decltype(field)>>::read(from, field), ...);
        },
        fields(value));
  }
};

template <typename Value>
requires(std::is_arithmetic_v<Value> && !std::same_as<Value, bool>) struct Codec<Value> {
  static void write(Writer& to, const Value& value) { to.add(&value, sizeof value); }
  static void read(Reader& from, Value& value) { from.take(&value, sizeof value); }
};

/// A byte that is 0 or 1.
template <>
struct Codec<bool> {
  static void write(Writer& to, bool value) {
    const std::uint8_t byte = value ? 1 : 0;
    to.add(&byte, 1);
  }
  static void read(Reader& from, bool& value) {
    std::uint8_t byte = 0;
    from.take(&byte, 1);
    if (byte > 1) throw Malformed();
    value = byte == 1;
  }
};

template <typename Value>
requires std::is_enum_v<Value>
struct Codec<Value> {
  static_assert(enumerators_of<Value> > 0, "say enumerators_of<Enumeration> in remote.hpp");
  static void write(Writer& to, const Value& value) {
    Codec<std::int64_t>::write(to, static_cast<std::int64_t>(value));
  }
  static void read(Reader& from, Value& value) {
    std::int64_t number = 0;
    Codec<std::int64_t>::read(from, number);
    if (number < 0 || number >= enumerators_of<Value>) throw Malformed();
    value = static_cast<Value>(number);
  }
};

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

/// How many elements follow. Each takes a byte at least, so no number asks for more memory than
/// some multiple of what has arrived.
inline std::size_t read_count(Reader& from) {
  std::uint64_t count = 0;
  Codec<std::uint64_t>::read(from, count);
  if (count > from.left()) throw Malformed();
  return static_cast<std::size_t>(count);
}

template <>
struct Codec<std::string> {
  static void write(Writer& to, const std::string& value) {
    Codec<std::uint64_t>::write(to, value.size());
    to.add(value.data(), value.size());
  }
  static void read(Reader& from, std::string& value) {
    value.resize(read_count(from));
    from.take(value.data(), value.size());
  }
};

template <typename Element>
struct Codec<std::vector<Element>> {
  static void write(Writer& to, const std::vector<Element>& value) {
    Codec<std::uint64_t>::write(to, value.size());
    for (const Element& element : value) Codec<Element>::write(to, element);
  }
  static void read(Reader& from, std::vector<Element>& value) {
    value.resize(read_count(from));
    for (Element& element : value) Codec<Element>::read(from, element);
  }
};

template <typename Element, std::size_t count>
struct Codec<std::array<Element, count>> {
  static void write(Writer& to, const std::array<Element, count>& value) {
    for (const Element& element : value) Codec<Element>::write(to, element);
  }
  static void read(Reader& from, std::array<Element, count>& value) {
    for (Element& element : value) Codec<Element>::read(from, element);
  }
};

template <typename Value>
struct Codec<std::optional<Value>> {
  static void write(Writer& to, const std::optional<Value>& value) {
    Codec<bool>::write(to, value.has_value());
    if (value) Codec<Value>::write(to, *value);
  }
  static void read(Reader& from, std::optional<Value>& value) {
    bool has_value = false;
    Codec<bool>::read(from, has_value);
    value.reset();
    if (has_value) Codec<Value>::read(from, value.emplace());
  }
};

template <typename... Values>
struct Codec<std::variant<Values...>> {
  using Variant = std::variant<Values...>;
  static void write(Writer& to, const Variant& value) {
    Codec<std::uint8_t>::write(to, static_cast<std::uint8_t>(value.index()));
    std::visit(
        [&]<typename Value>(const Value& alternative) { Codec<Value>::write(to, alternative); },
        value);
  }
  static void read(Reader& from, Variant& value) {
    std::uint8_t index = 0;
    Codec<std::uint8_t>::read(from, index);
    if (index >= sizeof...(Values)) throw Malformed();
    read_alternative(from, value, index, std::index_sequence_for<Values...>());
  }

 private:
  template <std::size_t... indices>
  static void read_alternative(Reader& from, Variant& value, std::uint8_t index,
                               std::index_sequence<indices...>) {
    ((index == indices ? Codec<Values>::read(from, value.template emplace<indices>()) : void()),
     ...);
  }
};

template <typename... Values>
struct Codec<std::tuple<Values...>> {
  static void write(Writer& to, const std::tuple<Values...>& value) {
    std::apply([&](const Values&... each) { (Codec<Values>::write(to, each), ...); }, value);
  }
  static void read(Reader& from, std::tuple<Values...>& value) {
    std::apply([&](Values&... each) { (Codec<Values>::read(from, each), ...); }, value);
  }
};

/// The value that all of the bytes are; throws Malformed where they are not.
template <typename Value>
Value decoded(Reader& from) {
  Value value{};
  Codec<Value>::read(from, value);
  from.require_end();
  return value;
}

}  // namespace grading
