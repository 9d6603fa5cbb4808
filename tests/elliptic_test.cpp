#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/ellint_rc.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>
#include <cmath>
#include <limits>

#include "catch.hpp"
#include "common/elliptic/carlson.hpp"
#include "common/elliptic/elliptic_integrals.hpp"
#include "common/elliptic/jacobi_elliptic.hpp"
#include "common/exact/exact_sum.hpp"
#include "random.hpp"
#include "values.hpp"

using namespace common;
using tests::eps;

namespace {

double relative_error(double found, double wanted) { return std::abs(found / wanted - 1.0); }

double wide(tests::Random& random) { return std::pow(10.0, random.uniform(-12.0, 4.0)); }

constexpr std::array parameters{1.0, 0.9, 0.3, 1e-2, 1e-6, 1e-12, 1e-20, 1e-100};

}  // namespace

TEST_CASE("The symmetric integrals agree with those of Boost", "[elliptic]") {
  tests::Random random(41);
  for (int i = 0; i < 1000; ++i) {
    const double x = i % 5 == 0 ? 0.0 : wide(random);
    const double y = wide(random);
    const double z = wide(random);
    const double p = i % 7 == 0 ? y * (1.0 + 1e-5) : wide(random);
    // Some ten duplications of a few roundings each.
    CHECK(relative_error(carlson_rc(x, y), boost::math::ellint_rc(x, y)) < 32.0 * eps);
    CHECK(relative_error(carlson_rf(x, y, z), boost::math::ellint_rf(x, y, z)) < 32.0 * eps);
    CHECK(relative_error(carlson_rj(x, y, z, p), boost::math::ellint_rj(x, y, z, p)) < 64.0 * eps);
  }
  CHECK(relative_error(carlson_rj(2.0, 3.0, 4.0, 5.0), 0.14297579667156753833) < 8.0 * eps);
}

TEST_CASE("The integral of the first kind undoes the elliptic functions", "[elliptic]") {
  for (const double k : parameters) {
    const double quarter = quarter_period(k);
    for (const double part : {1e-12, 1e-3, 0.1, 0.5, 0.9, 0.999, -0.3, -1.0}) {
      const JacobiFunctions at = jacobi_functions(part * quarter, k);
      // dF/du = 1, so the error of u is that of the functions: an ulp of each of K's own digits.
      CHECK(std::abs(first_kind(at, k) - part * quarter) < 16.0 * eps * quarter);
      CHECK(std::abs(std::hypot(at.sn, at.cn) - 1.0) < 4.0 * eps);
      CHECK(relative_error(at.dn, std::sqrt(at.cn * at.cn + k * at.sn * at.sn)) < 64.0 * eps);
    }
  }
  CHECK(relative_error(quarter_period(0.5), 1.8540746773013719184) < 4.0 * eps);  // DLMF 19.6
}

TEST_CASE("The addition theorem adds the arguments", "[elliptic]") {
  for (const double k : {0.0, 1e-12, 1e-3, 0.5, 1.0}) {
    for (const double u : {-1.2, 0.0, 0.3, 1.5}) {
      for (const double v : {-0.9, 0.05, 1.4}) {
        const auto [within, half_turns] = reduced_argument(u + v, k);
        const double sign = half_turns == 0.0 ? 1.0 : -1.0;
        const JacobiFunctions wanted = jacobi_functions(within, k);
        const JacobiFunctions found =
            jacobi_functions_of_sum(jacobi_functions(u, k), jacobi_functions(v, k), k);
        CHECK(std::abs(found.sn - sign * wanted.sn) < 32.0 * eps);
        CHECK(std::abs(found.cn - sign * wanted.cn) < 32.0 * eps);
        CHECK(std::abs(found.dn - wanted.dn) < 32.0 * eps);
      }
    }
  }
}

TEST_CASE("The integrals of the third kind agree with quadrature", "[elliptic]") {
  using Quadrature = boost::math::quadrature::gauss_kronrod<double, 61>;
  for (const double k : {0.0, 1e-4, 0.2, 1.0}) {
    for (const double r : {1e-2, 0.5, 1.0, 1.0 + 1e-9, 3.0, 200.0}) {
      for (const double amplitude : {0.2, -0.9, 1.4}) {
        const auto integral = [&](double cosine_power) {
          const auto integrand = [&](double angle) {
            const double c = std::cos(angle) * std::cos(angle);
            const double s = std::sin(angle) * std::sin(angle);
            return std::pow(c, cosine_power) / ((c + r * s) * std::sqrt(c + k * s));
          };
          return Quadrature::integrate(integrand, 0.0, amplitude, 15, 1e-13);
        };
        const double c = std::cos(amplitude);
        const double s = std::sin(amplitude);
        const JacobiFunctions at{s, c, std::sqrt(c * c + k * s * s)};
        CHECK(relative_error(third_kind(at, r, k), integral(0.0)) < 1e-12);
        if (r >= 1.0) CHECK(relative_error(cosine_share(at, r, k), integral(1.0)) < 1e-12);
      }
    }
  }
}

TEST_CASE("An exact sum keeps what every double sum loses", "[elliptic]") {
  const double x = 1.0 + eps;
  ExactSum sum;
  sum.add_product(x, x);
  sum.add(-1.0);
  sum.add(-2.0 * eps);
  CHECK(sum.value() == eps * eps);  // (1 + e)^2 = 1 + 2 e + e^2
  sum.add(1e200);
  sum.add(1.0);
  sum.add(-1e200);
  sum.add(-1.0);
  CHECK(sum.value() == eps * eps);
  ExactSum product;
  product.add_product(sum, sum);
  CHECK(product.value() == eps * eps * eps * eps);
  product.add(-product.value());
  CHECK(product.value() == 0.0);
}
