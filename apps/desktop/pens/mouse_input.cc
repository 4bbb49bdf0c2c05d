#include "desktop/pens/mouse_input.h"

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

}  // namespace

MouseInput::MouseInput(Canvas& canvas, PenHand& hand, ViewDrag& drag, const PenSettings& settings)
    : canvas_(canvas), hand_(hand), drag_(drag), settings_(settings) {}

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
  if (drags(event)) return;
  const bool right = event.buttons().testFlag(Qt::RightButton);
  if (right && right_held_ == ButtonRole::kNone && !hand_.is_down()) {
    right_held_ = settings_.right;
    hand_.press(right_held_);
  }
  // While the right button is pressed, the pen draws only if the button borrows a tool.
  const bool draws =
      right && (right_held_ == ButtonRole::kEraser || right_held_ == ButtonRole::kPull ||
                right_held_ == ButtonRole::kLasso);
  const bool touching = event.buttons().testFlag(Qt::LeftButton) || draws;
  hand_.point(PenHand::Source::kMouse, place_of(event, canvas_), time_ns, touching, std::nullopt);
  if (!right) hand_.release(std::exchange(right_held_, ButtonRole::kNone));
}

void MouseInput::release_all() {
  if (std::exchange(dragging_, Qt::NoButton) != Qt::NoButton) drag_.end();
  hand_.release(std::exchange(right_held_, ButtonRole::kNone));
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
