#include "common/exact/exact_roots.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "catch.hpp"
#include "random.hpp"

using common::ExactPolynomial;
using common::ExactRoots;

namespace {

const ExactPolynomial one{1.0};

/// (t − a)(t − b)...
ExactPolynomial with_roots(const std::vector<double>& roots) {
  ExactPolynomial polynomial = one;
  for (const double root : roots) polynomial = polynomial * ExactPolynomial{-root, 1.0};
  return polynomial;
}

}  // namespace

TEST_CASE("Roots are counted past the first end and up to the other") {
  const ExactRoots roots(with_roots({0.25, 0.5, 0.75}), one);
  CHECK(roots.count(0.0, 1.0) == 3);
  CHECK(roots.count(0.25, 0.5) == 1);
  CHECK(roots.count(0.25, 0.75) == 2);
  CHECK(roots.count(0.75, 1.0) == 0);
}

TEST_CASE("A multiple root counts once also at an end") {
  const ExactRoots roots(with_roots({0.5, 0.5, 0.1}), one);
  CHECK(roots.count(0.2, 0.5) == 1);
  CHECK(roots.count(0.5, 1.0) == 0);
  CHECK(roots.count(0.0, 1.0) == 2);
}

TEST_CASE("A double root is told from none and from two closer than doubles are") {
  const ExactPolynomial square = with_roots({0.3, 0.3});
  const ExactPolynomial tiny{1e-300};
  CHECK(ExactRoots(square, one).count(0.0, 1.0) == 1);
  CHECK(ExactRoots(square - tiny, one).count(0.0, 1.0) == 2);
  CHECK(ExactRoots(square + tiny, one).count(0.0, 1.0) == 0);
}

TEST_CASE("Only roots at which the other polynomial is above zero count") {
  const ExactPolynomial f = with_roots({0.125, 0.25, 0.5, 0.75});
  CHECK(ExactRoots(f, with_roots({0.3})).count(0.0, 1.0) == 2);       // t > 0.3
  CHECK(ExactRoots(f, with_roots({0.2, 0.6})).count(0.0, 1.0) == 2);  // outside of these
  CHECK(ExactRoots(f, with_roots({0.25})).count(0.0, 1.0) == 2);      // not where it is zero
  CHECK(ExactRoots(f, ExactPolynomial{-1.0}).count(0.0, 1.0) == 0);
}

TEST_CASE("What is zero throughout has no roots to count") {
  CHECK(ExactRoots(ExactPolynomial{}, one).count(0.0, 1.0) == 0);
  CHECK(ExactRoots(ExactPolynomial{0.0, 0.0}, one).count(0.0, 1.0) == 0);
  CHECK(ExactRoots(one, one).count(0.0, 1.0) == 0);
}

TEST_CASE("The first root is found from above to the width that is asked for") {
  const ExactRoots roots(with_roots({0.3, 0.3, 0.7}), with_roots({0.1}));
  for (const double width : {0.1, 1e-10, 0.0}) {
    const double found = roots.first(0.0, 1.0, width);
    CHECK(found >= 0.3);
    CHECK(found - 0.3 <= std::max(width, 1e-16));
  }
}

TEST_CASE("Random roots are counted at any scale") {
  tests::Random random(52);
  for (int i = 0; i < 50; ++i) {
    const double scale = std::ldexp(1.0, static_cast<int>(random.uniform(-300.0, 300.0)));
    std::vector<double> roots(4);
    for (double& root : roots) root = scale * random.uniform(0.0, 1.0);
    const double from = scale * random.uniform(0.0, 0.5);
    const double to = scale * random.uniform(0.5, 1.0);
    const auto wanted = std::count_if(roots.begin(), roots.end(),
                                      [&](double root) { return from < root && root <= to; });
    CHECK(ExactRoots(with_roots(roots), one).count(from, to) == wanted);
  }
}
