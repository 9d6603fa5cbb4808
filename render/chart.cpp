#include "render/chart.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <charconv>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <stdexcept>

#include "render/atomic_file.hpp"
#include "render/staged_folder.hpp"

namespace render {
namespace fs = std::filesystem;
namespace {

const char* text(Status status) {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::unstable:
      return "unstable";
    case Status::not_implemented:
      break;
  }
  return "not_implemented";
}

/// The shortest decimal that reads back as the same double, whatever the locale.
std::string text(double value) {
  std::array<char, 32> digits{};
  auto* const end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return {digits.data(), end};
}

/// As RFC 4180 has it: quoted where a comma or a quote stands in it.
std::string field(const std::string& value) {
  if (value.find_first_of(",\"\n") == std::string::npos) return value;
  std::string quoted = "\"";
  for (const char c : value) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

/// Runs gnuplot in `folder`; nothing where it is not installed, else its exit code.
std::optional<int> run_gnuplot(const fs::path& folder) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, 2, "gnuplot.log", 0x241 /* write, create, truncate */,
                                   0644);
  std::string program = "gnuplot";
  std::string script = "chart.gp";
  std::array<char*, 3> arguments{program.data(), script.data(), nullptr};
  pid_t child = 0;
  const int failed = posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) return std::nullopt;
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string content(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// gnuplot leaves an empty picture behind where a script is wrong.
bool is_drawn(const fs::path& picture) {
  std::error_code error;
  return fs::file_size(picture, error) > 0 && !error;
}

}  // namespace

std::string chart_csv(const Chart& chart) {
  std::string csv = "lab,method,parameter,error,error_unit,seconds,work_unit,evaluations,status\n";
  for (const ChartSeries& series : chart.series) {
    const std::string head = field(chart.lab) + "," + field(series.method) + ",";
    if (!series.missing.empty()) {
      csv += head + ",," + field(chart.error_unit) + ",," + field(chart.work_unit) + ",," +
             text(Status::not_implemented) + "\n";
    }
    for (const ChartPoint& point : series.points) {
      csv += head + text(point.parameter) + "," + text(point.error) + "," +
             field(chart.error_unit) + "," + text(point.seconds) + "," + field(chart.work_unit) +
             "," + text(point.evaluations) + "," + text(point.status) + "\n";
    }
  }
  return csv;
}

bool write_chart(const Chart& chart, const fs::path& folder) {
  const std::set<std::string> own{"chart.csv", "chart.gp", "chart.svg", "chart.png"};
  StagedFolder staged(folder, [&](const std::string& name) { return own.count(name) == 1; });
  write_file_atomically(staged.file("chart.csv"), chart_csv(chart));
  write_file_atomically(staged.file("chart.gp"), chart_script(chart));
  const std::optional<int> code = run_gnuplot(staged.staged());
  const std::string said = content(staged.file("gnuplot.log"));
  fs::remove(staged.file("gnuplot.log"));
  if (code &&
      (*code != 0 || !is_drawn(staged.file("chart.svg")) || !is_drawn(staged.file("chart.png")))) {
    throw std::runtime_error("gnuplot could not draw " + folder.string() + "/chart.gp: " + said);
  }
  staged.publish();
  return code.has_value();
}

}  // namespace render
