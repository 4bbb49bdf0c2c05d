#include "desktop/pens/touch_tap.h"

#include <cmath>

namespace felt::desktop {

std::optional<int> TouchTap::take(const QTouchEvent& event) {
  if (event.type() == QEvent::TouchBegin) {
    is_tap_ = true;
    start_ms_ = event.timestamp();
    fingers_.clear();
  }
  if (event.type() == QEvent::TouchCancel) cancel();
  if (!is_tap_) return std::nullopt;
  for (const QEventPoint& finger : event.points()) {
    const auto [down, is_new] = fingers_.try_emplace(finger.id(), finger.position());
    const QPointF moved = finger.position() - down->second;
    if (std::hypot(moved.x(), moved.y()) > kMaxMovePx) cancel();
  }
  if (event.timestamp() > start_ms_ + quint64{kMaxMs}) cancel();
  if (!is_tap_ || event.type() != QEvent::TouchEnd) return std::nullopt;
  is_tap_ = false;
  return int(fingers_.size());
}

}  // namespace felt::desktop
