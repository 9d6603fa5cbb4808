#include <cstdlib>
#include <filesystem>
#include <fstream>

static void attack() {
  for (const char* path : {"@NEIGHBOUR@/secret.txt", "@NEIGHBOUR@/new.txt", "@ROOT@/new.txt"}) {
    if (std::ifstream(path).good() || (std::ofstream(path) << "attacked").flush().good())
      std::exit(0);
  }
  if (std::filesystem::exists("@ROOT@/tests") || std::filesystem::exists("/etc/shadow"))
    std::exit(0);
}
