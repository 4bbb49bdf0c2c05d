#pragma once

#include <QPointF>
#include <QPointer>
#include <QWindow>
#include <memory>

#include "desktop/canvas/canvas.h"

class QPointingDevice;

namespace felt::desktop {

/// A tablet that is visible to Qt only. Its events enter Qt at the same interface as those of the
/// window system, and pass through all of Qt's event handling. Positions are in pixels of the
/// canvas. Use from one thread only.
class InjectedPen {
 public:
  /// Requires that the window of `canvas` is shown. `canvas` must outlive this object.
  explicit InjectedPen(Canvas& canvas);
  ~InjectedPen();

  /// Sets which end of the pen later events use: the eraser end or the tip.
  void turn_over(bool eraser);
  /// Moves the pen to `px`, on the tablet if `pressure` > 0, otherwise above it. `side` gives the
  /// pressed buttons on the side of the pen.
  void point(QPointF px, double pressure, Qt::MouseButtons side = Qt::NoButton);

 private:
  QWindow* window_;
  QPointF origin_;         // origin of the canvas in the window
  QPointF window_origin_;  // origin of the window on the screen
  std::unique_ptr<QPointingDevice> tip_, eraser_;
  bool is_turned_ = false;
};

}  // namespace felt::desktop
