// Cases that end in every way there is; see run_each_test.py.
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <vector>

#include "catch.hpp"
#include "trial.hpp"

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
TEST_CASE("It tells its process") {
  std::printf("process %d\n", getpid());
  CHECK(true);
}
TEST_CASE("It tells its process again") {
  std::printf("process %d\n", getpid());
  CHECK(true);
}
TEST_CASE("It passes after all") { CHECK(true); }

namespace {
int calls = 0;
}

TEST_CASE("It passes once in a process") { CHECK(++calls == 1); }
TEST_CASE("It passes once in a process too") { CHECK(++calls == 1); }
TEST_CASE("It takes all memory") {
  std::vector<std::unique_ptr<double[]>> all;  // NOLINT: a vector would also fill it
  for (;;) all.push_back(std::make_unique_for_overwrite<double[]>(std::size_t{1} << 26U));
}
TEST_CASE("It sleeps") { pause(); }

namespace {

[[noreturn]] int loop() {
  for (std::atomic<unsigned> work{0};; ++work) {
  }
}

}  // namespace

TEST_CASE("It loops") { loop(); }
TEST_CASE("It loops twice") { loop(); }
TEST_CASE("It loops thrice") { loop(); }
TEST_CASE("It loops still") { loop(); }

namespace lab::victims {

int answer(int depth);  // as a contract declares it

int answer(int depth) { return depth < 0 ? 0 : raise(SIGSEGV) + answer(-1); }

}  // namespace lab::victims

TEST_CASE("Asked by no trial it crashes") { CHECK(lab::victims::answer(1) == 1); }

namespace {

int overflow(int depth) { return depth < 0 ? 0 : 1 + overflow(depth + 1) * depth; }

template <typename Answer>
void ask(const Answer& answer) {
  tests::Trial("1.1 before").given("depth", 2.0).expect(1.0, 1.0, {0.0, "exact"});
  const tests::Trial asked = tests::Trial("1.1 answer", 2, 5).given("depth", 0.1);
  asked.of("a part").expect(static_cast<double>(answer()), 1.0, {0.0, "exact"});
}

}  // namespace

TEST_CASE("Asked it crashes") {
  ask([] { return raise(SIGSEGV); });
}
TEST_CASE("Asked it aborts") {
  ask([]() -> int { std::abort(); });
}
TEST_CASE("Asked it overflows the stack") {
  ask([] { return overflow(0); });
}
TEST_CASE("Asked it leaves") {
  ask([]() -> int { std::exit(0); });
}
TEST_CASE("Asked it loops") { ask(loop); }
TEST_CASE("Asked it sleeps") { ask(pause); }
