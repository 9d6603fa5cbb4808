#include "impulses.hpp"

#include <numeric>
#include <utility>

namespace tests {
namespace {

ContactSystem impact_in_a_row(Random& random, int balls) {
  Vector masses(balls);
  Vector v(balls);
  for (int i = 0; i < balls; ++i) {
    masses[i] = random.uniform(1.0, 9.0);
    v[i] = random.uniform(-1.0, 1.0);
  }
  v[0] = v[1] + 1.0;
  return row_of_balls(masses, v).system();
}

/// With eigenvalues of 1/2 to 3/2.
ContactSystem coupled_impact(Random& random, int m) {
  ContactSystem system{Matrix::Identity(m, m), Vector(m)};
  for (int i = 0; i < m; ++i) {
    system.u[i] = random.uniform(-1.0, 0.5);
    for (int j = 0; j < i; ++j) {
      system.A(i, j) = system.A(j, i) = random.uniform(-0.5, 0.5) / (m - 1);
    }
  }
  system.u[0] = -1.0;
  return system;
}

}  // namespace

ContactSystem random_impact(Random& random, int index) {
  const int m = 3 + index % 4;
  return index % 2 == 0 ? impact_in_a_row(random, m + 1) : coupled_impact(random, m);
}

std::vector<int> random_order(Random& random, Eigen::Index contacts) {
  std::vector<int> order(static_cast<std::size_t>(contacts));
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = order.size(); i > 1; --i) {
    const auto other = static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(i)));
    std::swap(order[i - 1], order[other]);
  }
  return order;
}

}  // namespace tests
