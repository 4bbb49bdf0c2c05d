#include "desktop/pens/mouse_input.h"

#include <QLineF>
#include <algorithm>
#include <cmath>
#include <utility>

namespace felt::desktop {
namespace {

constexpr double kUnitsPerDoubling = 480.0;  // four notches of a wheel
constexpr double kFineUnitsPerDoubling = 1920.0;
constexpr double kPxPerUnit = 0.5;
constexpr double kDegreesPerUnit = 5.0 / 120.0;

/// Returns the position of the pointer with fractions of a pixel. Qt 6.4 rounds position() for
/// child widgets, and sometimes globalPosition(). This would lose every second pixel on a screen
/// of scale 2.
QPointF place_of(const QMouseEvent& event, const QWidget& canvas) {
  for (const QPointF exact : {canvas.mapFrom(canvas.window(), event.scenePosition()),
                              canvas.mapFromGlobal(event.globalPosition())}) {
    const QPointF off = exact - event.position();
    const double far = std::max(std::abs(off.x()), std::abs(off.y()));
    // A synthetic event may contain neither of the two positions, so a position is used only if it
    // agrees with position().
    if (far > 0.0 && far <= 1.0) return exact;
  }
  return event.position();
}

/// Returns true if a button with this role acts when it is pressed, so that it cannot be clicked.
bool acts_at_once(ButtonRole role) {
  return role == ButtonRole::kUndo || role == ButtonRole::kRing ||
         role == ButtonRole::kFirstModifier || role == ButtonRole::kSecondModifier;
}

/// Returns true if a button with this role opens a menu, which handles the release.
bool opens_menu(ButtonRole role) {
  return role == ButtonRole::kPopup || role == ButtonRole::kRing;
}

/// Returns true if the pen draws while a button with this role is held, with a borrowed tool.
bool draws(ButtonRole role) {
  return role == ButtonRole::kEraser || role == ButtonRole::kPull || role == ButtonRole::kLasso;
}

}  // namespace

MouseInput::MouseInput(Canvas& canvas, PenHand& hand, ViewDrag& drag, const PenSettings& settings)
    : canvas_(canvas), hand_(hand), drag_(drag), settings_(settings) {
  hold_.setSingleShot(true);
  hold_.setInterval(kHoldMs);
  connect(&hold_, &QTimer::timeout, this, [this] {
    if (!click_) return;
    const QPointF at = *click_;
    release_all();
    Q_EMIT canvas_.ring_wanted(at);
  });
}

/// Returns true if the event moves the view.
bool MouseInput::drags(const QMouseEvent& event) {
  const bool presses = event.type() == QEvent::MouseButtonPress;
  const bool pans = event.button() == Qt::MiddleButton ||
                    (event.button() == Qt::RightButton && settings_.right == ButtonRole::kPan);
  const bool offered = drag_.offered() && event.button() == Qt::LeftButton;
  if (presses && !drag_.is_on() && (pans || offered) && !hand_.is_down()) {
    dragging_ = event.button();
    drag_.begin(pans ? ViewDrag::Kind::kPan : *drag_.offered(), event.position());
    return true;
  }
  if (dragging_ == Qt::NoButton) return pans;
  drag_.move(event.position());
  if (!event.buttons().testFlag(dragging_)) {
    dragging_ = Qt::NoButton;
    drag_.end();
  }
  return true;
}

void MouseInput::take(const QMouseEvent& event) {
  const std::int64_t time_ns = clock_.time_ns(event.timestamp(), canvas_.studio().now_ns());
  const QPointF at = place_of(event, canvas_);
  const bool right = event.buttons().testFlag(Qt::RightButton);
  const bool left = event.buttons().testFlag(Qt::LeftButton);
  const bool presses =
      event.type() != QEvent::MouseMove && event.type() != QEvent::MouseButtonRelease;
  if (presses && event.button() == Qt::RightButton && !hand_.is_down()) {
    if (settings_.right == ButtonRole::kRing) {
      if (std::exchange(ring_press_, event.timestamp()) == event.timestamp()) return;
      return Q_EMIT canvas_.ring_wanted(at);
    }
    if (!acts_at_once(settings_.right)) {
      click_ = at;
      hold_.start();
    }
  }
  if (!right) ring_press_.reset();
  const bool clicks = click_ && !right;
  if (click_ && (left || QLineF(*click_, at).length() > kClickPx)) hold_right(time_ns);
  if (clicks) click_.reset();
  if (drags(event)) {
    if (clicks) Q_EMIT canvas_.popup_wanted(at);
    return;
  }
  if (right && !click_ && right_held_ == ButtonRole::kNone && !hand_.is_down()) {
    right_held_ = opens_menu(settings_.right) ? ButtonRole::kNone : settings_.right;
    hand_.press(right_held_);
  }
  const bool touching = left || (right && draws(right_held_));
  hand_.point(PenHand::Source::kMouse, at, time_ns, touching, std::nullopt);
  if (!right) hand_.release(std::exchange(right_held_, ButtonRole::kNone));
  if (clicks) Q_EMIT canvas_.popup_wanted(at);
}

/// The press of the right button is not a click: begins the action of the button where it was
/// pressed.
void MouseInput::hold_right(std::int64_t time_ns) {
  const QPointF from = *std::exchange(click_, std::nullopt);
  if (opens_menu(settings_.right) || settings_.right == ButtonRole::kPan) return;
  right_held_ = settings_.right;
  hand_.press(right_held_);
  if (draws(right_held_)) {
    hand_.point(PenHand::Source::kMouse, from, time_ns, true, std::nullopt);
  }
}

void MouseInput::release_all() {
  if (std::exchange(dragging_, Qt::NoButton) != Qt::NoButton) drag_.end();
  hand_.release(std::exchange(right_held_, ButtonRole::kNone));
  click_.reset();
}

void MouseInput::take(const QWheelEvent& event) {
  CanvasView view = canvas_.view();
  const Qt::KeyboardModifiers keys = event.modifiers();
  const bool ctrl = keys.testFlag(Qt::ControlModifier), shift = keys.testFlag(Qt::ShiftModifier);
  const QPoint units = event.angleDelta();
  // Alt and Shift swap the axes of the wheel on some platforms.
  const double turned = units.y() != 0 ? units.y() : units.x();
  if (!ctrl && !shift && !event.pixelDelta().isNull()) {
    view.pan(event.pixelDelta());  // only touchpads report pixels
  } else if (ctrl && shift) {
    view.turn(turned * kDegreesPerUnit, event.position());
  } else if (shift) {
    view.pan({turned * kPxPerUnit, 0.0});
  } else {
    view.zoom(std::exp2(turned / (ctrl ? kFineUnitsPerDoubling : kUnitsPerDoubling)),
              event.position());
  }
  canvas_.set_view(view);
}

bool MouseInput::take(const QNativeGestureEvent& event) {
  CanvasView view = canvas_.view();
  switch (event.gestureType()) {
    case Qt::ZoomNativeGesture:
      view.zoom(std::exp2(event.value()), event.position());
      break;
    case Qt::RotateNativeGesture:
      view.turn(event.value(), event.position());
      break;
    case Qt::PanNativeGesture:
      view.pan(event.delta());
      break;
    default:
      return false;
  }
  canvas_.set_view(view);
  return true;
}

}  // namespace felt::desktop
