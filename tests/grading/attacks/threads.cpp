#include <thread>
#include <vector>

static void attack() {
  std::vector<std::thread> threads;
  for (int i = 0; i < 1000; ++i)
    threads.emplace_back([] {
      for (;;) std::this_thread::yield();
    });
}
