#pragma once

#include <QPointF>
#include <QSizeF>
#include <QTransform>

#include "felt/geometry/point.h"
#include "felt/geometry/rect.h"

namespace felt::desktop {

/// The view of the page: the point in the middle of the widget, scale, rotation and mirroring.
/// Widget coordinates are in device-independent pixels. Changing the view is not an edit and cannot
/// be undone; a file stores the view as a Viewport. A value type.
class CanvasView {
 public:
  static constexpr double kMinPxPerMm = 0.02;
  static constexpr double kMaxPxPerMm = 400.0;

  [[nodiscard]] Point to_mm(QPointF px) const;
  [[nodiscard]] QPointF to_px(Point mm) const;
  /// Returns the transform from mm to widget pixels: mirroring, rotation and scale.
  [[nodiscard]] QTransform transform() const;
  [[nodiscard]] double px_per_mm() const noexcept { return px_per_mm_; }
  /// Returns the clockwise angle by which the page is turned on the screen, -180..180 degrees. The
  /// page is mirrored first and then turned.
  [[nodiscard]] double angle_deg() const noexcept { return angle_deg_; }
  [[nodiscard]] bool is_mirrored() const noexcept { return mirrored_; }
  /// Returns the bounding box of the visible area in page coordinates, in mm.
  [[nodiscard]] Rect visible_mm() const;

  void set_size(QSizeF px) { size_ = px; }
  [[nodiscard]] QSizeF size() const noexcept { return size_; }
  void pan(QPointF px);
  /// Zooms so that the point of the page under `at` keeps its position on the screen. Ignores
  /// factors that are not positive.
  void zoom(double factor, QPointF at);
  void turn(double degrees, QPointF at);
  void set_angle(double degrees);
  /// Mirrors the visible picture about the vertical line through the middle of the widget: swaps
  /// left and right, and negates the rotation.
  void mirror();
  /// Fits the rectangle into the widget with a margin; keeps the rotation.
  void fit(const Rect& mm, double margin_px = 24.0);
  /// Sets the scale. If the scale equals the screen's pixels per mm, the page is shown in life
  /// size.
  void set_scale(double px_per_mm);
  void center_on(Point mm) { center_ = mm; }

  friend bool operator==(const CanvasView&, const CanvasView&) = default;

 private:
  QSizeF size_{640, 480};
  Point center_{148.5, 105.0};  // the point in the middle of the widget
  double px_per_mm_ = 4.0;
  double angle_deg_ = 0.0;
  bool mirrored_ = false;
};

}  // namespace felt::desktop
