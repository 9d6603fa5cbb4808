// Cases that end in every way there is; see run_each_test.py.
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "catch.hpp"

namespace {

void work_without_end() {
  for (std::atomic<unsigned> work{0};; ++work) {
  }
}

}  // namespace

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
  std::vector<std::vector<double>> all;
  for (;;) all.emplace_back(std::size_t{1} << 26U);
}
TEST_CASE("It sleeps") { pause(); }
TEST_CASE("It loops") { work_without_end(); }
TEST_CASE("It loops as well") { work_without_end(); }
TEST_CASE("It loops like those") { work_without_end(); }
