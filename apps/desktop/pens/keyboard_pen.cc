#include "desktop/pens/keyboard_pen.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace felt::desktop {
namespace {

constexpr double kViewMarginPx = 40.0;  // minimum distance between the pen and the edge of the
                                        // view

std::optional<QPointF> direction_of(int key) {
  switch (key) {
    case Qt::Key_Left:
      return QPointF(-1, 0);
    case Qt::Key_Right:
      return QPointF(1, 0);
    case Qt::Key_Up:
      return QPointF(0, -1);
    case Qt::Key_Down:
      return QPointF(0, 1);
    default:
      return {};
  }
}

bool is_touch_key(int key) {
  return key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Insert;
}

}  // namespace

KeyboardPen::KeyboardPen(Canvas& canvas, PenHand& hand) : canvas_(canvas), hand_(hand) {}

bool KeyboardPen::wants(const QKeyEvent& event) const {
  if (event.modifiers().testFlag(Qt::AltModifier) || event.modifiers().testFlag(Qt::MetaModifier)) {
    return false;
  }
  if (event.key() == Qt::Key_Escape) return hand_.is_down(PenHand::Source::kKeys);
  if (direction_of(event.key())) return true;
  // Ctrl+Enter takes an offer (OfferPopup).
  const bool ctrl = event.modifiers().testFlag(Qt::ControlModifier);
  return is_touch_key(event.key()) && !ctrl && may_touch();
}

bool KeyboardPen::may_touch() const {
  return is_leading_ || canvas_.has_focus_by_key() || hand_.is_down(PenHand::Source::kKeys) ||
         !canvas_.studio().loop().device().hand();
}

bool KeyboardPen::press(const QKeyEvent& event) {
  if (!wants(event)) return false;
  if (event.key() == Qt::Key_Escape) {
    hand_.cancel();
    Q_EMIT said(tr("Cancelled; the pen is up"));
    return true;
  }
  if (direction_of(event.key())) {
    is_leading_ = true;
    step(event);
    return true;
  }
  if (event.isAutoRepeat()) return true;
  if (canvas_.studio().loop().device().device().set_pen_down(true)) {
    held_ = event.key();
    Q_EMIT said(tr("The pen is down"));
    return true;
  }
  const bool down = !hand_.is_down(PenHand::Source::kKeys);
  if (hand_.point_mm(PenHand::Source::kKeys, hand_.place_mm(), canvas_.studio().now_ns(), down,
                     std::nullopt)) {
    canvas_.set_pen_visible(true);
    Q_EMIT said(down ? tr("The pen is down") : tr("The pen is up"));
  }
  return true;
}

void KeyboardPen::release(const QKeyEvent& event) {
  if (event.isAutoRepeat()) return;
  if (held_ != 0 && event.key() == held_) release_all();
  if (event.key() == key_) key_ = repeats_ = 0;
}

void KeyboardPen::release_all() {
  if (std::exchange(held_, 0) == 0) return;
  canvas_.studio().loop().device().device().set_pen_down(false);
  Q_EMIT said(tr("The pen is up"));
}

void KeyboardPen::step(const QKeyEvent& event) {
  repeats_ = event.key() == key_ ? repeats_ + 1 : 0;
  key_ = event.key();
  const bool fine = event.modifiers().testFlag(Qt::ShiftModifier);
  const double px =
      fine ? kFineStepPx : kStepPx * std::min(1 + repeats_ / kStepsPerFactor, kMaxFactor);
  const QPointF to = canvas_.view().to_px(hand_.place_mm()) + px * *direction_of(event.key());
  const Point mm = canvas_.view().to_mm(to);
  const bool down = hand_.is_down(PenHand::Source::kKeys);
  if (!hand_.point_mm(PenHand::Source::kKeys, mm, canvas_.studio().now_ns(), down, std::nullopt)) {
    return;
  }
  canvas_.set_pen_visible(true);
  keep_in_view(to);
}

void KeyboardPen::keep_in_view(QPointF px) {
  const QSizeF size = canvas_.view().size();
  const auto beyond = [](double at, double length) {
    const double margin = std::min(kViewMarginPx, length / 4);
    return std::min(0.0, at - margin) + std::max(0.0, at - (length - margin));
  };
  const QPointF out(beyond(px.x(), size.width()), beyond(px.y(), size.height()));
  if (out.isNull()) return;
  CanvasView view = canvas_.view();
  view.pan(-out);
  canvas_.set_view(view);
}

}  // namespace felt::desktop
