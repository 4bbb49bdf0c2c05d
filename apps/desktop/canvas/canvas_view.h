#pragma once

#include <QPointF>
#include <QSizeF>
#include <QTransform>

#include "felt/geometry/point.h"
#include "felt/geometry/rect.h"

namespace felt::desktop {

/// How the sheet is looked at: what lies in the middle of the widget, how large, turned and
/// mirrored. Widget places are in device-independent pixels. No part of the drawing, and of no
/// undo. A value.
class CanvasView {
 public:
  static constexpr double kLeastPxPerMm = 0.02;
  static constexpr double kMostPxPerMm = 400.0;

  [[nodiscard]] Point to_mm(QPointF px) const;
  [[nodiscard]] QPointF to_px(Point mm) const;
  /// From mm to widget pixels: mirror, turn, scale.
  [[nodiscard]] QTransform transform() const;
  [[nodiscard]] double px_per_mm() const noexcept { return px_per_mm_; }
  /// Clockwise as it is seen, -180..180; the sheet is mirrored first.
  [[nodiscard]] double angle_deg() const noexcept { return angle_deg_; }
  [[nodiscard]] bool is_mirrored() const noexcept { return mirrored_; }
  /// Around all of the sheet that the widget shows.
  [[nodiscard]] Rect visible_mm() const;

  void set_size(QSizeF px) { size_ = px; }
  [[nodiscard]] QSizeF size() const noexcept { return size_; }
  void pan(QPointF px);
  /// What is under `at` stays there. Factors that are not positive do nothing.
  void zoom(double factor, QPointF at);
  void turn(double degrees, QPointF at);
  void set_angle(double degrees);
  /// What is seen is mirrored about the middle of the widget: left and right change places, and a
  /// sheet that leant to one side leans to the other.
  void mirror();
  /// All of it is seen, with a margin, as turned as it is.
  void fit(const Rect& mm, double margin_px = 24.0);
  /// 1 is life size on a screen of so many px per mm.
  void set_scale(double px_per_mm);
  void center_on(Point mm) { center_ = mm; }

  friend bool operator==(const CanvasView&, const CanvasView&) = default;

 private:
  QSizeF size_{640, 480};
  Point center_{148.5, 105.0};  // in the middle of the widget
  double px_per_mm_ = 4.0;
  double angle_deg_ = 0.0;
  bool mirrored_ = false;
};

}  // namespace felt::desktop
