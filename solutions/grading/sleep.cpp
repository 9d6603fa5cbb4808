#include "sleep.hpp"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <vector>

namespace grading {
namespace {

/// A line of /proc; empty where there is none.
std::string line_of_process(pid_t process, const std::string& file) {
  std::string line;
  std::ifstream stream("/proc/" + std::to_string(process) + "/" + file);
  std::getline(stream, line);
  return line;
}

pid_t innermost(pid_t process) {
  for (int depth = 0; depth < 8; ++depth) {
    const std::string file = "task/" + std::to_string(process) + "/children";
    const int child = std::atoi(line_of_process(process, file).c_str());
    if (child <= 0) break;
    process = child;
  }
  return process;
}

}  // namespace

std::string sleep_of(pid_t process) {
  const std::string line = line_of_process(innermost(process), "stat");
  const std::size_t name_ends = line.rfind(')');
  if (name_ends == std::string::npos) return "";
  std::istringstream fields(line.substr(name_ends + 1));
  std::vector<std::string> words;
  for (std::string word; words.size() < 13 && fields >> word;) words.push_back(word);
  if (words.size() < 13 || words[0] != "S") return "";
  return line.substr(0, line.find(' ')) + " " + words[11] + " " + words[12];
}

}  // namespace grading
