#include "tests/drawing/snapping/snap_count.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <utility>

#include "felt/devices/simulated/samples/sample_sets.h"
#include "felt/document/visible_strokes.h"
#include "felt/geometry/nearest.h"
#include "felt/io/ndjson/ndjson_lines.h"
#include "felt/replay/script_run.h"
#include "felt/stroke/stroke.h"

namespace felt::snap_test {

Result<SnapCount> draw_lines(const std::string& ndjson, const SnapHand& hand,
                             const std::string& snap) {
  ReplaySettings settings =
      replay_settings(*find_stylus_preset(hand.device), *find_hand(hand.name), hand.forces, {}, {});
  settings.person = hand.person;
  ReplayMachine machine(settings, Document(), {});
  if (!snap.empty()) {
    if (Result<void> set = machine.set_option("pencil.snap", snap); !set) {
      return tl::unexpected(set.error());
    }
  }
  ScriptRun run(machine, 1.0, hand.tremor_seed);
  if (Result<void> read = run.script("scene", "", read_text(ndjson)); !read) {
    return tl::unexpected(read.error());
  }
  if (Result<void> played = run.play(); !played) return tl::unexpected(played.error());
  const ReplayStats stats = machine.take_stats();
  SnapCount count{.meant = static_cast<int>(stats.strokes_meant),
                  .strokes = static_cast<int>(stats.strokes),
                  .closed = 0,
                  .mean_mm = stats.distance.mean_mm(),
                  .ink = {}};
  for (const StrokePtr& stroke : visible_strokes(machine.session().document())) {
    count.closed += stroke->closed() ? 1 : 0;
    count.ink.push_back(*stroke);
  }
  return count;
}

namespace {

constexpr double kDrawnToMm = 1.5;
constexpr double kContinuedToMm = 0.8;
constexpr double kMeetMm = 0.5;
constexpr double kSameMm = 1e-6;

/// Returns two gaps of the `n` lines that start at index `i`: the largest gap between one line and
/// the next, and the gap between the last line and the first.
std::pair<double, double> gaps(const std::vector<Stroke>& ink, std::size_t i, std::size_t n) {
  double between = 0.0, last = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    const Point end = tip_point(ink[i + k], StrokeTip::kEnd);
    last = distance(end, tip_point(ink[i + (k + 1) % n], StrokeTip::kStart));
    if (k + 1 < n) between = std::max(between, last);
  }
  return {between, last};
}

/// Returns the distance from `p` to the centre line of `stroke`.
double gap_to(const Stroke& stroke, Point p) {
  double squared = std::numeric_limits<double>::infinity();
  for (int i = 0; i < stroke.segment_count(); ++i) {
    squared = std::min(squared, nearest(stroke.segment(i), p).distance_squared);
  }
  return std::sqrt(squared);
}

double extent_of(const Rect& box) {
  return std::hypot(box.width(), box.height());
}

Rect box_of(const std::vector<Point>& points) {
  Rect box;
  for (const Point& p : points) box.extend(p);
  return box;
}

}  // namespace

std::vector<std::vector<Point>> paths_of(const std::string& ndjson) {
  std::vector<std::vector<Point>> paths;
  std::istringstream lines(ndjson);
  for (std::string line; std::getline(lines, line);) {
    std::size_t at = line.find("\"points\":[");
    if (at == std::string::npos) continue;
    paths.emplace_back();
    for (at = line.find('[', at); (at = line.find('[', at + 1)) != std::string::npos;) {
      char* end = nullptr;
      const double x = std::strtod(&line[at + 1], &end);
      paths.back().push_back({x, std::strtod(end + 1, nullptr)});
    }
  }
  return paths;
}

int shapes_drawn(const SnapCount& drawn, const std::vector<std::vector<Point>>& meant,
                 int lines_per_shape) {
  const auto n = static_cast<std::size_t>(lines_per_shape);
  if (meant.size() != drawn.ink.size()) return 0;  // some lines of this hand made no stroke
  int count = 0;
  for (std::size_t i = 0; i + n <= drawn.ink.size(); i += n) {
    const auto [between, last] = gaps(drawn.ink, i, n);
    bool same_size = true;
    for (std::size_t k = i; k < i + n; ++k) {
      const double ratio =
          extent_of(box_of(drawn.ink[k].data().points)) / extent_of(box_of(meant[k]));
      same_size = same_size && ratio > 0.75 && ratio < 1.33;
    }
    const bool near = between <= kContinuedToMm && last <= (n < 3 ? kDrawnToMm : kContinuedToMm);
    count += near && same_size ? 1 : 0;
  }
  return count;
}

int shapes_meant(const std::vector<std::vector<Point>>& meant) {
  return static_cast<int>(std::count_if(meant.begin(), meant.end(), [](const auto& path) {
    return extent_of(box_of(path)) > kDrawnToMm && distance(path.front(), path.back()) <= kMeetMm;
  }));
}

int outlines_meant(const std::vector<std::vector<Point>>& meant) {
  const auto is_outline = [](const std::vector<Point>& a, const std::vector<Point>& b) {
    if (a.empty() || b.empty()) return false;
    const auto meet = [](Point p, Point q) { return distance(p, q) <= kContinuedToMm; };
    const bool same_ends = (meet(a.front(), b.front()) && meet(a.back(), b.back())) ||
                           (meet(a.front(), b.back()) && meet(a.back(), b.front()));
    return same_ends && distance(a[a.size() / 2], b[b.size() / 2]) > kDrawnToMm;
  };
  int pairs = 0;
  for (std::size_t i = 0; i < meant.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) pairs += is_outline(meant[i], meant[k]) ? 1 : 0;
  }
  return pairs;
}

int shapes_closed(const SnapCount& count, int lines_per_shape) {
  if (lines_per_shape < 3) return count.closed;
  const auto n = static_cast<std::size_t>(lines_per_shape);
  int closed = 0;
  for (std::size_t i = 0; i + n <= count.ink.size(); i += n) {
    closed += gaps(count.ink, i, n) == std::pair(0.0, 0.0) ? 1 : 0;
  }
  return closed;
}

int ends_met_unasked(const SnapCount& count, const SnapCount& off) {
  if (off.ink.size() != count.ink.size()) return 0;  // strokes were joined; joined() counts them
  int ends = 0;
  for (std::size_t i = 0; i < count.ink.size(); ++i) {
    for (const StrokeTip tip : {StrokeTip::kStart, StrokeTip::kEnd}) {
      const Point end = tip_point(count.ink[i], tip), drawn = tip_point(off.ink[i], tip);
      for (std::size_t k = 0; k < count.ink.size(); ++k) {
        if (k == i || gap_to(count.ink[k], end) > kSameMm) continue;
        ends += gap_to(off.ink[k], drawn) > kContinuedToMm ? 1 : 0;
        break;
      }
    }
  }
  return ends;
}

std::string lines_of(const SnapScene& scene, std::uint64_t seed) {
  WritingHand hand({.seed = seed});
  SampleSet set;
  for (const Gesture& gesture : scene.strokes) {
    set.strokes.push_back({std::to_string(set.strokes.size() + 1), hand.draw(gesture)});
  }
  return to_ndjson(set);
}

}  // namespace felt::snap_test
