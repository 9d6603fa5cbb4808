// What crosses between a judge and a student's process: matrices of any size, and what only looks
// like one.
#include "codec.hpp"

#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "catch.hpp"
#include "common/algebra/dense.hpp"

using common::Matrix;
using common::Vector;
using grading::Codec;
using grading::Malformed;

namespace {

template <typename Value>
std::string bytes_of(const Value& value) {
  grading::Writer to;
  Codec<Value>::write(to, value);
  return to.bytes();
}

template <typename Value>
Value value_of(const std::string& bytes) {
  grading::Reader from(bytes);
  return grading::decoded<Value>(from);
}

/// A matrix's head, and some numbers behind it.
std::string sized(std::int64_t rows, std::int64_t cols, std::size_t numbers) {
  return bytes_of(rows) + bytes_of(cols) + std::string(8 * numbers, '\0');
}

}  // namespace

TEST_CASE("Matrices and vectors of any size arrive as they were sent", "[codec]") {
  for (const auto& [rows, cols] :
       std::vector<std::pair<int, int>>{{0, 0}, {1, 1}, {2, 3}, {7, 7}}) {
    Matrix sent(rows, cols);
    for (int i = 0; i < sent.size(); ++i) sent.data()[i] = 1.0 / (i + 1);
    const auto got = value_of<Matrix>(bytes_of(sent));
    REQUIRE(got.rows() == rows);
    REQUIRE(got.cols() == cols);
    CHECK(got == sent);
  }
  const auto none = value_of<Vector>(bytes_of(Vector(0)));
  CHECK(none.size() == 0);
  const Vector sent = Vector::LinSpaced(5, -1.0, 1.0);
  CHECK(value_of<Vector>(bytes_of(sent)) == sent);
  const std::vector<Vector> list{sent, Vector(0), sent};
  CHECK(value_of<std::vector<Vector>>(bytes_of(list)) == list);
}

TEST_CASE("NaN and infinity are values", "[codec]") {
  Vector sent = Vector::Constant(3, std::numeric_limits<double>::quiet_NaN());
  sent[1] = std::numeric_limits<double>::infinity();
  CHECK(bytes_of(value_of<Vector>(bytes_of(sent))) == bytes_of(sent));
}

TEST_CASE("A size that the bytes do not bear is malformed and asks for no memory", "[codec]") {
  constexpr std::int64_t large = std::numeric_limits<std::int64_t>::max();
  constexpr std::int64_t root = std::int64_t{1} << 31;
  const std::vector<std::pair<std::int64_t, std::int64_t>> sizes{
      {2, 2},        {1, 4},
      {3, 2},        {-1, -3},
      {-3, 1},       {large, 1},
      {large, 2},    {large, large},
      {2, large},    {large / 2 + 1, 2},
      {root, root},  {root * 2, root},
      {root - 1, 1}, {0, large},
      {large, 0},    {root - 1, root - 1}};
  for (const auto& [rows, cols] : sizes) {
    CAPTURE(rows, cols);
    CHECK_THROWS_AS(value_of<Matrix>(sized(rows, cols, 3)), Malformed);
  }
  CHECK(value_of<Matrix>(sized(3, 1, 3)).isZero(0.0));
  CHECK_THROWS_AS(value_of<Matrix>(sized(1, 2, 3)), Malformed);  // something is left over
}

TEST_CASE("A vector has one column and a cut head is malformed", "[codec]") {
  CHECK(value_of<Vector>(sized(3, 1, 3)).size() == 3);
  CHECK_THROWS_AS(value_of<Vector>(sized(1, 3, 3)), Malformed);
  CHECK_THROWS_AS(value_of<Vector>(sized(0, 0, 0)), Malformed);
  const std::string whole = bytes_of(Vector(Vector::Ones(2)));
  for (std::size_t length = 0; length < whole.size(); ++length) {
    CHECK_THROWS_AS(value_of<Vector>(whole.substr(0, length)), Malformed);
  }
}

TEST_CASE("Matrices of fixed size have no head", "[codec]") {
  const common::Vec3 sent(1.0, 2.0, 3.0);
  CHECK(bytes_of(sent).size() == 24);
  CHECK(value_of<common::Vec3>(bytes_of(sent)) == sent);
}
