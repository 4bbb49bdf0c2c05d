#pragma once

#include <QImage>
#include <QPointF>
#include <QWidget>
#include <optional>

#include "desktop/pens/pen_settings.h"

namespace felt::desktop {

/// An area in which the user tries the settings with mouse or tablet. The width of the lines there
/// depends on the settings. The lines are not part of a drawing.
class PenTestArea : public QWidget {
  Q_OBJECT

 public:
  explicit PenTestArea(QWidget* parent = nullptr);

  void set_settings(const PenSettings& settings) { settings_ = settings; }
  void clear();
  [[nodiscard]] QSize sizeHint() const override;

 Q_SIGNALS:
  /// Emitted for each event of the pen. `raw` is the tablet's pressure before the curve, or nullopt
  /// for a mouse or a pen that does not sense pressure; `curved` is the pressure after the curve.
  /// Both are 0..1, and 0 if the pen does not touch.
  void pressed(std::optional<double> raw, double curved);
  /// Emitted with the angle between the pen and the surface normal, in degrees; nullopt if the pen
  /// does not report its tilt.
  void tilted(std::optional<double> tilt_deg);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void tabletEvent(QTabletEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  void point(QPointF at, bool touching, std::optional<double> raw, std::uint64_t stamp_ms);
  [[nodiscard]] double pressure_of(QPointF at, std::optional<double> raw, std::uint64_t stamp_ms);

  PenSettings settings_;
  QImage ink_;
  std::optional<QPointF> last_;
  double last_width_px_ = 0.0;
  std::uint64_t last_ms_ = 0;
  double speed_px_per_ms_ = 0.0;
  bool is_empty_ = true;
};

}  // namespace felt::desktop
