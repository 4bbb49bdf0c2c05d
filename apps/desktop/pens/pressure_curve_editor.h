#pragma once

#include <QWidget>
#include <optional>

#include "desktop/pens/pressure_curve.h"

namespace felt::desktop {

/// Shows the pressure curve as a plot with two handles. The user drags the handles or moves them
/// with the arrow keys (Space selects the other handle). A dot on the curve shows the pen's present
/// pressure.
class PressureCurveEditor : public QWidget {
  Q_OBJECT

 public:
  explicit PressureCurveEditor(QWidget* parent = nullptr);

  void set_curve(const PressureCurve& curve);
  [[nodiscard]] const PressureCurve& curve() const noexcept { return curve_; }
  /// Sets the tablet's raw pressure, 0..1; 0 hides the dot.
  void show_raw(double raw);
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 Q_SIGNALS:
  /// Emitted when the user edited the curve.
  void edited(const felt::desktop::PressureCurve& curve);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  [[nodiscard]] QRectF square() const;
  [[nodiscard]] QPointF to_px(QPointF unit) const;
  [[nodiscard]] QPointF to_unit(QPointF px) const;
  [[nodiscard]] QPointF handle(int which) const;
  void move_handle(int which, QPointF to);

  PressureCurve curve_;
  double raw_ = 0.0;
  int chosen_ = 0;  // index of the selected handle
  bool drags_ = false;
};

}  // namespace felt::desktop
