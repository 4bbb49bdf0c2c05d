#include "felt/tools/eraser/guard_ridge.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

#include "felt/document/stroke_index.h"
#include "felt/geometry/nearest.h"
#include "felt/geometry/polyline.h"
#include "felt/stroke/drawn_profile.h"
#include "felt/tools/eraser/eraser_gesture.h"
#include "felt/tools/guide_choice.h"
#include "felt/tools/guided_feel.h"

namespace felt {
namespace {

constexpr double kMinCoreMm = 0.3;
// A shorter line is a point for the force.
constexpr double kPointMm = 0.2;
constexpr double kRiseS = 0.02;

/// Returns the line as points about kSpacingMm apart. A closed line does not repeat its first
/// point.
std::vector<Point> equal_steps(const Stroke& stroke, double& spacing_mm, bool& is_closed) {
  std::vector<Point> path = stroke_path(stroke);
  is_closed = is_closed_path(stroke, path);
  if (is_closed && path.front() != path.back()) path.push_back(path.front());
  const double length_mm = polyline_length(path);
  if (length_mm < kPointMm) return {path.front()};
  const double steps = std::max(2.0, std::round(length_mm / GuidePiece::kSpacingMm));
  spacing_mm = length_mm / steps;
  std::vector<Point> points(static_cast<std::size_t>(steps) + 1);
  resample(path, points);
  if (is_closed) points.pop_back();
  return points;
}

}  // namespace

GuideLaw GuardRidge::law(double touch_mm, double force_n, const Capabilities& device) noexcept {
  return {.well = {.radius_mm = touch_mm + kBeforeMm,
                   .core_mm = std::max(kMinCoreMm, touch_mm - kPassedMm),
                   .rim_mm = kBeforeMm,
                   .force_n = force_n,
                   .damping_n_s_per_m = guide_spring_for(device).damping_n_s_per_m},
          .pushes_away = true,
          .rise_s = kRiseS};
}

void GuardRidge::end() noexcept {
  meant_.clear();
  passed_ = 0;
  is_active_ = false;
  pen_.reset();
  line_.reset();
}

void GuardRidge::update(Point pen, EraserMode mode, const EraserSettings& settings,
                        const Scene& scene) {
  mode_ = mode;
  const Point from = pen_.value_or(pen);
  pen_ = pen;
  const bool acts = settings.guard_n > 0.0 && settings.radius_mm <= kMaxRadiusMm &&
                    scene.device.has_force() && passed_ < kMaxPassed;
  is_active_ = acts && !meant_.empty();
  if (!acts) return line_.reset();
  // A fast pen passes lines between two samples.
  const int steps =
      std::clamp(static_cast<int>(std::ceil(distance(from, pen) / kStepMm)), 1, kMaxSteps);
  std::vector<Near> near;
  for (int i = 1; i <= steps; ++i) {
    near = lines_near(lerp(from, pen, static_cast<double>(i) / steps), settings, scene);
    pass(near);
  }
  is_active_ = !meant_.empty() && passed_ < kMaxPassed;
  follow(near, scene);
  if (!line_) return;
  const auto at = std::find_if(near.begin(), near.end(),
                               [this](const Near& line) { return line.id == line_->id; });
  guide_ = Guide(law(at->touch_mm, settings.guard_n, scene.device), piece_at(pen));
}

/// Returns the lines that the eraser covers or almost touches, by ascending id.
std::vector<GuardRidge::Near> GuardRidge::lines_near(Point pen, const EraserSettings& settings,
                                                     const Scene& scene) const {
  // After the touch, this mode acts on the lines that the path of the pen crosses.
  const bool by_path = mode_ == EraserMode::kCrossing && !meant_.empty();
  const bool adds_width = settings.include_width && !by_path;
  const double radius_mm = by_path ? EraserGesture::kPointMm : settings.radius_mm;
  const double widest_mm = adds_width ? scene.index.widest_half_mm() : 0.0;
  const double reach_mm = radius_mm + kBeforeMm + widest_mm;
  std::vector<Near> near;
  const auto visit = [&](StrokeId id, int segment) {
    const StrokePtr stroke = scene.document.find(id);
    if (!stroke) return;
    const auto at = nearest_within(stroke->segment(segment), pen, reach_mm * reach_mm);
    if (!at) return;
    const double half_mm = adds_width ? 0.5 * drawn_width_mm(*stroke, segment + at->t) : 0.0;
    const double gap_mm = std::sqrt(at->distance_squared) - radius_mm - half_mm;
    if (gap_mm < kBeforeMm) near.push_back({id, gap_mm, radius_mm + half_mm});
  };
  const Rect area = Rect{pen.x, pen.y, pen.x, pen.y}.inflated(radius_mm + kBeforeMm);
  if (adds_width) {
    scene.index.for_each_ink_in(area, visit);
  } else {
    scene.index.for_each_segment_in(area, visit);
  }
  std::sort(near.begin(), near.end(), [](const Near& a, const Near& b) {
    return std::tuple(a.id, a.gap_mm, a.touch_mm) < std::tuple(b.id, b.gap_mm, b.touch_mm);
  });
  const auto is_same = [](const Near& a, const Near& b) { return a.id == b.id; };
  near.erase(std::unique(near.begin(), near.end(), is_same), near.end());
  return near;
}

bool GuardRidge::is_meant(StrokeId id) const noexcept {
  return std::binary_search(meant_.begin(), meant_.end(), id);
}

/// Adds the lines that are meant: all lines under the eraser at the first ink, then those that it
/// has passed.
void GuardRidge::pass(const std::vector<Near>& near) {
  const bool is_first = meant_.empty();
  const double limit_mm = is_first ? 0.0 : -kPassedMm;
  const std::size_t before = meant_.size();
  for (const Near& line : near) {
    const double passed_mm = std::max(limit_mm, -line.touch_mm + 0.1);
    if (line.gap_mm > passed_mm || (!is_first && is_meant(line.id))) continue;
    meant_.push_back(line.id);
  }
  if (!is_first) passed_ += static_cast<int>(meant_.size() - before);
  std::sort(meant_.begin(), meant_.end());
}

/// Chooses the line that pushes the pen: the nearest one that is not meant.
void GuardRidge::follow(const std::vector<Near>& near, const Scene& scene) {
  const Near* best = nullptr;
  const Near* last = nullptr;
  for (const Near& line : near) {
    if (is_meant(line.id)) continue;
    if (line_ && line.id == line_->id) last = &line;
    if (!best || line.gap_mm < best->gap_mm) best = &line;
  }
  if (!best || !is_active_) return line_.reset();
  if (last && last->gap_mm <= best->gap_mm + kSwitchMm) return;
  Line line{best->id, scene.document.find(best->id), {}, 0.0, false};
  line.points = equal_steps(*line.stroke, line.spacing_mm, line.is_closed);
  line_ = std::move(line);
  ++hold_;
}

void GuardRidge::draw(Overlay& overlay) const {
  if (!line_) return;
  add_span(overlay, *line_->stroke, 0.0, line_->stroke->segment_count(), Overlay::Role::kTether);
}

/// Returns the part of the line near the pen. At an open end, the piece ends, too.
GuidePiece GuardRidge::piece_at(Point pen) const noexcept {
  const std::vector<Point>& points = line_->points;
  const auto size = static_cast<std::ptrdiff_t>(points.size());
  const auto nearer = [pen](Point a, Point b) {
    return distance_squared(a, pen) < distance_squared(b, pen);
  };
  const std::ptrdiff_t at = std::min_element(points.begin(), points.end(), nearer) - points.begin();
  constexpr auto kCount = static_cast<std::ptrdiff_t>(GuidePiece::kPoints);
  const std::ptrdiff_t count = std::min(size, kCount);
  std::ptrdiff_t from = at - count / 2;
  if (!line_->is_closed) from = std::clamp<std::ptrdiff_t>(from, 0, size - count);
  GuidePiece piece;
  piece.count = static_cast<std::size_t>(count);
  piece.spacing_mm = line_->spacing_mm;
  piece.at_mm = line_->spacing_mm * static_cast<double>(at - from);
  piece.hold = hold_;
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    piece.points[static_cast<std::size_t>(i)] =
        points[static_cast<std::size_t>((from + i + size) % size)];
  }
  return piece;
}

}  // namespace felt
