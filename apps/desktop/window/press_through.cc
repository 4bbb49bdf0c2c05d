#include "desktop/window/press_through.h"

#include <QApplication>
#include <QMenu>
#include <QMenuBar>
#include <QMouseEvent>
#include <QTabletEvent>
#include <QToolButton>
#include <QWindow>

namespace felt::desktop {
namespace {

/// Returns true if the pop-up was opened by this control or by a part of it.
bool is_opener(const QWidget* control, const QWidget& popup) {
  for (; control && !control->isWindow(); control = control->parentWidget()) {
    if (control == popup.parentWidget()) return true;
    const auto* button = qobject_cast<const QToolButton*>(control);
    if (button && button->menu() == &popup) return true;
  }
  return false;
}

/// Returns the lowest of the open pop-ups: the menu to which the open submenus belong.
const QWidget& root_of(const QWidget& popup) {
  const QWidget* root = &popup;
  while (const auto* parent = qobject_cast<const QMenu*>(root->parentWidget())) {
    if (!parent->isVisible()) break;
    root = parent;
  }
  return *root;
}

/// Closes all pop-ups. Qt must not send the press once more, as it does on some platforms.
void close_popups() {
  while (QWidget* popup = QApplication::activePopupWidget()) {
    popup->setAttribute(Qt::WA_NoMouseReplay);
    popup->close();
    if (popup == QApplication::activePopupWidget()) return;  // it refuses
  }
}

}  // namespace

PressThrough::PressThrough(QWidget& window) : QObject(&window), window_(window) {
  qApp->installEventFilter(this);
}

bool PressThrough::is_ours(const QWidget& popup) const {
  const QObject* object = &popup;
  while (object && object != &window_) object = object->parent();
  return object != nullptr;
}

bool PressThrough::eventFilter(QObject* watched, QEvent* event) {
  const bool presses =
      event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick;
  // The first widget that gets the press of a pen gets all that follows, so it must not be the
  // pop-up.
  const bool touches = event->type() == QEvent::TabletPress;
  if (!(presses && watched->isWidgetType()) && !(touches && watched->isWindowType())) return false;
  const QWidget* popup = QApplication::activePopupWidget();
  return popup && is_ours(*popup) && pass_on(static_cast<QSinglePointEvent&>(*event));
}

/// Closes the pop-ups and sends the press to the window at its position. Returns false if the press
/// is for the pop-ups.
bool PressThrough::pass_on(QSinglePointEvent& press) {
  const QPoint global = press.globalPosition().toPoint();
  const QWidget& popup = *QApplication::activePopupWidget();
  if (popup.rect().contains(popup.mapFromGlobal(global))) return false;
  QWidget* target = QApplication::widgetAt(global);
  if (!target || target->window()->windowType() == Qt::Popup) return false;
  if (qobject_cast<QMenuBar*>(target) || is_opener(target, root_of(popup))) return false;
  const QWidget* modal = QApplication::activeModalWidget();
  if (modal && target->window() != modal) return false;
  QWindow* window = target->window()->windowHandle();
  if (!window) return false;
  close_popups();
  const QPointF local = window->mapFromGlobal(press.globalPosition());
  if (press.type() == QEvent::TabletPress) {
    const auto& pen = static_cast<const QTabletEvent&>(press);
    QTabletEvent copy(QEvent::TabletPress, pen.pointingDevice(), local, pen.globalPosition(),
                      pen.pressure(), static_cast<float>(pen.xTilt()),
                      static_cast<float>(pen.yTilt()), static_cast<float>(pen.tangentialPressure()),
                      pen.rotation(), static_cast<float>(pen.z()), pen.modifiers(), pen.button(),
                      pen.buttons());
    copy.setTimestamp(pen.timestamp());
    QApplication::sendEvent(window, &copy);
    press.setAccepted(copy.isAccepted());
    return true;
  }
  const auto& mouse = static_cast<const QMouseEvent&>(press);
  QMouseEvent copy(QEvent::MouseButtonPress, local, local, mouse.globalPosition(), mouse.button(),
                   mouse.buttons(), mouse.modifiers(), mouse.source(), mouse.pointingDevice());
  copy.setTimestamp(mouse.timestamp());
  QApplication::sendEvent(window, &copy);
  return true;
}

}  // namespace felt::desktop
