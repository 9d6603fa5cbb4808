#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "codec_matrices.hpp"
#include "codec_scalars.hpp"

/// All that crosses as bytes; here what holds other values.
namespace grading {

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
