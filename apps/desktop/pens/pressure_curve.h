#pragma once

#include <QPointF>

namespace felt::desktop {

/// The curve that maps a tablet's pressure to the pressure that the user wants. It is a cubic from
/// corner to corner of the unit square. Its two handles lie in the square, so that the curve never
/// falls. If a threshold is set, the pen counts as touching only while its pressure is above the
/// threshold. A value type.
class PressureCurve {
 public:
  static constexpr double kMaxThreshold = 0.5;
  static constexpr QPointF kFirstStraight{1.0 / 3.0, 1.0 / 3.0};
  static constexpr QPointF kSecondStraight{2.0 / 3.0, 2.0 / 3.0};

  PressureCurve() = default;
  /// Clamps all arguments to their ranges.
  PressureCurve(QPointF first, QPointF second, double threshold);
  /// Loads the curve from the settings. store() stores it in the settings.
  static PressureCurve load();
  void store() const;
  /// Returns the curve for a firmness with this threshold. A firmness of -1 is soft (light
  /// pressure draws wide lines), 0 is a straight line, 1 is firm.
  static PressureCurve of_firmness(double firmness, double threshold);

  [[nodiscard]] QPointF first() const noexcept { return first_; }
  [[nodiscard]] QPointF second() const noexcept { return second_; }
  [[nodiscard]] double threshold() const noexcept { return threshold_; }
  /// Returns the firmness at which of_firmness() is nearest to this curve.
  [[nodiscard]] double firmness() const noexcept;

  /// Maps 0..1 to 0..1, monotonically. NaN gives 0.
  [[nodiscard]] double operator()(double raw) const noexcept;
  /// Returns true if the pressure is high enough to count as contact.
  [[nodiscard]] bool touches(double raw) const noexcept;

  friend bool operator==(const PressureCurve&, const PressureCurve&) = default;

 private:
  QPointF first_ = kFirstStraight;
  QPointF second_ = kSecondStraight;
  double threshold_ = 0.0;
};

}  // namespace felt::desktop
