#include "felt/tools/pencil/shape_hold.h"

#include <algorithm>

#include "felt/base/constants.h"
#include "felt/geometry/polyline.h"
#include "felt/tools/gesture_tool.h"

namespace felt {
namespace {

/// The pressure grows at the touch; this part of a line does not count.
constexpr double kTouchS = 0.15;
/// Share of the newest sample in the pressure of the resting pen.
constexpr double kSmoothing = 0.05;
/// Time after which a pen that was not slow enough is examined again, if it is still in its place.
constexpr double kAskAgainS = 0.25;
/// Time constant of the speed of the pen while shapes are offered (chosen).
constexpr double kPaceS = 0.1;

/// Returns the path up to where the rest began: a resting pen trembles, which is not a part of the
/// shape.
std::span<const Point> before_rest(std::span<const Point> path, Point rest) noexcept {
  std::size_t count = path.size();
  while (count > 0 && distance(path[count - 1], rest) <= RestWatch::kRestMm) --count;
  return path.first(std::min(count + 1, path.size()));
}

/// Returns the largest mean speed of a resting pen after a line, in mm/s. Small writing also stays
/// within the radius of a rest for some time, at its usual pace. `drawing_s` is the time of the
/// line before the rest.
double max_rest_speed(std::span<const Point> before, double drawing_s) noexcept {
  if (before.empty() || !(drawing_s > 0.0)) return kInf;
  return ShapeHold::kMaxRestPace * polyline_length(before) / drawing_s;
}

}  // namespace

void ShapeHold::begin(Point pen, std::int64_t time_ns) noexcept {
  rest_.begin(pen, time_ns);
  ask_at_s_ = 0.0;
  shapes_.clear();
  accepted_.reset();
  start_ns_ = time_ns;
  low_ = 1.0;
  high_ = 0.0;
  has_pressure_ = false;
}

void ShapeHold::watch_pressure(std::optional<double> pressure, std::int64_t time_ns) noexcept {
  if (!pressure) return;
  if (!has_pressure_) smooth_ = *pressure;
  has_pressure_ = true;
  smooth_ += kSmoothing * (*pressure - smooth_);
  if (!shapes_.empty()) return;
  if (seconds_between(start_ns_, time_ns, 1.0) < kTouchS) return;
  low_ = std::min(low_, *pressure);
  high_ = std::max(high_, *pressure);
}

void ShapeHold::watch_resting_pressure(std::int64_t time_ns) noexcept {
  if (!rest_.rests()) return;
  const double away_s = 1e-9 * static_cast<double>(time_ns - rested_ns_) - rest_.still_s();
  // A pen that presses less may press again.
  resting_ = away_s > kSlipS ? smooth_ : std::min(resting_, smooth_);
  rested_ns_ = time_ns;
}

void ShapeHold::watch_pace(Point pen, std::int64_t time_ns) noexcept {
  const double step_s = 1e-9 * static_cast<double>(time_ns - last_ns_);
  if (step_s > 0.0) speed_ += (distance(last_, pen) - step_s * speed_) / (kPaceS + step_s);
  last_ = pen;
  last_ns_ = time_ns;
}

bool ShapeHold::is_accepted_by(std::optional<double> pressure) const noexcept {
  // The pressure of a pen that goes on drawing changes for other reasons, also in one place.
  if (!rest_.rests() || speed_ > max_speed_) return false;
  const bool is_constant = !has_pressure_ || high_ - low_ < kConstantPressure;
  if (is_constant && rest_.still_s() >= offered_s_ + kStayS) return true;
  const double rise = std::min(kPress, 0.5 * (1.0 - resting_));
  return pressure && rise > 0.01 && *pressure >= resting_ + rise;
}

void ShapeHold::update(Point pen, std::optional<double> pressure, std::int64_t time_ns,
                       std::span<const Point> path) {
  if (accepted_) return;
  rest_.update(pen, time_ns);
  watch_pressure(pressure, time_ns);
  if (!shapes_.empty()) {
    watch_resting_pressure(time_ns);
    watch_pace(pen, time_ns);
    if (distance(pen, held_) > kLeaveMm) {
      shapes_.clear();
    } else if (is_accepted_by(pressure)) {
      accepted_ = 0;
    }
  }
  if (!rest_.rests()) ask_at_s_ = 0.0;
  if (!rest_.rests() || rest_.still_s() < ask_at_s_ || !shapes_.empty()) return;
  const std::span<const Point> before = before_rest(path, rest_.at());
  const double drawing_s = 1e-9 * static_cast<double>(time_ns - start_ns_) - rest_.still_s();
  max_speed_ = max_rest_speed(before, drawing_s);
  const double rest_mm = polyline_length(path.subspan(before.empty() ? 0 : before.size() - 1));
  const bool is_slow = rest_mm <= max_speed_ * rest_.still_s();
  ask_at_s_ = is_slow ? kInf : rest_.still_s() + kAskAgainS;
  if (!is_slow) return;
  shapes_ = guess_shapes(before);
  held_ = rest_.at();
  last_ = pen;
  last_ns_ = time_ns;
  speed_ = 0.0;
  offered_s_ = rest_.still_s();
  resting_ = smooth_;
  rested_ns_ = time_ns;
}

void ShapeHold::accept(OfferKind kind) noexcept {
  if (kind == OfferKind::kInk) shapes_.clear();
  for (std::size_t i = 0; i < shapes_.size() && !accepted_; ++i) {
    if (offer_of(shapes_[i].form) == kind) accepted_ = i;
  }
}

std::optional<Point> ShapeHold::holds_at() const noexcept {
  if (shapes_.empty() || accepted_) return std::nullopt;
  return held_;
}

WellShape hold_shape(double strength) noexcept {
  return {.radius_mm = 2.0 * ShapeHold::kLeaveMm,
          .core_mm = 3.0,
          .rim_mm = 2.0,
          .force_n = strength * ShapeHold::kHoldN,
          .damping_n_s_per_m = strength};
}

OfferKind offer_of(ShapeForm form) noexcept {
  switch (form) {
    case ShapeForm::kLine:
      return OfferKind::kLine;
    case ShapeForm::kArc:
      return OfferKind::kArc;
    case ShapeForm::kCircle:
      return OfferKind::kCircle;
    case ShapeForm::kEllipse:
      return OfferKind::kEllipse;
    case ShapeForm::kTriangle:
      return OfferKind::kTriangle;
    case ShapeForm::kRectangle:
      return OfferKind::kRectangle;
    case ShapeForm::kPolygon:
      break;
  }
  return OfferKind::kPolygon;
}

}  // namespace felt
