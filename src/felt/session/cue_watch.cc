#include "felt/session/cue_watch.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace felt {
namespace {

double nearest_handle(const Overlay& overlay, Point pen) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Overlay::Dot& dot : overlay.dots) {
    if (dot.role == Overlay::Role::kHandle) nearest = std::min(nearest, norm(dot.at - pen));
  }
  return nearest;
}

bool is_in_snap_ring(const Overlay& overlay, Point pen, double slack) {
  return std::any_of(overlay.rings.begin(), overlay.rings.end(), [&](const Overlay::Ring& ring) {
    return ring.role == Overlay::Role::kSnap && norm(ring.center - pen) <= slack * ring.radius_mm;
  });
}

}  // namespace

std::optional<CueEvent> CueWatch::look(const Session& session, const PenSample& pen) {
  constexpr double kLetGo = 1.5;  // hysteresis: a handle stays reached up to this factor of
                                  // kFoundMm
  const Point at{pen.position.x, pen.position.y};
  session.draw(overlay_);
  const bool is_down = session.gesture_in_progress();
  const bool was_down = std::exchange(is_down_, is_down);
  // A tool that erases or selects may touch empty paper without an error cue.
  const bool takes = session.tool().info().kind == ToolKind::kEdits;

  const bool snapped = is_in_snap_ring(overlay_, at, snaps_ ? kLetGo : 1.0) && is_down;
  const bool is_new_snap = snapped && !std::exchange(snaps_, snapped);
  snaps_ = snapped;
  const double reach_mm = (found_ ? kLetGo : 1.0) * kFoundMm;
  const bool found = !is_down && nearest_handle(overlay_, at) <= reach_mm;
  const bool is_new_find = !std::exchange(found_, found) && found;

  const std::uint64_t ticks = session.guide_ticks();
  const bool is_new_tick = std::exchange(guide_ticks_, ticks) != ticks;

  if (is_down && !was_down) came_to_something_ = false;
  const bool is_first_change =
      is_down && !came_to_something_ && session.preview().has_value() && takes;
  if (is_first_change) came_to_something_ = true;
  if (was_down && !is_down && takes && !came_to_something_) return CueEvent::kRefused;
  if (is_new_snap) return CueEvent::kSnapped;
  if (is_first_change || is_new_tick) return CueEvent::kTook;
  if (is_new_find) return CueEvent::kFound;
  return std::nullopt;
}

}  // namespace felt
