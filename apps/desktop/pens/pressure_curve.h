#pragma once

#include <QPointF>

namespace felt::desktop {

/// What a person makes of a tablet's pressure: a cubic from (0, 0) to (1, 1), whose two handles lie
/// in the unit square, so that it never falls; below a threshold the pen does not touch. A value.
class PressureCurve {
 public:
  static constexpr double kMostThreshold = 0.5;
  static constexpr QPointF kFirstStraight{1.0 / 3.0, 1.0 / 3.0};
  static constexpr QPointF kSecondStraight{2.0 / 3.0, 2.0 / 3.0};

  PressureCurve() = default;
  /// Clamps what it is given.
  PressureCurve(QPointF first, QPointF second, double threshold);
  /// As the settings say; and into them.
  static PressureCurve load();
  void store() const;
  /// -1 (soft: a light hand draws wide) over 0 (straight) to 1 (firm), with this threshold.
  static PressureCurve of_firmness(double firmness, double threshold);

  [[nodiscard]] QPointF first() const noexcept { return first_; }
  [[nodiscard]] QPointF second() const noexcept { return second_; }
  [[nodiscard]] double threshold() const noexcept { return threshold_; }
  /// Of the curve that lies nearest to this one among those of of_firmness().
  [[nodiscard]] double firmness() const noexcept;

  /// 0..1 to 0..1; not less where `raw` is not less. NaN is 0.
  [[nodiscard]] double operator()(double raw) const noexcept;
  /// Hard enough to touch.
  [[nodiscard]] bool touches(double raw) const noexcept;

  friend bool operator==(const PressureCurve&, const PressureCurve&) = default;

 private:
  QPointF first_ = kFirstStraight;
  QPointF second_ = kSecondStraight;
  double threshold_ = 0.0;
};

}  // namespace felt::desktop
