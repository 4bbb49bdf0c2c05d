#pragma once

#include <QPointF>
#include <QPointer>
#include <QWindow>
#include <memory>

#include "desktop/canvas/canvas.h"

class QPointingDevice;

namespace felt::desktop {

/// A tablet that exists for Qt only: its events enter where those of the window system do, and take
/// Qt's whole way from there. Places are those of a canvas. Any one thread.
class InjectedPen {
 public:
  /// The canvas' window must be shown. It must outlive this.
  explicit InjectedPen(Canvas& canvas);
  ~InjectedPen();

  /// The eraser end from now on, or the tip.
  void turn_over(bool eraser);
  /// Moves with the tip on the tablet (pressure above 0) or off it. `side`: buttons on its side.
  void point(QPointF px, double pressure, Qt::MouseButtons side = Qt::NoButton);

 private:
  QWindow* window_;
  QPointF origin_;         // of the canvas in the window
  QPointF window_origin_;  // on the screen
  std::unique_ptr<QPointingDevice> tip_, eraser_;
  bool is_turned_ = false;
};

}  // namespace felt::desktop
