// Cases that end in every way there is; see run_each_test.py.
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <vector>

#include "catch.hpp"

TEST_CASE("It passes") { CHECK(true); }
TEST_CASE("It fails") { CHECK(false); }
TEST_CASE("It crashes") { raise(SIGSEGV); }
TEST_CASE("It leaves") { std::exit(0); }
TEST_CASE("It prints") {
  std::puts("these words");
  CHECK(false);
}
TEST_CASE("It prints without end") {
  while (std::puts("words without end") >= 0) {
  }
}
TEST_CASE("It takes all memory") {
  std::vector<std::unique_ptr<double[]>> all;  // NOLINT: a vector would also fill it
  for (;;) all.push_back(std::make_unique_for_overwrite<double[]>(std::size_t{1} << 26U));
}
TEST_CASE("It sleeps") { pause(); }
TEST_CASE("It loops") {
  for (std::atomic<unsigned> work{0};; ++work) {
  }
}
