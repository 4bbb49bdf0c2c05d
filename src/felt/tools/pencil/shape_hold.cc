#include "felt/tools/pencil/shape_hold.h"

#include <algorithm>

#include "felt/tools/gesture_tool.h"

namespace felt {
namespace {

/// The pressure grows at the touch; this part of a line does not count.
constexpr double kTouchS = 0.15;
/// Share of the newest sample in the pressure of the resting pen.
constexpr double kSmoothing = 0.05;

/// Returns the path up to where the rest began: a resting pen trembles, which is not a part of the
/// shape.
std::span<const Point> before_rest(std::span<const Point> path, Point rest) noexcept {
  std::size_t count = path.size();
  while (count > 0 && distance(path[count - 1], rest) <= RestWatch::kRestMm) --count;
  return path.first(std::min(count + 1, path.size()));
}

}  // namespace

void ShapeHold::begin(Point pen, std::int64_t time_ns) noexcept {
  rest_.begin(pen, time_ns);
  was_asked_ = false;
  shapes_.clear();
  accepted_.reset();
  start_ns_ = time_ns;
  low_ = 1.0;
  high_ = 0.0;
  has_pressure_ = false;
}

void ShapeHold::watch_pressure(std::optional<double> pressure, std::int64_t time_ns) noexcept {
  if (!pressure) return;
  if (!has_pressure_) resting_ = *pressure;
  has_pressure_ = true;
  if (!shapes_.empty()) return;
  resting_ += kSmoothing * (*pressure - resting_);
  if (seconds_between(start_ns_, time_ns, 1.0) < kTouchS) return;
  low_ = std::min(low_, *pressure);
  high_ = std::max(high_, *pressure);
}

bool ShapeHold::is_accepted_by(std::optional<double> pressure) const noexcept {
  // The pressure of a pen that goes on drawing changes for other reasons.
  if (!rest_.rests()) return false;
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
    if (distance(pen, held_) > kLeaveMm) {
      shapes_.clear();
    } else if (is_accepted_by(pressure)) {
      accepted_ = 0;
    }
  }
  if (!rest_.rests()) was_asked_ = false;
  if (!rest_.rests() || was_asked_ || !shapes_.empty()) return;
  was_asked_ = true;
  shapes_ = guess_shapes(before_rest(path, rest_.at()));
  held_ = rest_.at();
  offered_s_ = rest_.still_s();
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
