// The tests' own tools: what they draw is what it is said to be, and what they print can be pasted.
#include <Eigen/Eigenvalues>

#include "catch.hpp"
#include "fingerprint.hpp"
#include "random.hpp"
#include "trial.hpp"
#include "values.hpp"

using tests::eps;
using tests::Random;

TEST_CASE("Random inertias are those of bodies", "[support]") {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const common::Mat3 inertia = random.inertia();
    const common::Vec3 found = Eigen::SelfAdjointEigenSolver<common::Mat3>(inertia).eigenvalues();
    CHECK(inertia == inertia.transpose());
    CHECK(found.x() > 0.0);
    CHECK(found.x() + found.y() > found.z());
    CHECK(found.z() - found.y() > 0.1);
    CHECK(found.y() - found.x() > 0.1);
  }
}

TEST_CASE("Random directions and attitudes are unit and reach every side", "[support]") {
  Random random(2);
  common::Vec3 mean = common::Vec3::Zero();
  Eigen::Vector4d mean_of_attitudes = Eigen::Vector4d::Zero();
  const int count = 10000;
  for (int i = 0; i < count; ++i) {
    const common::Vec3 direction = random.direction();
    const common::Quat q = random.attitude();
    CHECK(std::abs(direction.norm() - 1.0) <= 4.0 * eps);
    CHECK(std::abs(q.norm() - 1.0) <= 4.0 * eps);
    mean += direction / count;
    mean_of_attitudes += q.coeffs() / count;
  }
  // Each component of the mean has the standard deviation 1/sqrt(3 n) or less: six of them.
  CHECK(mean.cwiseAbs().maxCoeff() < 6.0 / std::sqrt(3.0 * count));
  CHECK(mean_of_attitudes.cwiseAbs().maxCoeff() < 6.0 / std::sqrt(3.0 * count));
}

TEST_CASE("The same seed draws the same numbers and another draws others", "[support]") {
  CHECK(Random(3).vector() == Random(3).vector());
  CHECK(Random(3).vector() != Random(4).vector());
}

TEST_CASE("Printed numbers read back as the same double", "[support]") {
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    const double value = std::ldexp(random.uniform(-1.0, 1.0), i - 500);
    CHECK(std::strtod(tests::text(value).c_str(), nullptr) == value);
  }
  CHECK(tests::text(0.1) == "0.1");
  CHECK(tests::text(common::Vec3(1.0, -2.0, 0.5)) == "Vec3(1, -2, 0.5)");
  CHECK(tests::text(common::Quat(1.0, 2.0, 3.0, 4.0)) == "Quat(1, 2, 3, 4)");
  CHECK(tests::text(Eigen::Vector2d(1.0, -0.5)) == "Vec2(1, -0.5)");
  CHECK(tests::text(Eigen::VectorXd{{1.0, -0.5, 2.0, 4.0}}) == "Vector{{1, -0.5, 2, 4}}");
  CHECK(tests::text(common::Matrix{{2.0, -1.0}, {-1.0, 2.0}}) == "Matrix{{2, -1}, {-1, 2}}");
  CHECK(tests::text(Eigen::VectorXd()) == "Vector(0)");
  CHECK(tests::text(common::Matrix(0, 2)) == "Matrix(0, 2)");
}

TEST_CASE("Vectors of different sizes are infinitely far apart", "[support]") {
  const Eigen::VectorXd v{{3.0, 4.0}};
  CHECK(tests::length(v) == 5.0);
  CHECK(tests::length(Eigen::VectorXd()) == 0.0);
  CHECK(tests::difference(v, Eigen::VectorXd{{3.0, 3.0}}) == 1.0);
  CHECK(std::isinf(tests::difference(v, Eigen::VectorXd{{3.0, 4.0, 0.0}})));
  CHECK(std::isinf(tests::difference(common::Matrix(2, 0), common::Matrix(0, 2))));
}

TEST_CASE("Both signs of a quaternion are one attitude and lengths neither over nor underflow",
          "[support]") {
  const common::Quat q(0.5, -0.5, 0.5, 0.5);
  CHECK(tests::difference(q, common::Quat(-q.coeffs())) == 0.0);
  CHECK(std::abs(tests::length(common::Vec3(3e-200, 4e-200, 0.0)) / 5e-200 - 1.0) <= 8.0 * eps);
  CHECK(std::abs(tests::length(common::Mat3(common::Mat3::Constant(1e200))) / 3e200 - 1.0) <=
        16.0 * eps);
}

TEST_CASE("A fingerprint names the one mistake that fits on all inputs", "[support]") {
  // Twice and the square are the same of 2, and all are of 0.
  const std::vector<tests::Mistake<double, double>> mistakes{
      tests::returns<double, double>("twice", [](double x) { return 2.0 * x; }),
      tests::returns<double, double>("the square", [](double x) { return x * x; }),
      {"0/0", [](double x, double got) { return x == 0.0 ? std::isnan(got) : got == 1.0; }}};
  const auto told = [&](const std::vector<double>& inputs, double (*answer)(double)) {
    return tests::fingerprint(inputs, answer, mistakes);
  };
  CHECK(told({0.0, 2.0, 3.0}, [](double x) { return x + x; }) == "twice");
  CHECK(told({0.0, 2.0, 3.0}, [](double x) { return x * x; }) == "the square");
  CHECK(told({0.0, 2.0, 3.0}, [](double x) { return x / x; }) == "0/0");
  CHECK(told({0.0, 2.0}, [](double x) { return x + x; }).empty());
  CHECK(told({0.0, 2.0, 3.0}, [](double x) { return 3.0 * x; }).empty());
  CHECK(told({2.0, 3.0}, [](double) -> double { throw std::domain_error("no number"); }).empty());
}

TEST_CASE("A trial looks for a likely mistake only where it fails", "[support]") {
  int asked = 0;
  tests::Trial trial("0.0 nothing");
  trial.suspecting([&] {
    ++asked;
    return std::string("it is one less");
  });
  trial.expect(2.0, 2.0, {0.0, "the same"});
  trial.expect_small("error", 0.0, {0.0, "the same"});
  CHECK(asked == 0);
}
