// Compares gather with labelled drawings: the groups with the labels, and the line of each labelled
// strip with the middle of the strip.
//   bench_gather --drawings FOLDER [--each]   FOLDER contains .scap files; --each: a line for each,
//                                            and for each strip whose line misses the middle
//   bench_gather --drawings FOLDER --fit      prints the source of odds_weights.h
// The files with even numbers, sorted by name, are those that the weights were fitted to; the
// others were not used. Exits with 1 if the goals are missed: adjusted Rand index 0.75, precision
// 0.93, 500 strokes in 50 ms of CPU time, and the mean distance of the line from the middle at most
// 10 % of the strip's width in 95 % of the strips.
#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "baseline.h"
#include "felt/gather/line_groups.h"
#include "felt/gather/testing/group_score.h"
#include "felt/gather/testing/labelled_drawing.h"
#include "fit_odds.h"
#include "strip_middle.h"

namespace felt::bench {
namespace {

constexpr double kMinRandIndex = 0.75, kMinPrecision = 0.93, kMaxMs = 50.0;
constexpr double kMaxDistance = 0.1, kMinNear = 0.95;

double cpu_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// The values of several drawings or strips.
struct Series {
  std::vector<double> values;

  [[nodiscard]] double mean() const {
    double sum = 0.0;
    for (const double v : values) sum += v;
    return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
  }
  [[nodiscard]] double median() const {
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    return sorted.empty() ? 0.0 : sorted[sorted.size() / 2];
  }
  [[nodiscard]] double share_up_to(double limit) const {
    const auto n =
        std::count_if(values.begin(), values.end(), [&](double v) { return v <= limit; });
    return values.empty() ? 0.0 : static_cast<double>(n) / static_cast<double>(values.size());
  }
};

struct ScoreSeries {
  Series rand_index, precision, recall;

  void add(const GroupScore& score) {
    rand_index.values.push_back(score.rand_index);
    precision.values.push_back(score.precision);
    recall.values.push_back(score.recall);
  }
  void print(const char* name) const {
    fmt::print("{:<28} {:>3} {:>7.3f} {:>7.3f} {:>7.3f} {:>7.3f} {:>7.3f} {:>7.3f}\n", name,
               rand_index.values.size(), rand_index.mean(), rand_index.median(), precision.mean(),
               precision.median(), recall.mean(), recall.median());
  }
};

/// Returns the mean CPU time for 500 strokes, in ms.
double compare_groups(const std::vector<LabelledDrawing>& drawings, bool each, ScoreSeries& all) {
  ScoreSeries parts[2], baseline;
  double ms = 0.0, strokes = 0.0;
  for (std::size_t i = 0; i < drawings.size(); ++i) {
    const LabelledDrawing& drawing = drawings[i];
    const double start = cpu_ms();
    const std::vector<std::uint32_t> groups = line_groups(drawing.lines).value();
    ms += cpu_ms() - start;
    strokes += static_cast<double>(drawing.lines.size());
    const GroupScore score = group_score(drawing.labels, groups);
    all.add(score);
    parts[i % 2].add(score);
    baseline.add(group_score(drawing.labels, baseline_groups(drawing)));
    if (each) {
      fmt::print("{:<40} {:>4} strokes  {:.2f} {:.2f} {:.2f}\n", drawing.name, drawing.lines.size(),
                 score.rand_index, score.precision, score.recall);
    }
  }
  fmt::print("{:<28} {:>3} {:>15} {:>15} {:>15}\n", "", "n", "Rand mean/med", "precision",
             "recall");
  all.print("all drawings");
  parts[0].print("weights fitted to these");
  parts[1].print("not used for the weights");
  baseline.print("baseline, all drawings");
  return 500.0 * ms / strokes;
}

/// Distances of lines from the middle of their strips, relative to the width of the strip.
struct DistanceSeries {
  Series mean, p95;

  void add(const std::optional<StripDistance>& distance) {
    constexpr double kMissed = 1e3;  // no line, or no section that crosses two strokes
    mean.values.push_back(distance ? distance->mean / distance->width : kMissed);
    p95.values.push_back(distance ? distance->p95 / distance->width : kMissed);
  }
  [[nodiscard]] double share() const { return mean.share_up_to(kMaxDistance); }
  void print(const char* name) const {
    fmt::print("{:<28} {:>3} {:>9.3f} {:>6.1f} % {:>8.3f} {:>6.1f} %\n", name, mean.values.size(),
               mean.median(), 100.0 * share(), p95.median(), 100.0 * p95.share_up_to(kMaxDistance));
  }
};

/// Returns the share of strips in which the mean distance is small enough.
double compare_lines(const std::vector<LabelledDrawing>& drawings, bool each) {
  DistanceSeries all, parts[2];
  double ms = 0.0;
  for (std::size_t d = 0; d < drawings.size(); ++d) {
    const LabelledDrawing& drawing = drawings[d];
    std::map<std::uint32_t, std::vector<RoughLine>> by_label;
    for (std::size_t i = 0; i < drawing.lines.size(); ++i) {
      by_label[drawing.labels[i]].push_back(drawing.lines[i]);
    }
    for (const auto& [label, lines] : by_label) {
      if (lines.size() < 2) continue;
      const double start = cpu_ms();
      const Result<BundlePath> path = bundle_path(lines);
      ms += cpu_ms() - start;
      const auto distance = path ? strip_distance(*path, lines, drawing.pen_width) : std::nullopt;
      all.add(distance);
      parts[d % 2].add(distance);
      const double mean = all.mean.values.back();
      if (each && mean > kMaxDistance) {
        fmt::print("{:<40} label {:>3}, {:>3} strokes: {:.2f}\n", drawing.name, label, lines.size(),
                   mean);
      }
    }
  }
  fmt::print(
      "\nDistance of the line from the middle of its labelled strip, relative to the strip's "
      "width:\nits mean and its 95th percentile along the line, and the share of strips in which "
      "it is at most {}\n{:<28} {:>3} {:>18} {:>17}\n",
      kMaxDistance, "", "n", "mean: median, share", "p95: median, share");
  all.print("all drawings");
  parts[0].print("weights fitted to these");
  parts[1].print("not used for the weights");
  fmt::print("{:.2f} ms CPU time for a strip\n",
             ms / std::max(1.0, static_cast<double>(all.mean.values.size())));
  return all.share();
}

int run(const std::string& folder, bool fit, bool each) {
  const Result<std::vector<LabelledDrawing>> drawings = read_scap_folder(folder);
  if (!drawings) {
    fmt::print(stderr, "{}\n", drawings.error().message);
    return 1;
  }
  if (fit) {
    std::vector<const LabelledDrawing*> even;
    for (std::size_t i = 0; i < drawings->size(); i += 2) even.push_back(&(*drawings)[i]);
    print_fitted_odds(even);
    return 0;
  }
  ScoreSeries all;
  const double ms = compare_groups(*drawings, each, all);
  fmt::print("500 strokes: {:.1f} ms CPU time\n", ms);
  const double near = compare_lines(*drawings, each);
  return all.rand_index.mean() >= kMinRandIndex && all.precision.mean() >= kMinPrecision &&
                 ms <= kMaxMs && near >= kMinNear
             ? 0
             : 1;
}

}  // namespace
}  // namespace felt::bench

int main(int argc, char** argv) {
  std::string folder;
  bool fit = false, each = false;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--drawings" && i + 1 < argc) {
      folder = argv[++i];
    } else if (argument == "--fit") {
      fit = true;
    } else if (argument == "--each") {
      each = true;
    } else {
      folder.clear();
      break;
    }
  }
  if (folder.empty()) {
    fmt::print(stderr, "usage: bench_gather --drawings FOLDER [--each | --fit]\n");
    return 2;
  }
  return felt::bench::run(folder, fit, each);
}
