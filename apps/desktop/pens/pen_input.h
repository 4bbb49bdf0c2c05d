#pragma once

#include <QObject>

#include "desktop/canvas/canvas.h"

namespace felt::desktop {

/// Mouse, tablet, touch and keys over a canvas, as a hand: an event filter that turns them into
/// Studio::point(), and into panning, zooming and turning of the view. The canvas must outlive it.
class PenInput : public QObject {
  Q_OBJECT

 public:
  explicit PenInput(Canvas& canvas);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void point(QPointF px, bool touching, std::optional<double> pressure, std::uint32_t buttons);

  Canvas& canvas_;
};

}  // namespace felt::desktop
