#include "felt/tools/brush_reach.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace felt {
namespace {

constexpr double kUnreachedMm = std::numeric_limits<double>::infinity();
/// Pins within kNoRoomMm of held ink are held too, and a closed stroke shorter than ten times
/// kNoRoomMm moves as a whole, because the influence needs some length to fall off.
constexpr double kNoRoomMm = 0.1;
/// If the ends of both sides are within kRingMeetMm, they count as one point.
constexpr double kRingMeetMm = 0.01;
/// Last fraction of the radius. If it contains a joint, the side ends at that joint.
constexpr double kJointShare = 0.2;

/// Arc lengths along a stroke to one side of the grab.
class Side {
 public:
  /// `sign` is -1 towards the start, +1 towards the end.
  Side(const Stroke& stroke, const ArcMap& map, double grab_u, double sign)
      : stroke_(stroke), map_(map), grab_u_(grab_u), grab_(map.length_at(grab_u)), sign_(sign) {}

  /// Returns the arc length from the grab to joint i, >= 0, or infinity if the joint is on the
  /// other side of the grab.
  [[nodiscard]] double way_to(int joint) const {
    double way = sign_ * (map_.start_of(joint) - grab_);
    if (stroke_.closed() && way < 0.0) way += map_.length_mm();
    return way >= 0.0 ? way : kUnreachedMm;
  }
  /// Returns the arc length to the end of an open stroke.
  [[nodiscard]] double way_to_end() const {
    if (stroke_.closed()) return kUnreachedMm;
    return sign_ < 0.0 ? grab_ : map_.length_mm() - grab_;
  }
  /// Returns the arc lengths to ends and corners on this side, up to `within_mm`, ascending.
  [[nodiscard]] std::vector<double> pins(double within_mm) const {
    std::vector<double> ways;
    for_each_joint(within_mm, [&](int joint, double way) {
      if (stroke_.joint(joint) != JointKind::kSmooth) ways.push_back(way);
    });
    std::sort(ways.begin(), ways.end());
    return ways;
  }
  /// Returns the largest arc length from the grab to a joint that lies between `shortest` and
  /// `longest`, or `longest` if there is no such joint.
  [[nodiscard]] double at_joint(double shortest, double longest) const {
    double best = -1.0;
    for_each_joint(longest, [&](int, double way) {
      if (way >= shortest) best = std::max(best, way);
    });
    return best >= 0.0 ? best : longest;
  }

 private:
  /// Calls visit(joint, arc length from the grab) for each joint on this side up to `within_mm`,
  /// from the grab on. May visit a joint at the grab twice.
  template <class Visit>
  void for_each_joint(double within_mm, Visit visit) const {
    const int n = stroke_.segment_count(), step = sign_ < 0.0 ? -1 : 1;
    int joint = static_cast<int>(step < 0 ? std::ceil(grab_u_) : std::floor(grab_u_));
    for (int k = 0; k <= n; ++k, joint += step) {
      if (stroke_.closed()) joint = (joint + n - 1) % n + 1;  // the seam has number n
      if (joint < 0 || joint > n) return;
      const double way = way_to(joint);
      if (way <= within_mm) {
        visit(joint, way);
      } else if (k > 1) {
        return;  // the first two may lie behind the grab
      }
    }
  }

  const Stroke& stroke_;
  const ArcMap& map_;
  double grab_u_, grab_, sign_;
};

/// The held length, and the arc length from the grab to the pin that limits the side, if any.
struct Hold {
  double held_mm = 0.0;
  double pin_mm = kUnreachedMm;
};

Hold hold_of(const std::vector<double>& pins, double radius_mm) {
  Hold result;
  const double near = std::min(kPinGrabMm, 0.5 * radius_mm);
  for (const double way : pins) {
    const bool is_held = way <= near || way < result.held_mm + kNoRoomMm;
    if (!is_held) {
      result.pin_mm = way;
      break;
    }
    result.held_mm = way;
  }
  return result;
}

/// Returns what the pins hold. A chain of pins may lead beyond the radius.
Hold hold(const Side& side, const ArcMap& map, double radius_mm) {
  for (double within = radius_mm + 2.0 * kNoRoomMm;; within *= 2.0) {
    const Hold result = hold_of(side.pins(within), radius_mm);
    if (result.held_mm + 2.0 * kNoRoomMm < within || within > map.length_mm()) return result;
  }
}

BrushSide side_of(const Side& side, const Hold& hold, double max_mm, const BrushOptions& options) {
  BrushSide result{.held_mm = hold.held_mm};
  const double end = side.way_to_end() - hold.held_mm;
  if (end <= 0.0) return result;
  // The radius is measured from the grab, so that nothing moves beyond it.
  const double free = std::min(std::max(options.radius_mm - hold.held_mm, kNoRoomMm), max_mm);
  const double pin = hold.pin_mm - hold.held_mm;
  if (pin <= free) {
    result.way_mm = result.radius_mm = pin;
  } else if (options.free_ends && end <= free) {
    result.way_mm = end;
    result.radius_mm = free;
  } else {
    const double h = hold.held_mm;
    result.way_mm = side.at_joint(h + (1.0 - kJointShare) * free, h + free) - h;
    result.radius_mm = result.way_mm;
  }
  return result;
}

}  // namespace

BrushReach brush_reach(const Stroke& stroke, const ArcMap& map, double u0,
                       const BrushOptions& options) {
  BrushReach reach;
  reach.grab_mm = map.length_at(u0);
  reach.is_ring = stroke.closed();
  const Side before(stroke, map, u0, -1.0), after(stroke, map, u0, 1.0);
  Hold first, last;
  if (!options.free_ends) {
    first = hold(before, map, options.radius_mm);
    last = hold(after, map, options.radius_mm);
  }
  double largest = kUnreachedMm;
  if (stroke.closed()) {
    const double rest = map.length_mm() - first.held_mm - last.held_mm;
    reach.is_whole = rest < 10.0 * kNoRoomMm;
    largest = 0.5 * rest;
  }
  reach.before = side_of(before, first, largest, options);
  reach.after = side_of(after, last, largest, options);
  if (!stroke.closed()) {
    // The stroke is held up to both ends, or too short for the influence to fall off (a dot).
    reach.is_whole = (reach.before.way_mm < kNoRoomMm && reach.after.way_mm < kNoRoomMm) ||
                     map.length_mm() < kNoRoomMm;
  }
  return reach;
}

double BrushReach::first_u(const ArcMap& map) const noexcept {
  return is_whole ? 0.0 : map.u_at(grab_mm - before.held_mm - before.way_mm);
}

double BrushReach::last_u(const ArcMap& map) const noexcept {
  if (is_whole) return map.u_at(map.length_mm());
  // The two sides of a closed stroke meet, so they end at the same point.
  const double reach = before.held_mm + before.way_mm + after.held_mm + after.way_mm;
  if (is_ring && reach >= map.length_mm() - kRingMeetMm) return first_u(map);
  return map.u_at(grab_mm + after.held_mm + after.way_mm);
}

}  // namespace felt
