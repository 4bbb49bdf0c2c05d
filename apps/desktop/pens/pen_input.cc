#include "desktop/pens/pen_input.h"

#include <QMouseEvent>
#include <QTabletEvent>
#include <QWheelEvent>
#include <cmath>

namespace felt::desktop {

PenInput::PenInput(Canvas& canvas) : QObject(&canvas), canvas_(canvas) {
  canvas.installEventFilter(this);
}

void PenInput::point(QPointF px, bool touching, std::optional<double> pressure,
                     std::uint32_t buttons) {
  Studio& studio = canvas_.studio();
  studio.point({studio.now_ns(), canvas_.view().to_mm(px), touching, pressure, buttons});
}

bool PenInput::eventFilter(QObject* watched, QEvent* event) {
  if (watched != &canvas_) return false;
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseMove: {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      point(mouse->position(), mouse->buttons().testFlag(Qt::LeftButton), std::nullopt, 0);
      return true;
    }
    case QEvent::TabletPress:
    case QEvent::TabletRelease:
    case QEvent::TabletMove: {
      auto* tablet = static_cast<QTabletEvent*>(event);
      point(tablet->position(), tablet->pressure() > 0.0, tablet->pressure(), 0);
      tablet->accept();
      return true;
    }
    case QEvent::Wheel: {
      const auto* wheel = static_cast<QWheelEvent*>(event);
      CanvasView view = canvas_.view();
      view.zoom(std::exp2(wheel->angleDelta().y() / 480.0), wheel->position());
      canvas_.set_view(view);
      return true;
    }
    default:
      return false;
  }
}

}  // namespace felt::desktop
