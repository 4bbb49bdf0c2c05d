#include "desktop/engine/wheel_guard.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QPointer>
#include <QScrollBar>
#include <QToolBar>

namespace felt::desktop {
namespace {

/// Returns true if the wheel would change a value of this widget. A scroll bar only scrolls.
bool has_value(const QWidget& widget) {
  if (qobject_cast<const QScrollBar*>(&widget)) return false;
  return qobject_cast<const QComboBox*>(&widget) ||
         qobject_cast<const QAbstractSpinBox*>(&widget) ||
         qobject_cast<const QAbstractSlider*>(&widget);
}

bool is_in_tool_bar(const QWidget& widget) {
  const QWidget* parent = widget.parentWidget();
  while (parent && !parent->isWindow() && !qobject_cast<const QToolBar*>(parent)) {
    parent = parent->parentWidget();
  }
  return qobject_cast<const QToolBar*>(parent) != nullptr;
}

/// Ignores wheel events on behalf of widgets with a value. Qt then passes them to the parents, of
/// which one may scroll.
class WheelGuard : public QObject {
 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() != QEvent::Wheel || !watched->isWidgetType()) return false;
    const auto& widget = *static_cast<QWidget*>(watched);
    if (!has_value(widget) || is_in_tool_bar(widget)) return false;
    event->ignore();
    return true;
  }
};

}  // namespace

void guard_values_from_wheel() {
  static QPointer<WheelGuard> guard;
  if (guard) return;
  guard = new WheelGuard(qApp);
  qApp->installEventFilter(guard);
}

}  // namespace felt::desktop
