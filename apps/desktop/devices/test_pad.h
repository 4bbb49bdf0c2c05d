#pragma once

#include <QWidget>
#include <deque>
#include <memory>

#include "desktop/engine/studio.h"

namespace felt::desktop {

/// A piece of paper to try a device on: a loop of its own, so that nothing comes of it in the
/// drawing. Only for devices that mouse and tablet lead; runs while it is seen.
class TestPad : public QWidget {
  Q_OBJECT

 public:
  explicit TestPad(QWidget* parent = nullptr);

  /// Another device, and how strong its forces shall be. Empty: none, the pad only says so.
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
             std::optional<double> lean_deg = {});
  void follow();
  void open();

  QString device_id_;
  double strength_ = 1.0;
  double limit_n_ = 3.0;
  std::unique_ptr<Studio> studio_;
  std::deque<Spot> trail_;
};

}  // namespace felt::desktop
