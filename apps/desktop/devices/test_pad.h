#pragma once

#include <QWidget>
#include <deque>
#include <memory>

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// An area in which the user tries a device. It has its own studio and haptic loop, so that the
/// drawing is not affected. It works only with devices that mouse or tablet move. The loop runs
/// while the area is visible.
class TestPad : public QWidget {
  Q_OBJECT

 public:
  explicit TestPad(QWidget* parent = nullptr);

  /// Sets the device and the strength of its forces. If the id is empty, the pad does nothing and
  /// asks the user to try the device on the page itself.
  void use(const QString& device_id, double strength, double limit_n);
  [[nodiscard]] Studio* studio() noexcept { return studio_.get(); }

  [[nodiscard]] QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override { take(event); }
  void mouseMoveEvent(QMouseEvent* event) override { take(event); }
  void mouseReleaseEvent(QMouseEvent* event) override { take(event); }
  void tabletEvent(QTabletEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  struct Spot {
    QPointF px;
    double width_px;
    bool touches;
  };
  void take(QMouseEvent* event);
  void point(QPointF px, bool touches, std::optional<double> pressure,
             std::optional<double> tilt_deg = {});
  void follow();
  void open();

  QString device_id_;
  double strength_ = 1.0;
  double limit_n_ = 3.0;
  std::unique_ptr<Studio> studio_;
  std::deque<Spot> trail_;
};

}  // namespace felt::desktop
