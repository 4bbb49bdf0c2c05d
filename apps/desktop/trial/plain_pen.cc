#include "desktop/trial/plain_pen.h"

#include <QApplication>
#include <QMouseEvent>
#include <QTabletEvent>

namespace felt::desktop {

PlainPen::PlainPen(Canvas& canvas)
    : QObject(&canvas), canvas_(canvas), input_(*new PenInput(canvas)) {
  // Called before the filter of input_, which is a filter of the application, too.
  qApp->installEventFilter(this);
}

void PlainPen::pass_mouse(const QMouseEvent& event) {
  const bool is_left = event.button() == Qt::LeftButton;
  const bool is_move = event.type() == QEvent::MouseMove;
  if (!is_move && !is_left) return;
  QMouseEvent plain(event.type(), event.position(), event.scenePosition(), event.globalPosition(),
                    event.button(), event.buttons() & Qt::LeftButton, Qt::NoModifier,
                    event.pointingDevice());
  plain.setTimestamp(event.timestamp());
  if (event.source() != Qt::MouseEventNotSynthesized) return;
  input_.eventFilter(&canvas_, &plain);
}

void PlainPen::pass_tablet(const QTabletEvent& event) {
  if (event.pointerType() == QPointingDevice::PointerType::Eraser) return;
  const bool is_tip = event.button() == Qt::LeftButton;
  if (event.type() != QEvent::TabletMove && !is_tip) return;
  QTabletEvent plain(event.type(), event.pointingDevice(), event.position(), event.globalPosition(),
                     event.pressure(), static_cast<float>(event.xTilt()),
                     static_cast<float>(event.yTilt()),
                     static_cast<float>(event.tangentialPressure()), event.rotation(),
                     static_cast<float>(event.z()), Qt::NoModifier, event.button(),
                     event.buttons() & Qt::LeftButton);
  plain.setTimestamp(event.timestamp());
  input_.eventFilter(&canvas_, &plain);
}

bool PlainPen::eventFilter(QObject* watched, QEvent* event) {
  if (watched != &canvas_) return false;
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseMove:
      pass_mouse(static_cast<QMouseEvent&>(*event));
      return true;
    case QEvent::TabletPress:
    case QEvent::TabletRelease:
    case QEvent::TabletMove:
      pass_tablet(static_cast<QTabletEvent&>(*event));
      event->accept();  // otherwise Qt makes a mouse event of it
      return true;
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
    case QEvent::TouchCancel:
      event->accept();
      return true;
    case QEvent::Wheel:
    case QEvent::NativeGesture:
    case QEvent::ContextMenu:
      return true;
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
      event->ignore();  // goes to the window
      return true;
    default:
      return false;
  }
}

}  // namespace felt::desktop
