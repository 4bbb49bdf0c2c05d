#include "desktop/pens/touch_tap.h"

#include <cmath>

namespace felt::desktop {

std::optional<int> TouchTap::take(const QTouchEvent& event, std::int64_t time_ns) {
  if (event.type() == QEvent::TouchBegin) {
    is_tap_ = true;
    start_ns_ = time_ns;
    fingers_.clear();
  }
  if (event.type() == QEvent::TouchCancel) cancel();
  if (!is_tap_) return std::nullopt;
  for (const QEventPoint& finger : event.points()) {
    const auto [down, is_new] = fingers_.try_emplace(finger.id(), finger.position());
    const QPointF moved = finger.position() - down->second;
    if (std::hypot(moved.x(), moved.y()) > kMaxMovePx) cancel();
  }
  if (time_ns - start_ns_ > kMaxNs) cancel();
  if (!is_tap_ || event.type() != QEvent::TouchEnd) return std::nullopt;
  is_tap_ = false;
  return int(fingers_.size());
}

}  // namespace felt::desktop
