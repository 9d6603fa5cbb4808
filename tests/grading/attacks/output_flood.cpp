#include <cstdio>

static void attack() {
  for (int i = 0; i < 2000000; ++i) std::puts("All tests passed (1 assertion in 1 test case)");
}
