#include "desktop/pens/pen_input.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QMouseEvent>
#include <QTabletEvent>
#include <QTouchEvent>
#include <QWheelEvent>
#include <cmath>

#include "desktop/engine/settings.h"

namespace felt::desktop {
namespace {

/// Distances by which an arrow key moves the selected lines: with Ctrl, alone, with Shift.
constexpr double kFineNudgeMm = 0.1, kNudgeMm = 1.0, kCoarseNudgeMm = 10.0;

bool is_touchpad(const QTouchEvent& event) {
  return event.device() && event.device()->type() == QInputDevice::DeviceType::TouchPad;
}

}  // namespace

bool is_made_up(const QMouseEvent& event) {
  if (event.source() != Qt::MouseEventNotSynthesized) return true;
  const QPointingDevice* device = event.pointingDevice();
  return device && (device->type() == QInputDevice::DeviceType::Stylus ||
                    device->type() == QInputDevice::DeviceType::TouchScreen);
}

PenInput::PenInput(Canvas& canvas)
    : QObject(&canvas),
      canvas_(canvas),
      hand_(canvas),
      drag_(canvas),
      tablet_(canvas, hand_, drag_, settings_),
      touch_(canvas, hand_, settings_),
      mouse_(canvas, hand_, drag_, settings_),
      keys_(canvas, hand_),
      press_(canvas, hand_, settings_) {
  canvas.setTabletTracking(true);
  canvas.installEventFilter(this);
  qApp->installEventFilter(this);  // a tablet's proximity events go to the application
  connect(&tablet_, &TabletInput::came, &touch_, &TouchInput::cancel);
  connect(&tablet_, &TabletInput::pressure_seen_changed, this, &PenInput::say_pressure);
  connect(&press_, &LongPress::held, this, &PenInput::open_ring);
  connect(&keys_, &KeyboardPen::said, &canvas,
          [this](const QString& text) { canvas_.setAccessibleDescription(text); });
  connect(&Settings::the(), &Settings::changed, this, [this](const QString& key) {
    if (key.startsWith(QStringLiteral("pens/"))) load_settings();
  });
  load_settings();
}

void PenInput::load_settings() {
  settings_ = PenSettings::load();
  canvas_.studio().loop().set_mouse_pressure(settings_.mouse);
  canvas_.set_right_button(settings_.right == ButtonRole::kNone ? QString()
                                                                : label_of(settings_.right));
  say_pressure();
}

void PenInput::say_pressure() {
  if (!settings_.pressure_on) return canvas_.set_pen_status(tr("Pressure is switched off."));
  switch (tablet_.pressure_seen()) {
    case TabletInput::Pressure::kSeen:
      return canvas_.set_pen_status(tr("The pressure of your pen is recognised."));
    case TabletInput::Pressure::kNone:
      return canvas_.set_pen_status(tr("Your pen senses no pressure."));
    case TabletInput::Pressure::kNotSeen:
      return canvas_.set_pen_status({});
  }
}

/// Handles a long press: discards what it drew, and ignores the rest of the touch.
void PenInput::open_ring(QPointF px) {
  touch_.cancel();
  tablet_.cancel();
  canvas_.studio().apply(CancelEvent{});  // the pen of a device
  Q_EMIT canvas_.ring_pressed(px);
}

bool PenInput::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::TabletLeaveProximity && watched == qApp) {
    tablet_.leave();
    return false;
  }
  if (watched != &canvas_) return false;
  switch (event->type()) {
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
      return take_keys(event);
    case QEvent::FocusOut:
    case QEvent::WindowDeactivate:
    case QEvent::Hide:
      release_all();
      return false;
    case QEvent::Leave:
      // Qt does not send this event while a button is held. If the pen is still down, its release
      // was lost.
      if (hand_.is_down(PenHand::Source::kMouse)) release_all();
      canvas_.set_pen_visible(hand_.is_down());
      return false;
    case QEvent::Enter:
      come(static_cast<QEnterEvent&>(*event).position());
      take_focus();
      return false;
    default:
      return take_pointer(event);
  }
}

/// Handles a pointer that enters the canvas. Needed because no move event arrives if the window
/// opens under a resting pointer.
void PenInput::come(QPointF px) {
  const std::int64_t now_ns = canvas_.studio().now_ns();
  if (!hand_.is_known()) hand_.point(PenHand::Source::kMouse, px, now_ns, false, {});
  canvas_.set_pen_visible(true);
}

/// Moves the focus to the canvas when the pointer enters it, also after a click on a medium or a
/// slider, so that the canvas's keys work (Space, Shift, the letters of the tools). The focus
/// stays if the user is typing text.
void PenInput::take_focus() {
  QWidget* focus = QApplication::focusWidget();
  if (!focus || focus == &canvas_ || focus->window() != canvas_.window()) return;
  const bool is_number = qobject_cast<QAbstractSpinBox*>(focus) != nullptr;
  if (!is_number && focus->testAttribute(Qt::WA_InputMethodEnabled)) return;
  canvas_.setFocus(Qt::MouseFocusReason);
}

bool PenInput::take_pointer(QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseMove: {
      const auto& mouse = static_cast<QMouseEvent&>(*event);
      if (is_made_up(mouse)) return true;
      hand_.set_keys(mouse.modifiers());
      keys_.stop_leading();
      canvas_.set_tablet_in_hand(false);
      mouse_.take(mouse);
      // On a press, the widget itself takes the focus.
      return event->type() != QEvent::MouseButtonPress;
    }
    case QEvent::TabletPress:
    case QEvent::TabletRelease:
    case QEvent::TabletMove: {
      const auto& tablet = static_cast<QTabletEvent&>(*event);
      if (event->type() == QEvent::TabletPress) canvas_.setFocus(Qt::MouseFocusReason);
      canvas_.set_pen_visible(true);
      hand_.set_keys(tablet.modifiers());
      canvas_.set_tablet_in_hand(true);
      tablet_.take(tablet);
      event->accept();
      return true;
    }
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::TouchEnd:
    case QEvent::TouchCancel: {
      const auto& touch = static_cast<QTouchEvent&>(*event);
      if (is_touchpad(touch)) return false;
      touch_.take(touch, tablet_.is_near());
      event->accept();
      return true;
    }
    case QEvent::Wheel:
      mouse_.take(static_cast<QWheelEvent&>(*event));
      return true;
    case QEvent::NativeGesture:
      return mouse_.take(static_cast<QNativeGestureEvent&>(*event));
    default:
      return false;
  }
}

bool PenInput::take_keys(QEvent* event) {
  auto& key = static_cast<QKeyEvent&>(*event);
  if (event->type() == QEvent::ShortcutOverride) {
    // While the canvas has the focus, the pen's keys must not trigger shortcuts.
    const bool ours = key.key() == Qt::Key_Space || nudge_of(key) || keys_.wants(key);
    if (ours) event->accept();
    return ours;
  }
  return event->type() == QEvent::KeyPress ? press_key(key) : release_key(key);
}

bool PenInput::press_key(QKeyEvent& event) {
  if (event.key() == Qt::Key_Space) {
    space_ = true;
    offer_drag(event.modifiers());
    return true;
  }
  if (nudge(event)) return true;
  if (keys_.press(event)) return true;
  // event.modifiers() are the modifiers before the key was pressed or released, so the key itself
  // is added or removed.
  Qt::KeyboardModifiers held = event.modifiers();
  if (event.key() == Qt::Key_Shift) held |= Qt::ShiftModifier;
  if (event.key() == Qt::Key_Control) held |= Qt::ControlModifier;
  if (event.key() == Qt::Key_Alt) held |= Qt::AltModifier;
  use_modifiers(held);
  return false;
}

/// Returns the offset by which an arrow key moves the selected lines, in mm, or nullopt if it does
/// not move them: if no line is selected, or if the arrow keys move the pen.
std::optional<Vec> PenInput::nudge_of(const QKeyEvent& event) const {
  QPointF way;
  if (event.key() == Qt::Key_Left) way = {-1, 0};
  if (event.key() == Qt::Key_Right) way = {1, 0};
  if (event.key() == Qt::Key_Up) way = {0, -1};
  if (event.key() == Qt::Key_Down) way = {0, 1};
  const Qt::KeyboardModifiers held = event.modifiers();
  if (way.isNull() || held.testFlag(Qt::AltModifier)) return std::nullopt;
  const bool leads = keys_.is_leading() && !held.testFlag(Qt::ControlModifier);
  if (leads || hand_.is_down() || canvas_.studio().session().selection().empty()) {
    return std::nullopt;
  }
  const double step_mm = held.testFlag(Qt::ControlModifier) ? kFineNudgeMm
                         : held.testFlag(Qt::ShiftModifier) ? kCoarseNudgeMm
                                                            : kNudgeMm;
  const CanvasView& view = canvas_.view();
  const Vec along = normalized(view.to_mm(way) - view.to_mm({0, 0}));
  const auto rounded = [](double mm) { return 1e-6 * std::round(1e6 * mm); };
  return Vec{rounded(step_mm * along.x), rounded(step_mm * along.y)};
}

bool PenInput::nudge(const QKeyEvent& event) {
  const std::optional<Vec> by_mm = nudge_of(event);
  if (by_mm) canvas_.studio().apply(MoveEvent{*by_mm});
  return by_mm.has_value();
}

void PenInput::use_modifiers(Qt::KeyboardModifiers held) {
  const bool sizes = held.testFlag(Qt::ControlModifier) && held.testFlag(Qt::AltModifier);
  if (space_) {
    offer_drag(held);
  } else if (sizes || drag_.offered() == ViewDrag::Kind::kSize) {
    drag_.offer(sizes ? std::optional(ViewDrag::Kind::kSize) : std::nullopt);
  }
  // With the keyboard pen, Shift means small steps and is not a modifier.
  if (hand_.is_down(PenHand::Source::kKeys)) held &= ~Qt::KeyboardModifiers(Qt::ShiftModifier);
  hand_.set_keys(held);
}

bool PenInput::release_key(QKeyEvent& event) {
  if (event.key() == Qt::Key_Space) {
    if (event.isAutoRepeat()) return true;
    space_ = false;
    drag_.offer({});
    return true;
  }
  keys_.release(event);
  Qt::KeyboardModifiers held = event.modifiers();
  if (event.key() == Qt::Key_Shift) held &= ~Qt::KeyboardModifiers(Qt::ShiftModifier);
  if (event.key() == Qt::Key_Control) held &= ~Qt::KeyboardModifiers(Qt::ControlModifier);
  if (event.key() == Qt::Key_Alt) held &= ~Qt::KeyboardModifiers(Qt::AltModifier);
  use_modifiers(held);
  return false;
}

void PenInput::offer_drag(Qt::KeyboardModifiers keys) {
  if (keys.testFlag(Qt::ControlModifier)) return drag_.offer(ViewDrag::Kind::kZoom);
  drag_.offer(keys.testFlag(Qt::ShiftModifier) ? ViewDrag::Kind::kTurn : ViewDrag::Kind::kPan);
}

/// Ends every press, drag and borrowed tool, because no release events will arrive.
void PenInput::release_all() {
  hand_.lift();
  tablet_.release_all();
  mouse_.release_all();
  keys_.release_all();
  keys_.stop_leading();
  hand_.release_all();
  hand_.set_keys(Qt::NoModifier);
  space_ = false;
  drag_.offer({});
}

}  // namespace felt::desktop
