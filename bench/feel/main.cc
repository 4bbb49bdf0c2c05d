// Draws recorded strokes again, with a simulated pen, the haptic loop and the pencil, for each
// drawing material and with forces on and off. Without --file it draws share/samples. All options
// of the pencil have their defaults, except those given with --set. People draw with the plane
// alone instead of forces off, because their pen would have no surface (see --baselines).
//   bench_feel [--people N] [--file F]... [--mm-per-unit U] [--limit N] [--device NAME]
//              [--set ID=VALUE]... [--model NAME]
// N simulated people draw (default 20), who see and feel what the pen does
// (felt/devices/simulated/feedback_hand.h). Prints how the forces change the error of each person.
//   bench_feel --hand NAME [--csv F] [the options above]
// A simulated hand that only carries out a plan draws. Prints whether every stroke was drawn, how
// far the ink is from the intended path, which forces the hand felt, and how much faster than real
// time the simulation runs on this machine. Fails if a stroke is missing or is split.
//   bench_feel --snapping [--file F]... [--hand NAME] [--people N]
// Counts joined and closed strokes (snap_bars.h).
//   bench_feel --baselines [--people N] [--device NAME]
// Simulated people of all models draw in the air, on the plane alone, with the default forces and
// with a tablet (baselines.h). Without --device, with all simulated devices that have forces.
//   bench_feel --retracing [--people N] [--device NAME]
// Simulated people draw over lines (retracing.h). Without --device, with all of them.
//   bench_feel --contours [--people N] [--device NAME]
// Simulated people draw over pictures (contours.h). Without --device, with all of them.
//   bench_feel --erasing [--people N] [--device NAME]
// Simulated people erase a part of a line (erasing.h). Without --device, with all of them.
//   bench_feel --table [--people N] [--device NAME]
// Prints a row for each force (force_table.h).
//   bench_feel --pull [--people N] [--device NAME] [--set ID=VALUE]...
// Simulated people pull a line to given points (pull_people.h). Without --device, with all of them.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/cli/text_table.h"
#include "baselines.h"
#include "bench/hand/statistics.h"
#include "contours.h"
#include "erasing.h"
#include "felt/io/ndjson/ndjson_lines.h"
#include "felt/replay/script_run.h"
#include "force_table.h"
#include "pull_people.h"
#include "retracing.h"
#include "snap_bars.h"

namespace felt::bench {
namespace {

constexpr std::array<std::string_view, 7> kComparisons = {
    "--snapping", "--pull", "--baselines", "--retracing", "--contours", "--erasing", "--table"};
constexpr std::array kMaterials = {"pencil", "chalk", "crayon", "felt-tip"};

struct Options {
  std::vector<std::string> files;
  double mm_per_unit = 1.0;
  std::size_t limit = 1'000'000'000;
  std::string device, hand, csv;
  std::vector<std::pair<std::string, std::string>> set;
  std::size_t people = 20;
  PersonModel model = PersonModel::kProportional;
  std::string_view comparison;  // one of kComparisons; empty compares the materials

  [[nodiscard]] bool is(std::string_view name) const noexcept { return comparison == name; }
};

[[noreturn]] void fail_usage() {
  fmt::print(stderr,
             "usage: bench_feel [--people N] [--file F]... [--mm-per-unit U] [--limit N] "
             "[--device NAME] [--set ID=VALUE]... [--model NAME]\n"
             "       bench_feel --hand NAME [--csv F] [the options above]\n"
             "       bench_feel --snapping [--file F]... [--hand NAME] [--people N]\n"
             "       bench_feel --baselines [--people N] [--device NAME]\n"
             "       bench_feel --retracing [--people N] [--device NAME]\n"
             "       bench_feel --contours [--people N] [--device NAME]\n"
             "       bench_feel --erasing [--people N] [--device NAME]\n"
             "       bench_feel --table [--people N] [--device NAME]\n"
             "       bench_feel --pull [--people N] [--device NAME] [--set ID=VALUE]...\n");
  std::exit(2);
}

Options options_of(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; i += 2) {
    const std::string name = argv[i];
    const auto comparison = std::find(kComparisons.begin(), kComparisons.end(), name);
    if (comparison != kComparisons.end()) {
      options.comparison = *comparison;
      --i;
      continue;
    }
    if (i + 1 == argc) fail_usage();
    const std::string value = argv[i + 1];
    if (name == "--file") {
      options.files.push_back(value);
    } else if (name == "--mm-per-unit") {
      options.mm_per_unit = std::strtod(value.c_str(), nullptr);
    } else if (name == "--limit") {
      options.limit = std::strtoull(value.c_str(), nullptr, 10);
    } else if (name == "--people") {
      options.people = std::strtoull(value.c_str(), nullptr, 10);
      if (options.people == 0) fail_usage();
    } else if (name == "--model" && find_person_model(value)) {
      options.model = *find_person_model(value);
    } else if (name == "--set") {
      const std::size_t at = value.find('=');
      if (at == std::string::npos) fail_usage();
      options.set.emplace_back(value.substr(0, at), value.substr(at + 1));
    } else if (name == "--device") {
      options.device = value;
    } else if (name == "--hand") {
      options.hand = value;
    } else if (name == "--csv") {
      options.csv = value;
    } else {
      fail_usage();
    }
  }
  if (options.files.empty()) {
    for (const char* name : {"cat", "handwriting", "page"}) {
      options.files.push_back(std::string("share/samples/") + name + ".ndjson");
    }
  }
  const bool takes_one =
      options.comparison.empty() || options.is("--snapping") || options.is("--table");
  if (options.device.empty() && takes_one) options.device = "touch";
  const bool known = options.device.empty() || (find_stylus_preset(options.device) &&
                                                (options.hand.empty() || find_hand(options.hand)));
  if (!known || !(options.mm_per_unit > 0.0)) fail_usage();
  return options;
}

/// Returns the first lines of a file, up to `left` strokes, and reduces `left` by their number.
/// Fails if the file cannot be opened.
Result<std::string> lines_of(const std::string& path, std::size_t& left) {
  std::ifstream file(path);
  if (!file) return fail(ErrorCode::kNotFound, path + ": cannot open");
  std::string text, line;
  while (left > 0 && std::getline(file, line)) {
    if (line.find("\"points\"") != std::string::npos) --left;
    text += line + "\n";
  }
  return text;
}

/// One row of the table: all strokes with one material, with forces on or off.
struct Row {
  std::string material;
  bool forces = true;
  ReplayStats stats;
};

Result<ReplayStats> draw(const Options& options, const std::string& material, bool forces,
                         const std::optional<Person>& person = std::nullopt) {
  const SimulatedHand& hand = *find_hand(options.hand.empty() ? "typical" : options.hand);
  ReplaySettings settings =
      replay_settings(*find_stylus_preset(options.device), hand, forces || person, {}, {});
  settings.person = person;
  ReplayMachine machine(settings, Document(), {});
  if (person && !forces) {
    if (Result<void> set = machine.set_option("surface.plane_only", "true"); !set) {
      return tl::unexpected(set.error());
    }
  }
  if (Result<void> set = machine.set_option("pencil.medium", material); !set) {
    return tl::unexpected(set.error());
  }
  for (const auto& [id, text] : options.set) {
    if (Result<void> set = machine.set_option(id, text); !set) return tl::unexpected(set.error());
  }
  const auto start = std::chrono::steady_clock::now();
  ScriptRun run(machine, options.mm_per_unit, 0);
  std::size_t left = options.limit;
  for (const std::string& path : options.files) {
    const Result<std::string> text = lines_of(path, left);
    if (!text) return tl::unexpected(text.error());
    if (Result<void> read = run.script(path, "", read_text(*text)); !read) {
      return tl::unexpected(read.error());
    }
  }
  if (Result<void> played = run.play(); !played) return tl::unexpected(played.error());
  ReplayStats stats = machine.take_stats();
  stats.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return stats;
}

std::vector<std::string> cells_of(const Row& row) {
  const ReplayStats& s = row.stats;
  return {row.material,
          row.forces ? "on" : "off",
          std::to_string(s.strokes_meant),
          std::to_string(s.strokes),
          std::to_string(s.segments),
          fmt::format("{:.3f}", s.distance.mean_mm()),
          fmt::format("{:.3f}", s.distance.p95_mm()),
          fmt::format("{:.3f}", s.distance.max_mm()),
          fmt::format("{:.2f}", s.mean_sent_n()),
          fmt::format("{:.2f}", s.max_sent_n),
          std::to_string(s.soft_faults + s.hard_faults),
          fmt::format("{:.0f}", s.simulated_s),
          fmt::format("{:.0f}", s.times_real_time())};
}

constexpr std::array kColumns = {"material", "forces",  "strokes in", "out",    "segments",
                                 "mean mm",  "95 % mm", "max mm",     "mean N", "peak N",
                                 "faults",   "s",       "x real time"};

void write_csv(const std::string& path, const std::vector<Row>& rows) {
  std::ofstream file(path);
  file << "material,forces,strokes_in,strokes_out,segments,mean_mm,p95_mm,max_mm,mean_n,peak_n,"
          "faults,simulated_s,times_real_time\n";
  for (const Row& row : rows) {
    const std::vector<std::string> cells = cells_of(row);
    for (std::size_t i = 0; i < cells.size(); ++i) file << (i > 0 ? "," : "") << cells[i];
    file << "\n";
  }
}

void print_table(const Options& options, const std::vector<Row>& rows) {
  std::vector<cli::TextTable::Column> columns;
  for (const char* name : kColumns) {
    using Align = cli::TextTable::Align;
    columns.push_back({name, columns.size() < 2 ? Align::kLeft : Align::kRight});
  }
  cli::TextTable table(columns);
  for (const Row& row : rows) table.add_row(cells_of(row));
  fmt::print("{}", table.text(cli::TextStyle::of_stdout()));
  fmt::print(
      "\nSimulated {}, {} hand, paper. mean, 95 %, max: distance between the path that the hand "
      "intended and the ink,\n"
      "in both directions. N: sent while the pen is on the surface. x real time: the whole run, on "
      "one thread of this computer.\n",
      options.device, options.hand);
}

/// Lets people draw with a material, with all forces or with the plane only. Returns the errors of
/// each person, mm.
Result<std::vector<double>> errors_of(const Options& options, const std::string& material,
                                      bool forces, int& lost) {
  std::vector<double> errors;
  for (const Person& person : population(options.people, 1, options.model)) {
    const Result<ReplayStats> stats = draw(options, material, forces, person);
    if (!stats) return tl::unexpected(stats.error());
    errors.push_back(stats->distance.mean_mm());
    lost += static_cast<int>(stats->strokes_meant - stats->strokes);
  }
  return errors;
}

Result<void> compare_people(const Options& options) {
  using Align = cli::TextTable::Align;
  cli::TextTable table({{"material", Align::kLeft},
                        {"plane only mm", Align::kRight},
                        {"default mm", Align::kRight},
                        {"change (95 %)", Align::kRight},
                        {"strokes, plane only", Align::kRight},
                        {"default", Align::kRight}});
  for (const char* material : kMaterials) {
    int lost_off = 0, lost_on = 0;
    const auto off = errors_of(options, material, false, lost_off);
    const auto on = errors_of(options, material, true, lost_on);
    if (!off) return tl::unexpected(off.error());
    if (!on) return tl::unexpected(on.error());
    std::vector<double> change;
    for (std::size_t i = 0; i < off->size(); ++i) change.push_back((*on)[i] / (*off)[i] - 1.0);
    const MeanOverPeople mean = mean_over_people(change);
    table.add_row({material, fmt::format("{:.3f}", mean_over_people(*off).mean),
                   fmt::format("{:.3f}", mean_over_people(*on).mean),
                   fmt::format("{:+.0f} % ({:+.0f} to {:+.0f})", 100.0 * mean.mean,
                               100.0 * mean.low, 100.0 * mean.high),
                   fmt::format("{:+d}", -lost_off), fmt::format("{:+d}", -lost_on)});
  }
  fmt::print("{}", table.text(cli::TextStyle::of_stdout()));
  fmt::print(
      "\n{} simulated people with a simulated {}, paper, default options. mm: mean distance "
      "between the\nintended path and the ink. change: per person, with its 95 % interval over "
      "people. strokes: drawn\nstrokes minus intended ones, of all people; fewer because snapping "
      "joined some.\n",
      options.people, options.device);
  return {};
}

/// Returns the device of the options, or all that have forces, apart from the worst one.
std::vector<std::string> devices_of(const Options& options) {
  std::vector<std::string> devices;
  for (const StylusPreset& preset : stylus_presets()) {
    const bool is_one = options.device.empty()
                            ? preset.name != "worst" && preset.capabilities.has_force()
                            : preset.name == options.device;
    if (is_one) devices.emplace_back(preset.name);
  }
  return devices;
}

Result<void> compare(const Options& options) {
  if (options.is("--table")) return print_force_table(options.device, options.people);
  if (options.is("--baselines")) return compare_baselines(devices_of(options), options.people);
  Result<bool> is_met = true;
  if (options.is("--pull")) {
    is_met = compare_pulls(devices_of(options), options.people, options.set);
  } else if (options.is("--erasing")) {
    is_met = compare_erasing(devices_of(options), options.people);
  } else if (options.is("--contours")) {
    is_met = compare_contours(devices_of(options), options.people);
  } else if (options.is("--retracing")) {
    is_met = compare_retracing(devices_of(options), options.people);
  } else {
    return compare_people(options);
  }
  if (!is_met) return tl::unexpected(is_met.error());
  return *is_met ? Result<void>() : fail(ErrorCode::kInvalidData, "a bar is missed");
}

int run(int argc, char** argv) {
  const Options options = options_of(argc, argv);
  if (options.is("--snapping")) {
    return check_snap_bars(options.files, options.hand, options.people) ? 0 : 1;
  }
  if (options.hand.empty()) {
    const Result<void> compared = compare(options);
    if (!compared) fmt::print(stderr, "bench_feel: {}\n", compared.error().message);
    return compared ? 0 : 1;
  }
  std::vector<Row> rows;
  bool all_came_out = true;
  for (const bool forces : {true, false}) {
    for (const char* material : kMaterials) {
      const Result<ReplayStats> stats = draw(options, material, forces);
      if (!stats) {
        fmt::print(stderr, "bench_feel: {}\n", stats.error().message);
        return 1;
      }
      rows.push_back({material, forces, *stats});
      all_came_out = all_came_out && stats->strokes <= stats->strokes_meant &&
                     stats->strokes >= stats->strokes_meant - stats->strokes_meant / 500;
    }
  }
  print_table(options, rows);
  if (!options.csv.empty()) write_csv(options.csv, rows);
  if (all_came_out) return 0;
  fmt::print(stderr, "bench_feel: some input strokes did not result in exactly one stroke each\n");
  return 1;
}

}  // namespace
}  // namespace felt::bench

int main(int argc, char** argv) {
  return felt::bench::run(argc, argv);
}
