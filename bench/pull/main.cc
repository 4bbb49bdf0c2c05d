// Compares what a pull does to a stroke: with the brush of the pull tool, with the methods of the
// paper, and with dragging a control point. All get the same random pulls on the same strokes: the
// position is uniform along the ink, the direction is uniform, the length is 2 to 25 mm.
//   bench_pull [--file F --mm-per-unit U]... [--pulls N] [--radius MM] [--seed N] [--picture F.png]
//              [--json]
// Without --file it uses the project's own sample sets. Exits with 1 if the brush is not the best
// method at staying within its span and at following the pen, or if it breaks a smooth joint.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "felt/stroke/arc_map.h"
#include "ink.h"
#include "measure.h"
#include "methods.h"
#include "picture.h"

namespace felt::bench {
namespace {

struct Options {
  std::vector<std::string> files;
  double mm_per_unit = 1.0;
  int pulls = 1000;
  double radius_mm = 20.0;
  std::uint64_t seed = 1;
  std::string picture = "out/bench-pull.png";
  bool json = false;
};

[[noreturn]] void fail_usage() {
  fmt::print(stderr,
             "usage: bench_pull [--file F]... [--mm-per-unit U] [--pulls N] [--radius MM] "
             "[--seed N] [--picture F.png] [--json]\n");
  std::exit(2);
}

Options options_of(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    if (name == "--json") {
      options.json = true;
      continue;
    }
    if (++i == argc) fail_usage();
    const std::string value = argv[i];
    if (name == "--file") {
      options.files.push_back(value);
    } else if (name == "--mm-per-unit") {
      options.mm_per_unit = std::strtod(value.c_str(), nullptr);
    } else if (name == "--pulls") {
      options.pulls = std::atoi(value.c_str());
    } else if (name == "--radius") {
      options.radius_mm = std::strtod(value.c_str(), nullptr);
    } else if (name == "--seed") {
      options.seed = std::strtoull(value.c_str(), nullptr, 10);
    } else if (name == "--picture") {
      options.picture = value;
    } else {
      fail_usage();
    }
  }
  const bool sane = options.mm_per_unit > 0.0 && options.pulls > 0 && options.radius_mm > 0.0;
  if (!sane) fail_usage();
  return options;
}

/// Minimum length of a stroke that is pulled. Shorter strokes count as dots.
constexpr double kShortestMm = 5.0;

/// Returns random pulls. The same seed returns the same pulls.
std::vector<Pull> random_pulls(const std::vector<StrokePtr>& strokes, const Options& options) {
  std::vector<StrokePtr> long_enough;
  std::vector<double> lengths;
  for (const StrokePtr& stroke : strokes) {
    const double length = ArcMap(*stroke).length_mm();
    if (length < kShortestMm) continue;
    long_enough.push_back(stroke);
    lengths.push_back(length);
  }
  std::mt19937_64 random(options.seed);
  const auto uniform = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  std::discrete_distribution<std::size_t> which(lengths.begin(), lengths.end());
  std::vector<Pull> pulls;
  for (int k = 0; k < options.pulls && !long_enough.empty(); ++k) {
    const std::size_t i = which(random);
    const double s = uniform(0.0, lengths[i]), angle = uniform(0.0, 2.0 * std::numbers::pi);
    const double length = uniform(2.0, 25.0);
    pulls.push_back({long_enough[i], ArcMap(*long_enough[i]).u_at(s),
                     length * Vec{std::cos(angle), std::sin(angle)}});
  }
  return pulls;
}

/// The results of one method for all pulls.
struct Row {
  Method method;
  int refused = 0;
  double outside_mean = 0.0, outside_max = 0.0, outside_share = 0.0;
  double pen_mean = 0.0, pen_max = 0.0;
  double bending_mean = 0.0, bending_median = 0.0;
  double turn_mean = 0.0, turn_median = 0.0;
  double breaks = 0.0, segments = 0.0;
};

/// A point of the old stroke counts as moved if its distance from the new stroke is larger, mm.
constexpr double kMovedMm = 1e-3;

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double v : values) sum += v;
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

double median_of(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Row row_of(Method method, const std::vector<Pull>& pulls, double radius_mm) {
  Row row{.method = method};
  std::vector<double> bending, turn;
  for (const Pull& pull : pulls) {
    const Result<StrokeData> now = pulled(method, pull, radius_mm);
    if (!now) {
      ++row.refused;
      continue;
    }
    const Effect effect = effect_of(pull, *now, radius_mm);
    row.outside_mean += effect.outside_mm;
    row.outside_max = std::max(row.outside_max, effect.outside_mm);
    row.outside_share += effect.outside_mm > kMovedMm ? 1.0 : 0.0;
    row.pen_mean += effect.pen_mm;
    row.pen_max = std::max(row.pen_max, effect.pen_mm);
    bending.push_back(effect.bending_per_mm);
    turn.push_back(effect.turn_deg);
    row.breaks += effect.breaks;
    row.segments += effect.segments_added;
  }
  const double done = std::max<double>(1.0, static_cast<double>(bending.size()));
  for (double* mean : {&row.outside_mean, &row.outside_share, &row.pen_mean, &row.segments}) {
    *mean /= done;
  }
  row.bending_mean = mean_of(bending);
  row.bending_median = median_of(bending);
  row.turn_mean = mean_of(turn);
  row.turn_median = median_of(turn);
  return row;
}

void print_table(const std::vector<Row>& rows, const Options& options, std::size_t strokes) {
  fmt::print("{} random pulls of 2 to 25 mm on {} strokes; intended span {} mm to each side\n\n",
             options.pulls, strokes, options.radius_mm);
  fmt::print("{:<15} {:>26} {:>18} {:>15} {:>15} {:>6} {:>6}\n", "", "outside the span, mm   ",
             "from the pen, mm", "turn, degrees", "bending, 1/mm", "G1", "segm.");
  fmt::print("{:<15} {:>8} {:>8} {:>8} {:>9} {:>8} {:>7} {:>7} {:>7} {:>7} {:>6} {:>6} {:>7}\n",
             "method", "mean", "max", "moved", "mean", "max", "median", "mean", "median", "mean",
             "breaks", "added", "refused");
  for (const Row& r : rows) {
    fmt::print(
        "{:<15} {:8.3f} {:8.2f} {:7.1f}% {:9.4f} {:8.3f} {:7.1f} {:7.1f} {:7.2f} {:7.2f} {:6.0f} "
        "{:6.2f} {:7}\n",
        name_of(r.method), r.outside_mean, r.outside_max, 100.0 * r.outside_share, r.pen_mean,
        r.pen_max, r.turn_median, r.turn_mean, r.bending_median, r.bending_mean, r.breaks,
        r.segments, r.refused);
  }
  fmt::print(
      "\noutside: largest distance from a point of the old stroke beyond the span to the new one, "
      "mean and\n"
      "max over the pulls; moved: pulls that move anything there by a micrometre. turn: integral "
      "of |kappa| ds,\n"
      "bending: of kappa^2 ds, new minus old. per tick: as in the paper, at 1 kHz and 100 mm/s.\n");
}

void print_json(const std::vector<Row>& rows, const Options& options, std::size_t strokes) {
  fmt::print("{{\"pulls\":{},\"strokes\":{},\"radius_mm\":{},\"seed\":{},\"methods\":[",
             options.pulls, strokes, options.radius_mm, options.seed);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& r = rows[i];
    fmt::print(
        "{}{{\"method\":\"{}\",\"outside_mean_mm\":{:.6f},\"outside_max_mm\":{:.6f},"
        "\"outside_share\":{:.6f},\"pen_mean_mm\":{:.9f},\"pen_max_mm\":{:.9f},"
        "\"turn_median_deg\":{:.6f},\"turn_mean_deg\":{:.6f},"
        "\"bending_median_per_mm\":{:.6f},\"bending_mean_per_mm\":{:.6f},\"g1_breaks\":{:.0f},"
        "\"segments_added_mean\":{:.6f},\"refused\":{}}}",
        i > 0 ? "," : "", name_of(r.method), r.outside_mean, r.outside_max, r.outside_share,
        r.pen_mean, r.pen_max, r.turn_median, r.turn_mean, r.bending_median, r.bending_mean,
        r.breaks, r.segments, r.refused);
  }
  fmt::print("]}}\n");
}

/// Returns a few pulls that make good pictures: long ones in the middle of long strokes.
std::vector<Pull> to_show(const std::vector<Pull>& pulls, double radius_mm) {
  std::vector<Pull> shown;
  for (const Pull& pull : pulls) {
    const ArcMap map(*pull.stroke);
    const double s = map.length_at(pull.u), rest = map.length_mm() - s;
    const bool is_inside = std::min(s, rest) > 0.6 * radius_mm;
    if (norm(pull.way) > 8.0 && norm(pull.way) < 18.0 && is_inside) shown.push_back(pull);
    if (shown.size() == 5) break;
  }
  return shown;
}

int run(int argc, char** argv) {
  const Options options = options_of(argc, argv);
  std::vector<StrokePtr> strokes;
  for (const std::string& path : options.files) {
    const Result<std::vector<StrokePtr>> more = fitted_file(path, options.mm_per_unit);
    if (!more) {
      fmt::print(stderr, "bench_pull: {}\n", more.error().message);
      return 1;
    }
    strokes.insert(strokes.end(), more->begin(), more->end());
  }
  if (options.files.empty()) strokes = fitted_samples();
  const std::vector<Pull> pulls = random_pulls(strokes, options);
  if (pulls.empty()) {
    fmt::print(stderr, "bench_pull: there is no stroke of at least {} mm\n", kShortestMm);
    return 1;
  }
  std::vector<Row> rows;
  for (const Method method : kMethods) rows.push_back(row_of(method, pulls, options.radius_mm));
  (options.json ? print_json : print_table)(rows, options, strokes.size());
  const Result<void> written =
      write_picture(options.picture, to_show(pulls, options.radius_mm), options.radius_mm);
  if (!written) {
    fmt::print(stderr, "bench_pull: {}\n", written.error().message);
    return 1;
  }
  const auto is_best = [&](const Row& r) {
    return rows[0].outside_mean <= r.outside_mean && rows[0].pen_mean <= r.pen_mean + 1e-9;
  };
  return std::all_of(rows.begin(), rows.end(), is_best) && rows[0].breaks == 0.0 ? 0 : 1;
}

}  // namespace
}  // namespace felt::bench

int main(int argc, char** argv) {
  return felt::bench::run(argc, argv);
}
