#include "snap_bars.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <utility>

#include "apps/cli/text_table.h"
#include "tests/drawing/snapping/snap_count.h"

namespace felt::bench {
namespace {

using snap_test::SnapCount;
using snap_test::SnapHand;
using snap_test::SnapScene;

constexpr double kMaxUnwantedShare = 1.0 / 500.0;
/// Maximum number of ends per stroke that share a point with another line although they were not
/// drawn to it.
constexpr double kMaxMetShare = 1.0 / 300.0;
constexpr double kMaxErrorRatio = 1.1;
constexpr double kMinClosedShare = 0.95;

struct Lines {
  std::string name;
  std::string text;
  int lines_per_shape = 0;
};

struct Totals {
  int strokes = 0, unwanted = 0, met = 0, shapes = 0, closed = 0;
  /// Sums over people of the mean error per scene, mm: without and with snapping.
  std::map<std::string, std::pair<double, double>> errors;

  [[nodiscard]] double worst_ratio() const {
    double worst = 0.0;
    for (const auto& [scene, mm] : errors) worst = std::max(worst, mm.second / mm.first);
    return worst;
  }
};

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string title_of(const SnapHand& hand) {
  if (hand.person) return "people" + std::string(hand.forces ? "" : ", no force");
  return hand.name + (hand.forces ? "" : ", no force") + (hand.tremor_seed > 0 ? ", tremor" : "");
}

class Bars {
 public:
  explicit Bars(const SnapHand& hand) : title_(title_of(hand)) {}

  /// Draws the lines with a hand and adds the results, to `table`, too, if it is not null.
  bool add(const SnapHand& hand, const Lines& lines, cli::TextTable* table = nullptr) {
    const auto off = draw_lines(lines.text, hand, "off");
    const auto now = draw_lines(lines.text, hand);
    if (!off || !now) return false;
    const std::vector<std::vector<Point>> meant = snap_test::paths_of(lines.text);
    const double ratio = off->mean_mm > 0.0 ? now->mean_mm / off->mean_mm : 1.0;
    const int met = ends_met_unasked(*now, *off);
    int unwanted = 0;
    int shapes = 0, closed = 0;
    if (lines.lines_per_shape > 0) {
      shapes = snap_test::shapes_drawn(*off, meant, lines.lines_per_shape);
      closed = std::min(shapes_closed(*now, lines.lines_per_shape), shapes);
      totals_.shapes += shapes;
      totals_.closed += closed;
    } else {
      // Lines and pairs of lines that are closed in the file are meant to close, so only additional
      // closed strokes count.
      const int outlines = snap_test::outlines_meant(meant);
      unwanted = std::max(0, off->strokes - now->strokes - outlines) +
                 std::max(0, now->closed - snap_test::shapes_meant(meant) - outlines);
      totals_.strokes += now->meant;
      totals_.unwanted += unwanted;
      totals_.met += met;
      if (off->mean_mm > 0.0) {
        auto& [off_mm, now_mm] = totals_.errors[lines.name];
        off_mm += off->mean_mm;
        now_mm += now->mean_mm;
      }
    }
    if (!table) return true;
    table->add_row({title_, lines.name, std::to_string(now->meant), std::to_string(met),
                    std::to_string(now->joined()), std::to_string(now->closed),
                    lines.lines_per_shape > 0 ? fmt::format("{} of {}", closed, shapes) : "",
                    fmt::format("{:.3f}", off->mean_mm), fmt::format("{:.3f}", now->mean_mm),
                    fmt::format("{:.2f}", ratio)});
    return true;
  }

  [[nodiscard]] bool hold() const {
    return totals_.unwanted <= kMaxUnwantedShare * totals_.strokes &&
           totals_.met <= kMaxMetShare * totals_.strokes &&
           totals_.worst_ratio() <= kMaxErrorRatio &&
           totals_.closed >= kMinClosedShare * totals_.shapes;
  }
  void print() const {
    fmt::print(
        "{:<24} {} of {} strokes joined or closed by mistake, {} ends met, path error at most "
        "{:.2f} times, {} of {} shapes closed{}\n",
        title_, totals_.unwanted, totals_.strokes, totals_.met, totals_.worst_ratio(),
        totals_.closed, totals_.shapes, hold() ? "" : ": MISSED");
  }

 private:
  std::string title_;
  Totals totals_;
};

std::vector<SnapHand> hands(const std::string& only) {
  std::vector<SnapHand> all;
  for (const char* name : {"light", "soft", "typical", "firm"}) {
    for (const bool forces : {true, false}) {
      if (only.empty() || only == name) {
        all.push_back({.name = name, .device = "touch", .forces = forces, .tremor_seed = 0});
      }
    }
    if (only.empty() || only == name) {
      all.push_back({.name = name, .device = "touch", .forces = true, .tremor_seed = 7});
    }
  }
  return all;
}

}  // namespace

bool check_snap_bars(const std::vector<std::string>& files, const std::string& only_hand,
                     std::size_t people) {
  std::vector<Lines> all;
  for (const SnapScene& scene : snap_test::scenes_to_leave_alone()) {
    all.push_back({scene.name, lines_of(scene)});
  }
  for (const SnapScene& scene : snap_test::scenes_to_close()) {
    all.push_back({scene.name, lines_of(scene), scene.lines_per_shape});
  }
  for (const std::string& path : files) {
    all.push_back({std::filesystem::path(path).stem().string(), text_of(path)});
  }
  using Align = cli::TextTable::Align;
  cli::TextTable table({{"hand", Align::kLeft},
                        {"scene", Align::kLeft},
                        {"strokes", Align::kRight},
                        {"met", Align::kRight},
                        {"joined", Align::kRight},
                        {"closed", Align::kRight},
                        {"meant", Align::kRight},
                        {"off mm", Align::kRight},
                        {"on mm", Align::kRight},
                        {"ratio", Align::kRight}});
  std::vector<Bars> bars;
  bool ok = true;
  for (const SnapHand& hand : hands(only_hand)) {
    Bars& of_hand = bars.emplace_back(hand);
    for (const Lines& lines : all) ok = of_hand.add(hand, lines, &table) && ok;
  }
  for (const bool forces : {true, false}) {
    SnapHand hand{.forces = forces, .person = Person()};
    Bars& of_people = bars.emplace_back(hand);
    for (const Person& person : population(people)) {
      hand.person = person;
      for (const Lines& lines : all) ok = of_people.add(hand, lines) && ok;
    }
  }
  fmt::print("{}\n", table.text(cli::TextStyle::of_stdout()));
  for (const Bars& of_hand : bars) {
    of_hand.print();
    ok = ok && of_hand.hold();
  }
  return ok;
}

}  // namespace felt::bench
