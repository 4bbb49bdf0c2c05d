// The kinds of input that the monkey sends.
#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QFileDialog>
#include <QTabletEvent>
#include <QTest>
#include <QWheelEvent>
#include <array>
#include <cmath>

#include "monkey.h"

namespace felt::desktop {
namespace {

/// Returns true for commands that end the program or could overwrite files of the user.
bool is_forbidden(const QString& name) {
  static const std::array<const char*, 15> kNames = {
      "file.quit",      "file.close",         "file.open",           "file.save",
      "file.save_as",   "file.import",        "file.import_picture", "file.export",
      "file.print",     "file.new_window",    "file.print_preview",  "file.timelapse",
      "file.animation", "color.open_palette", "color.save_palette"};
  for (const char* forbidden : kNames) {
    if (name == QLatin1String(forbidden)) return true;
  }
  return name.startsWith(QLatin1String("file.recent")) ||
         name.startsWith(QLatin1String("file.export_solid"));
}

bool is_ours(QWidget* widget) {
  return widget->isVisible() && widget->isEnabled() &&
         !qobject_cast<QFileDialog*>(widget->window());
}

}  // namespace

QPointF Monkey::anywhere() {
  const QSizeF size = window_.canvas().size();
  // Some positions are outside the canvas.
  const double margin = dice_.chance(0.05) ? 200.0 : 0.0;
  return {dice_.between(-margin, size.width() + margin),
          dice_.between(-margin, size.height() + margin)};
}

QWidget* Monkey::any_widget() {
  QWidget* modal = QApplication::activeModalWidget();
  QList<QWidget*> widgets;
  for (QWidget* widget : QApplication::allWidgets()) {
    if (!is_ours(widget) || widget->size().isEmpty()) continue;
    if (modal && !modal->isAncestorOf(widget) && widget != modal) continue;
    widgets.push_back(widget);
  }
  if (widgets.isEmpty()) return nullptr;
  // Sorts the widgets so that their order does not depend on a hash.
  std::sort(widgets.begin(), widgets.end(), [](QWidget* a, QWidget* b) {
    const auto place = [](QWidget* w) {
      const QPoint p = w->mapToGlobal(QPoint(0, 0));
      return std::tuple(p.x(), p.y(), w->width(), w->height(),
                        QString(w->metaObject()->className()));
    };
    return place(a) < place(b);
  });
  return widgets[static_cast<qsizetype>(dice_.pick(static_cast<std::size_t>(widgets.size())))];
}

void Monkey::mouse(QEvent::Type type, QPointF at, Qt::MouseButton button, Qt::MouseButtons held) {
  Canvas& canvas = window_.canvas();
  QMouseEvent event(type, at, QPointF(canvas.mapToGlobal(at.toPoint())), button, held,
                    QApplication::keyboardModifiers());
  QApplication::sendEvent(&canvas, &event);
}

void Monkey::tablet(QEvent::Type type, QPointF at, double pressure, bool eraser) {
  Canvas& canvas = window_.canvas();
  QTabletEvent event(type, eraser ? &eraser_ : &pen_, at, QPointF(canvas.mapToGlobal(at.toPoint())),
                     pressure, 0, 0, 0, 0, 0, Qt::NoModifier,
                     type == QEvent::TabletMove ? Qt::NoButton : Qt::LeftButton,
                     pressure > 0.0 ? Qt::LeftButton : Qt::NoButton);
  QApplication::sendEvent(&canvas, &event);
}

void Monkey::stroke() {
  QPointF at = anywhere(), speed(dice_.between(-9, 9), dice_.between(-9, 9));
  const Qt::MouseButton button = dice_.chance(0.9)   ? Qt::LeftButton
                                 : dice_.chance(0.5) ? Qt::RightButton
                                                     : Qt::MiddleButton;
  mouse(QEvent::MouseMove, at, Qt::NoButton, Qt::NoButton);
  mouse(QEvent::MouseButtonPress, at, button, button);
  const int moves = dice_.pick(0, 30);
  for (int i = 0; i < moves; ++i) {
    speed += QPointF(dice_.between(-3, 3), dice_.between(-3, 3));
    at += speed;
    mouse(QEvent::MouseMove, at, Qt::NoButton, button);
    if (i % 4 == 0) QTest::qSleep(1);  // the haptic loop runs meanwhile
    if (i % 8 == 0) window_.studio().process();
  }
  // In 5 % of the cases the button is never released.
  if (dice_.chance(0.95)) mouse(QEvent::MouseButtonRelease, at, button, Qt::NoButton);
}

void Monkey::pen_event() {
  static constexpr std::array<QEvent::Type, 6> kTypes = {
      QEvent::MouseMove,   QEvent::MouseButtonPress, QEvent::MouseButtonRelease,
      QEvent::TabletPress, QEvent::TabletMove,       QEvent::TabletRelease};
  const QEvent::Type type = dice_.any(kTypes);
  if (type == QEvent::MouseMove || type == QEvent::MouseButtonPress ||
      type == QEvent::MouseButtonRelease) {
    mouse(type, anywhere(), type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
          dice_.chance(0.5) ? Qt::LeftButton : Qt::NoButton);
  } else {
    const double pressure = dice_.chance(0.1) ? std::nan("") : dice_.between(-0.2, 1.3);
    tablet(type, anywhere(), pressure, dice_.chance(0.2));
  }
}

void Monkey::tablet_stroke() {
  const bool eraser = dice_.chance(0.15);
  QPointF at = anywhere(), speed(dice_.between(-6, 6), dice_.between(-6, 6));
  double pressure = dice_.between(0.0, 0.5);
  tablet(QEvent::TabletPress, at, pressure, eraser);
  const int moves = dice_.pick(0, 60);
  for (int i = 0; i < moves; ++i) {
    speed += QPointF(dice_.between(-2, 2), dice_.between(-2, 2));
    at += speed;
    pressure = std::clamp(pressure + dice_.between(-0.1, 0.1), 0.0, 1.0);
    tablet(QEvent::TabletMove, at, pressure, eraser);
    if (i % 6 == 0) QTest::qSleep(1);
  }
  if (dice_.chance(0.95)) tablet(QEvent::TabletRelease, at, 0.0, eraser);
}

void Monkey::press_key() {
  static constexpr std::array<Qt::Key, 45> kKeys = {
      Qt::Key_A,        Qt::Key_C,     Qt::Key_D,      Qt::Key_E,           Qt::Key_H,
      Qt::Key_I,        Qt::Key_M,     Qt::Key_P,      Qt::Key_S,           Qt::Key_T,
      Qt::Key_V,        Qt::Key_W,     Qt::Key_X,      Qt::Key_Y,           Qt::Key_Z,
      Qt::Key_1,        Qt::Key_2,     Qt::Key_3,      Qt::Key_4,           Qt::Key_5,
      Qt::Key_6,        Qt::Key_Plus,  Qt::Key_Minus,  Qt::Key_BracketLeft, Qt::Key_BracketRight,
      Qt::Key_Left,     Qt::Key_Right, Qt::Key_Up,     Qt::Key_Down,        Qt::Key_Return,
      Qt::Key_Escape,   Qt::Key_Space, Qt::Key_Tab,    Qt::Key_Delete,      Qt::Key_Backspace,
      Qt::Key_Home,     Qt::Key_End,   Qt::Key_PageUp, Qt::Key_Shift,       Qt::Key_Control,
      Qt::Key_Question, Qt::Key_F11,   Qt::Key_U,      Qt::Key_Menu,        Qt::Key_Alt};
  const Qt::Key key = dice_.any(kKeys);
  Qt::KeyboardModifiers with;
  if (dice_.chance(0.2)) with |= Qt::ShiftModifier;
  // Skips shortcuts that reach files. Only the allowed actions may do that.
  const bool reaches_files = key == Qt::Key_S || key == Qt::Key_P || key == Qt::Key_W ||
                             key == Qt::Key_E || key == Qt::Key_I;
  if (!reaches_files && dice_.chance(0.2)) with |= Qt::ControlModifier;
  QWidget* target = QApplication::focusWidget();
  if (!target || dice_.chance(0.5)) target = &window_.canvas();
  if (QWidget* modal = QApplication::activeModalWidget()) target = modal;
  if (!is_ours(target)) return;
  const QPointer<QWidget> alive = target;
  QTest::sendKeyEvent(QTest::Press, target, key, QString(), with);
  if (alive && dice_.chance(0.95)) QTest::sendKeyEvent(QTest::Release, alive, key, QString(), with);
}

void Monkey::trigger_action() {
  const QList<QAction*>& all = window_.actions().all();
  if (all.isEmpty() || QApplication::activeModalWidget()) return;
  QAction* action = all[static_cast<qsizetype>(dice_.pick(static_cast<std::size_t>(all.size())))];
  if (is_forbidden(action->objectName()) || !action->isEnabled()) return;
  doing_ = "action " + action->objectName().toStdString();
  action->trigger();
}

void Monkey::click_widget() {
  const QPointer<QWidget> widget = any_widget();
  if (!widget || widget->window()->inherits("QFileDialog")) return;
  doing_ = std::string("click ") + widget->metaObject()->className();
  const QPoint at(dice_.pick(0, widget->width() - 1), dice_.pick(0, widget->height() - 1));
  if (auto* button = qobject_cast<QAbstractButton*>(widget.data())) {
    // Skips buttons of dialogs that could choose files.
    if (button->objectName().startsWith(QLatin1String("qt_")) ||
        button->text().contains(QChar(0x2026))) {
      return;
    }
  }
  QMouseEvent press(QEvent::MouseButtonPress, at, QPointF(widget->mapToGlobal(at)), Qt::LeftButton,
                    Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(widget, &press);
  if (!widget) return;
  QMouseEvent release(QEvent::MouseButtonRelease, at, QPointF(widget->mapToGlobal(at)),
                      Qt::LeftButton, Qt::NoButton, Qt::NoModifier);
  QApplication::sendEvent(widget, &release);
}

void Monkey::wheel() {
  QWidget* target = dice_.chance(0.7) ? &window_.canvas() : any_widget();
  if (!target) return;
  const QPointF at(dice_.between(0, target->width()), dice_.between(0, target->height()));
  const int turn = dice_.pick(-480, 480);
  Qt::KeyboardModifiers with;
  if (dice_.chance(0.3)) with |= Qt::ControlModifier;
  if (dice_.chance(0.3)) with |= Qt::ShiftModifier;
  QWheelEvent event(at, target->mapToGlobal(at), QPoint(), QPoint(0, turn), Qt::NoButton, with,
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(target, &event);
}

void Monkey::choose_tool() {
  const auto tools = window_.studio().session().tools();
  // Draws often, because the other inputs have no effect without ink.
  if (dice_.chance(0.4)) {
    window_.studio().apply(SelectTool{"pencil"});
    return;
  }
  window_.studio().apply(SelectTool{std::string(tools[dice_.pick(tools.size())]->info().id)});
}

void Monkey::set_option() {
  const auto& tool = window_.studio().session().tool();
  const auto table = tool.info().options;
  if (table.empty()) return;
  const OptionSpec& row = table[dice_.pick(table.size())];
  OptionValue value = default_value(row);
  if (row.kind == OptionKind::kNumber) value = dice_.between(row.min, row.max);
  if (row.kind == OptionKind::kSwitch) value = dice_.chance(0.5);
  if (row.kind == OptionKind::kChoice) {
    value = std::string(row.choices[dice_.pick(row.choices.size())]);
  }
  window_.studio().apply(
      SetOption{std::string(tool.info().id) + "." + std::string(row.id), std::move(value)});
}

void Monkey::resize() {
  window_.resize(dice_.pick(300, 1900), dice_.pick(250, 1100));
}

void Monkey::switch_device() {
  const std::vector<PenDeviceInfo> devices = pen_devices();
  window_.studio().use_device(devices[dice_.pick(devices.size())].id);
}

void Monkey::leave_and_enter() {
  QEvent leave(dice_.chance(0.5) ? QEvent::Leave : QEvent::WindowDeactivate);
  QApplication::sendEvent(&window_.canvas(), &leave);
  QFocusEvent out(QEvent::FocusOut);
  if (dice_.chance(0.3)) QApplication::sendEvent(&window_.canvas(), &out);
}

void Monkey::wait() {
  QTest::qSleep(dice_.pick(1, 8));
}

void Monkey::close_dialog() {
  steps_in_dialog_ = 0;
  if (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) {
    dialog->reject();
  } else if (QWidget* modal = QApplication::activeModalWidget()) {
    modal->close();
  }
}

}  // namespace felt::desktop
