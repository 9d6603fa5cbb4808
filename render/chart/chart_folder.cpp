#include "render/chart/chart_folder.hpp"

#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <stdexcept>

#include "render/chart/gnuplot.hpp"
#include "render/files/atomic_file.hpp"
#include "render/files/staged_folder.hpp"

namespace render {
namespace fs = std::filesystem;
namespace {

constexpr const char* index_name = "charts.txt";

/// One chart as it goes to its files.
struct Written {
  std::string name;
  std::string title;
  std::string csv;
  std::string script;
};

void require_names(const std::vector<Written>& all) {
  std::set<std::string> names;
  for (const Written& chart : all) {
    if (chart.name.empty() || chart.name.find_first_not_of(
                                  "abcdefghijklmnopqrstuvwxyz0123456789_") != std::string::npos) {
      throw std::invalid_argument(
          "a chart's name may have only letters a to z, digits and _, not '" + chart.name + "'");
    }
    if (!names.insert(chart.name).second) {
      throw std::invalid_argument("two charts have the name " + chart.name);
    }
  }
}

std::vector<Written> written(const ChartSet& set) {
  std::vector<Written> all;
  for (const Chart& chart : set.charts) {
    all.push_back({chart.name, chart.title, chart_csv(chart), chart_script(chart)});
  }
  for (const HistoryChart& chart : set.histories) {
    all.push_back({chart.name, chart.title, history_csv(chart), history_script(chart)});
  }
  require_names(all);
  return all;
}

void add_files(std::set<std::string>& files, const std::string& name) {
  for (const char* ending : {".csv", ".gp", ".svg", ".png", ".pdf"}) files.insert(name + ending);
}

/// What the folder may hold: these charts and those that its own index names.
std::set<std::string> own_files(const std::vector<Written>& all, const fs::path& folder) {
  std::set<std::string> files{index_name};
  add_files(files, "chart");
  for (const Written& chart : all) add_files(files, chart.name);
  std::ifstream index(folder / index_name);
  for (std::string line; std::getline(index, line);)
    add_files(files, line.substr(0, line.find('\t')));
  return files;
}

/// One line of the index each, so no title may hold a line break.
std::string index_of(const std::vector<Written>& all) {
  std::string index;
  for (const Written& chart : all) {
    std::string title = chart.title;
    for (char& c : title) c = c == '\n' || c == '\t' ? ' ' : c;
    index += chart.name + "\t" + title + "\n";
  }
  return index;
}

std::string content(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// gnuplot frames the words that count in empty lines, the script's line and a pointer to it.
std::string one_line(const std::string& text) {
  std::string line;
  for (const char c : text) line += c == '\n' || c == '\t' ? ' ' : c;
  const std::size_t last = line.find_last_not_of(' ');
  return line.substr(0, last == std::string::npos ? 0 : last + 1);
}

/// gnuplot leaves an empty picture behind where a script is wrong.
bool is_drawn(const fs::path& picture) {
  std::error_code error;
  return fs::file_size(picture, error) > 0 && !error;
}

struct Drawn {
  bool has_gnuplot = true;
  std::string trouble;  ///< the first script that gnuplot could not draw, and why
};

/// What cannot be drawn leaves no picture behind.
void draw(const std::string& name, const StagedFolder& staged, const fs::path& folder,
          Drawn& drawn) {
  const std::string log = "gnuplot.log";
  const std::optional<int> code = run_gnuplot(name + ".gp", log, staged.staged());
  const std::string said = content(staged.file(log));
  fs::remove(staged.file(log));
  if (!code) {
    drawn.has_gnuplot = false;
    return;
  }
  bool all_drawn = *code == 0;
  for (const char* const ending : {".svg", ".png", ".pdf"}) {
    const fs::path picture = staged.file(name + ending);
    if (is_drawn(picture)) continue;
    all_drawn = false;
    fs::remove(picture);
  }
  if (!all_drawn && drawn.trouble.empty()) {
    drawn.trouble =
        "gnuplot could not draw " + (folder / (name + ".gp")).string() + ": " + one_line(said);
  }
}

}  // namespace

bool write_charts(const ChartSet& set, const fs::path& folder) {
  const std::vector<Written> all = written(set);
  const std::set<std::string> own = own_files(all, folder);
  StagedFolder staged(folder, [&](const std::string& name) { return own.count(name) == 1; });
  Drawn drawn;
  for (const Written& chart : all) {
    write_file_atomically(staged.file(chart.name + ".csv"), chart.csv);
    write_file_atomically(staged.file(chart.name + ".gp"), chart.script);
    if (drawn.has_gnuplot) draw(chart.name, staged, folder, drawn);
  }
  write_file_atomically(staged.file(index_name), index_of(all));
  staged.publish();  // first: what was measured is kept whatever becomes of the drawing
  if (!drawn.trouble.empty()) throw std::runtime_error(drawn.trouble);
  return drawn.has_gnuplot;
}

}  // namespace render
