#include "desktop/pens/touch_input.h"

#include <cmath>
#include <numbers>

namespace felt::desktop {
namespace {

constexpr double kMinSpreadPx = 20.0;  // minimum distance of two fingers that turn and zoom

QList<QEventPoint> fingers_down(const QTouchEvent& event) {
  QList<QEventPoint> down;
  for (const QEventPoint& point : event.points()) {
    if (point.state() != QEventPoint::Released) down.push_back(point);
  }
  return down;
}

}  // namespace

TouchInput::TouchInput(Canvas& canvas, PenHand& hand, const PenSettings& settings)
    : canvas_(canvas), hand_(hand), settings_(settings) {}

void TouchInput::cancel() {
  if (use_ == Use::kDraw && hand_.is_down(PenHand::Source::kFinger)) hand_.cancel();
  use_ = Use::kNothing;
  is_palm_ = true;
  tap_.cancel();
}

/// Two or three fingers that land together move the view a little, or begin a line.
void TouchInput::tap(int fingers) {
  if (!settings_.touch_taps || (fingers != 2 && fingers != 3)) return;
  canvas_.set_view(view_before_);
  if (fingers == 2) {
    canvas_.studio().apply(UndoEvent{});
  } else {
    canvas_.studio().apply(RedoEvent{});
  }
}

void TouchInput::take(const QTouchEvent& event, bool pen_is_near) {
  if (event.type() == QEvent::TouchBegin) {
    is_palm_ = pen_is_near || settings_.touch == TouchMode::kOff;
    use_ = Use::kNothing;
    ids_.clear();
    view_before_ = canvas_.view();
  }
  if (event.type() == QEvent::TouchCancel) return cancel();
  if (is_palm_) return;
  const std::int64_t time_ns = clock_.time_ns(event.timestamp(), canvas_.studio().now_ns());
  if (const std::optional<int> fingers = tap_.take(event, time_ns); fingers && *fingers > 1) {
    if (use_ == Use::kDraw) hand_.cancel();
    use_ = Use::kNothing;
    return tap(*fingers);
  }
  const QList<QEventPoint> down = fingers_down(event);
  if (down.size() > 1 && use_ == Use::kDraw) {
    hand_.cancel();  // the first of two fingers was not meant to draw
    use_ = Use::kNothing;
  }
  const bool draws = settings_.touch == TouchMode::kDraw && down.size() == 1 && use_ != Use::kView;
  if (draws) use_ = Use::kDraw;
  if (use_ == Use::kDraw) {
    if (!event.points().isEmpty()) draw(time_ns, event.points().constFirst());
    return;
  }
  if (!down.isEmpty()) use_ = Use::kView;
  if (use_ == Use::kView) move_view(event);
}

void TouchInput::draw(std::int64_t time_ns, const QEventPoint& finger) {
  const bool touching = finger.state() != QEventPoint::Released;
  hand_.point(PenHand::Source::kFinger, finger.position(), time_ns, touching, std::nullopt);
}

void TouchInput::move_view(const QTouchEvent& event) {
  const QList<QEventPoint> down = fingers_down(event);
  QList<int> ids;
  QPointF middle, first;
  for (const QEventPoint& point : down) {
    ids.push_back(point.id());
    middle += point.position() / double(down.size());
  }
  if (down.size() > 1) first = down[1].position() - down[0].position();
  // The view moves only if the same fingers were down at the last event. When a finger is added or
  // lifted, only the new positions are stored.
  if (ids == ids_ && !ids.isEmpty()) {
    CanvasView view = canvas_.view();
    view.pan(middle - middle_);
    const double before_px = std::hypot(first_.x(), first_.y());
    const double now_px = std::hypot(first.x(), first.y());
    if (before_px > kMinSpreadPx && now_px > kMinSpreadPx) {
      view.zoom(now_px / before_px, middle);
      const double cross = first_.x() * first.y() - first_.y() * first.x();
      const double along = first_.x() * first.x() + first_.y() * first.y();
      view.turn(std::atan2(cross, along) * 180.0 / std::numbers::pi, middle);
    }
    canvas_.set_view(view);
  }
  ids_ = ids;
  middle_ = middle;
  first_ = first;
}

}  // namespace felt::desktop
