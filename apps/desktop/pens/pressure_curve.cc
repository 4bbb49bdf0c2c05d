#include "desktop/pens/pressure_curve.h"

#include <algorithm>
#include <cmath>

#include "desktop/engine/settings.h"
#include "desktop/pens/pen_setting_keys.h"

namespace felt::desktop {
namespace {

/// Distance of the handles from the diagonal for the softest or firmest curve.
constexpr double kMaxBend = 0.3;
constexpr int kHalvings = 40;  // steps of the bisection for the curve's parameter; the result is
                               // more precise than any tablet

QPointF in_square(QPointF p) {
  const auto inside = [](double v, double otherwise) {
    return std::isfinite(v) ? std::clamp(v, 0.0, 1.0) : otherwise;
  };
  return {inside(p.x(), 0.5), inside(p.y(), 0.5)};
}

double cubic(double a, double b, double t) {
  const double u = 1.0 - t;
  return 3.0 * u * u * t * a + 3.0 * u * t * t * b + t * t * t;
}

}  // namespace

PressureCurve::PressureCurve(QPointF first, QPointF second, double threshold)
    : first_(in_square(first)),
      second_(in_square(second)),
      threshold_(std::isfinite(threshold) ? std::clamp(threshold, 0.0, kMaxThreshold) : 0.0) {}

PressureCurve PressureCurve::load() {
  const Settings& settings = Settings::the();
  const auto number = [&settings](const char* key, double fallback) {
    return settings.number(QString::fromLatin1(key), fallback);
  };
  return {{number(pen_keys::kFirstHandleX, kFirstStraight.x()),
           number(pen_keys::kFirstHandleY, kFirstStraight.y())},
          {number(pen_keys::kSecondHandleX, kSecondStraight.x()),
           number(pen_keys::kSecondHandleY, kSecondStraight.y())},
          number(pen_keys::kThreshold, pen_keys::kThresholdDefault)};
}

void PressureCurve::store() const {
  const auto set = [](const char* key, double value) {
    Settings::the().set(QString::fromLatin1(key), value);
  };
  set(pen_keys::kFirstHandleX, first_.x());
  set(pen_keys::kFirstHandleY, first_.y());
  set(pen_keys::kSecondHandleX, second_.x());
  set(pen_keys::kSecondHandleY, second_.y());
  set(pen_keys::kThreshold, threshold_);
}

PressureCurve PressureCurve::of_firmness(double firmness, double threshold) {
  const double bend = kMaxBend * std::clamp(firmness, -1.0, 1.0);
  const QPointF off(bend, -bend);
  return {kFirstStraight + off, kSecondStraight + off, threshold};
}

double PressureCurve::firmness() const noexcept {
  const QPointF off = (first_ - kFirstStraight) + (second_ - kSecondStraight);
  return std::clamp((off.x() - off.y()) / (4.0 * kMaxBend), -1.0, 1.0);
}

bool PressureCurve::touches(double raw) const noexcept {
  return threshold_ == 0.0 || raw > threshold_;
}

double PressureCurve::operator()(double raw) const noexcept {
  if (!(raw > threshold_)) return 0.0;
  if (raw >= 1.0) return 1.0;
  const double x = (raw - threshold_) / (1.0 - threshold_);
  double low = 0.0, high = 1.0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (cubic(first_.x(), second_.x(), middle) < x ? low : high) = middle;
  }
  return std::clamp(cubic(first_.y(), second_.y(), high), 0.0, 1.0);
}

}  // namespace felt::desktop
