#include "felt/tools/eraser/guard_ridge.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "felt/document/stroke_index.h"
#include "felt/geometry/nearest.h"
#include "felt/stroke/drawn_profile.h"
#include "felt/tools/eraser/eraser_gesture.h"
#include "felt/tools/guide_choice.h"
#include "felt/tools/guided_feel.h"

namespace felt {
namespace {

constexpr double kMinCoreMm = 0.3;
constexpr double kDotMm = 0.5 * kMinGuideMm;  // half of the length of a dot, for the force
constexpr double kRiseS = 0.02;
// Between two samples, lines are passed at positions of the pen at most this far apart, as a share
// of the eraser's radius, so that none is missed. A pen that leaps further than kMaxLookSteps of
// them is not guided by any force.
constexpr double kLookStepShare = 0.25;
constexpr int kMaxLookSteps = 100;

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
  let_go();
  meant_.clear();
  passed_ = 0;
  is_active_ = false;
  pen_.reset();
}

/// Ends the push. Its numbers are not used again (Retrace::let_go).
void GuardRidge::let_go() noexcept {
  if (!track_) return;
  hold_ = std::max(hold_, track_->hold());
  track_.reset();
  stroke_.reset();
}

void GuardRidge::update(const PenSample& sample, EraserMode mode, const EraserSettings& settings,
                        const Scene& scene) {
  const Point pen = on_page(sample.position);
  const Point from = pen_.value_or(pen);
  mode_ = mode;
  pen_ = pen;
  is_active_ = false;
  if (!(settings.guard_n > 0.0) || !(settings.radius_mm <= kMaxRadiusMm) || !scene.feels_tools ||
      !scene.device.has_force() || passed_ >= kMaxPassed) {
    return let_go();
  }
  const double steps =
      std::max(1.0, std::ceil(distance(from, pen) / (kLookStepShare * settings.radius_mm)));
  if (!(steps <= kMaxLookSteps) || !collect(from, pen, settings, scene)) {
    passed_ = kMaxPassed;
    return let_go();
  }
  for (double step = 1.0; step <= steps && passed_ < kMaxPassed; ++step) {
    look(lerp(from, pen, step / steps), settings);
    pass();
  }
  is_active_ = !meant_.empty() && passed_ < kMaxPassed;
  const Near* line = is_active_ ? choose() : nullptr;
  if (!line) return let_go();
  push(*line, sample, settings.guard_n, scene.device);
}

/// Collects the segments near the path of the pen. Returns false if there are too many.
bool GuardRidge::collect(Point from, Point to, const EraserSettings& settings, const Scene& scene) {
  parts_.clear();
  const bool adds_width = settings.include_width && !erases_by_path();
  const double radius_mm = erases_by_path() ? EraserGesture::kPointMm : settings.radius_mm;
  const Rect area = Rect{std::min(from.x, to.x), std::min(from.y, to.y), std::max(from.x, to.x),
                         std::max(from.y, to.y)}
                        .inflated(radius_mm + kBeforeMm);
  const auto visit = [&](StrokeId id, int segment) {
    if (parts_.size() <= kMaxSegments) parts_.push_back({id, nullptr, segment});
  };
  if (adds_width) {
    scene.index.for_each_ink_in(area, visit);
  } else {
    scene.index.for_each_segment_in(area, visit);
  }
  if (parts_.size() > kMaxSegments) return false;
  std::sort(parts_.begin(), parts_.end(), [](const Part& a, const Part& b) {
    return std::tuple(a.id, a.segment) < std::tuple(b.id, b.segment);
  });
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const bool is_known = i > 0 && parts_[i - 1].id == parts_[i].id;
    parts_[i].stroke = is_known ? parts_[i - 1].stroke : scene.document.find(parts_[i].id);
  }
  return true;
}

/// Finds the lines that an eraser at this position covers or almost touches.
void GuardRidge::look(Point pen, const EraserSettings& settings) {
  near_.clear();
  const bool adds_width = settings.include_width && !erases_by_path();
  const double radius_mm = erases_by_path() ? EraserGesture::kPointMm : settings.radius_mm;
  for (const Part& part : parts_) {
    if (!part.stroke) continue;
    const auto at = nearest(part.stroke->segment(part.segment), pen);
    const double half_mm =
        adds_width ? 0.5 * drawn_width_mm(*part.stroke, part.segment + at.t) : 0.0;
    const double gap_mm = std::sqrt(at.distance_squared) - radius_mm - half_mm;
    if (!(gap_mm < kBeforeMm)) continue;
    const Near line{part.id, part.stroke, gap_mm, radius_mm + half_mm};
    if (near_.empty() || near_.back().id != part.id) {
      near_.push_back(line);
    } else if (gap_mm < near_.back().gap_mm) {
      near_.back() = line;
    }
  }
}

bool GuardRidge::is_meant(StrokeId id) const noexcept {
  return std::binary_search(meant_.begin(), meant_.end(), id);
}

/// Adds the lines that are meant: all lines under the eraser at the first ink, then those that it
/// has passed.
void GuardRidge::pass() {
  const bool is_first = meant_.empty();
  const std::size_t before = meant_.size();
  for (const Near& line : near_) {
    const double passed_mm = is_first ? 0.0 : -std::min(kPassedMm, kPassedShare * line.touch_mm);
    if (line.gap_mm > passed_mm || (!is_first && is_meant(line.id))) continue;
    meant_.push_back(line.id);
    std::inplace_merge(meant_.begin(), meant_.end() - 1, meant_.end());
  }
  if (!is_first) passed_ += static_cast<int>(meant_.size() - before);
}

/// Returns the line that pushes the pen: the nearest one that is not meant, or null.
const GuardRidge::Near* GuardRidge::choose() const noexcept {
  const Near* best = nullptr;
  const Near* last = nullptr;
  for (const Near& line : near_) {
    if (is_meant(line.id)) continue;
    if (track_ && line.id == id_) last = &line;
    if (!best || line.gap_mm < best->gap_mm) best = &line;
  }
  return last && last->gap_mm <= best->gap_mm + kSwitchMm ? last : best;
}

/// Lets the line push the pen.
void GuardRidge::push(const Near& line, const PenSample& sample, double force_n,
                      const Capabilities& device) {
  const GuideLaw now = law(line.touch_mm, force_n, device);
  if (!track_ || id_ != line.id) {
    let_go();
    GuideLine path{.kind = GuideKind::kErrorAmplifying, .points = stroke_path(*line.stroke)};
    path.is_closed = is_closed_path(*line.stroke, path.points);
    if (!check_guide(path) && !path.points.empty()) {  // a dot
      const Point dot = path.points.front();
      path.points = {dot - Vec{kDotMm, 0.0}, dot + Vec{kDotMm, 0.0}};
      path.is_closed = false;
    }
    if (!check_guide(path)) return;
    id_ = line.id;
    stroke_ = line.stroke;
    track_.emplace(std::move(path), ++hold_, now, GuideTrack::Ends::kEnd);
  }
  track_->set_law(now);
  track_->update(sample);
}

void GuardRidge::draw(Overlay& overlay) const {
  if (!track_) return;
  add_span(overlay, *stroke_, 0.0, stroke_->segment_count(), Overlay::Role::kTether);
}

}  // namespace felt
