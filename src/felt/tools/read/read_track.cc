#include "felt/tools/read/read_track.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "felt/geometry/polyline.h"
#include "felt/tools/read/read_force.h"
#include "felt/tools/reading.h"

namespace felt {
namespace {

// How far the pen moves before the nearest line and the marks are searched again, mm. The marks are
// searched so far around the pen that none is missed in between.
constexpr double kLookStepMm = 0.25;
constexpr double kMarkStepMm = 1.0;
constexpr double kMarkReachMm = 6.0;
// A mark becomes a notch, and stops being one, while the pen is beyond the notch's force.
constexpr double kNotchMm = kReadNotch.radius_mm + 1.0;

/// Returns points along a stroke at most about `step_mm` apart.
std::vector<Point> points_of(const Stroke& stroke, double step_mm) {
  std::vector<Point> points{stroke.position(0.0)};
  for (int i = 0; i < stroke.segment_count(); ++i) {
    const Cubic c = stroke.segment(i);
    const double steps = std::clamp(std::ceil(control_length(c) / step_mm), 1.0, 4000.0);
    for (double k = 1.0; k <= steps; ++k) {
      const Point p = evaluate(c, k / steps);
      const bool is_last = i + 1 == stroke.segment_count() && k == steps;
      if (is_last || distance(points.back(), p) >= 0.5 * step_mm) points.push_back(p);
    }
  }
  if (stroke.closed() && points.size() > 2) points.pop_back();  // repeats the first
  return points;
}

double length_of(const Stroke& stroke) {
  double length = 0.0;
  for (int i = 0; i < stroke.segment_count(); ++i) length += arc_length(stroke.segment(i), 0.01);
  return length;
}

}  // namespace

void ReadTrack::update(const PenSample& sample, const Scene& scene, const ReadSettings& settings) {
  const Point pen = on_page(sample.position);
  if (held_ && scene.document.find(held_->id) != held_->stroke) release();
  if (!looked_at_ || distance(*looked_at_, pen) >= kLookStepMm) look(pen, scene, settings);
  if (held_ && held_->groove) held_->groove->update(sample);
  look_for_marks(pen, scene, settings.layers);
  arrive(pen);
}

/// Searches the nearest line, and holds it if it is nearer than the present one.
void ReadTrack::look(Point pen, const Scene& scene, const ReadSettings& settings) {
  looked_at_ = pen;
  nearest_ = nearest_read(scene, pen, Reading::kFarMm, settings.layers);
  if (!nearest_) return release();
  if (held_ && held_->id == nearest_->stroke) return;
  const double limit_mm = nearest_->distance_mm + kSwitchMm;
  if (held_ && is_read(scene, held_->id, settings.layers) &&
      distance_to(scene, held_->id, pen, limit_mm)) {
    return;
  }
  hold(nearest_->stroke, scene, settings.strength);
}

void ReadTrack::hold(StrokeId id, const Scene& scene, double strength) {
  const std::optional<StrokeHit> nearest = nearest_;
  const std::optional<Point> looked_at = looked_at_;
  release();
  nearest_ = nearest;
  looked_at_ = looked_at;
  held_ = Held{id, scene.document.find(id), 0.0, std::nullopt};
  held_->length_mm = length_of(*held_->stroke);
  const double step_mm = std::max(GuidePiece::kSpacingMm,
                                  2.2 * held_->length_mm / static_cast<double>(kMaxGuidePoints));
  GuideLine line{GuideKind::kGroove,
                 points_of(*held_->stroke, step_mm),
                 held_->stroke->closed(),
                 kReadGrooveShare * strength,
                 {}};
  if (line.points.size() < 3) line.is_closed = false;
  if (check_guide(line)) held_->groove.emplace(std::move(line), ++number_);
}

void ReadTrack::release() {
  if (held_ && held_->groove) number_ = held_->groove->hold();
  nearest_.reset();
  held_.reset();
  looked_at_.reset();
  marked_at_.reset();
  marks_.clear();
  arrived_.reset();
  notch_.reset();
}

void ReadTrack::look_for_marks(Point pen, const Scene& scene, ReadLayers layers) {
  if (!held_ || (marked_at_ && distance(*marked_at_, pen) < kMarkStepMm)) return;
  marked_at_ = pen;
  marks_ = marks_near(scene, held_->id, pen, kMarkReachMm, layers);
}

/// Finds the mark at which the pen is, and the one that is felt.
void ReadTrack::arrive(Point pen) {
  const auto nearest =
      std::min_element(marks_.begin(), marks_.end(), [&](const LineMark& a, const LineMark& b) {
        return distance_squared(a.at, pen) < distance_squared(b.at, pen);
      });
  if (arrived_ && distance(arrived_->at, pen) > kLeaveMm) arrived_.reset();
  if (notch_ && distance(notch_->at, pen) > kNotchMm) notch_.reset();
  if (nearest == marks_.end()) return;
  const double away_mm = distance(nearest->at, pen);
  if (!arrived_ && away_mm < kArriveMm) arrived_ = *nearest;
  if (!notch_ && away_mm < kNotchMm) notch_ = *nearest;
}

}  // namespace felt
