#include "felt/tools/pull/nib_push.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "felt/geometry/nearest.h"
#include "felt/tools/pull/refit.h"

namespace felt {
namespace {

/// Maximum length of a handle, as a fraction of the length of its segment. Longer handles make
/// loops (docs/design/editing.md#sweep).
constexpr double kLongestHandle = 1.5;

/// R27: the distance of the stroke from the nib is at least the radius minus kTouchMm.
constexpr double kTouchMm = 1e-6;

/// Pins nearer to the pulled point than this move along, and the ink is not cut into shorter
/// pieces, which could not be compressed.
constexpr double kShortestPieceMm = 1.0;

/// Added to the radius by each correction after the first kExactCorrections, mm.
constexpr double kRoomMm = 1e-3;

/// The steps of a straight motion.
struct Steps {
  Point from, to;
  int count = 1;
  bool may_jump = false;  // steps longer than half a radius

  Steps(Point a, Point b, double radius_mm, int max_steps = NibPush::kMaxSteps) noexcept
      : from(a), to(b) {
    const double wanted = std::ceil(distance(a, b) / (0.5 * radius_mm));
    may_jump = !(wanted <= max_steps);
    count = may_jump ? max_steps : std::max(1, static_cast<int>(wanted));
  }
  [[nodiscard]] Point at(int k) const noexcept {
    return k == count ? to : lerp(from, to, static_cast<double>(k) / count);
  }
};

Rect box_of(Point a, Point b) noexcept {
  Rect box;
  box.extend(a);
  box.extend(b);
  return box;
}

/// Returns the parameter of the crossing of a segment with the straight line from a to b that is
/// nearest to a. Approximates the segment by chords, which is accurate enough to find the segment
/// that the nib jumped over.
std::optional<double> crossing(const Cubic& c, Point a, Point b) noexcept {
  constexpr int kChords = 16;
  if (!control_bounds(c).intersects(box_of(a, b))) return std::nullopt;
  const Vec way = b - a;
  std::optional<double> found;
  double nearest_part = 2.0;
  Point p = c.p[0];
  for (int k = 1; k <= kChords; ++k) {
    const Point q = evaluate(c, static_cast<double>(k) / kChords);
    const double det = cross(way, q - p);
    const double part = det != 0.0 ? cross(p - a, q - p) / det : 2.0;
    const double along = det != 0.0 ? cross(p - a, way) / det : 2.0;
    if (part >= 0.0 && part <= 1.0 && along >= 0.0 && along <= 1.0 && part < nearest_part) {
      nearest_part = part;
      found = (k - 1 + along) / kChords;
    }
    p = q;
  }
  return found;
}

Rect bounds_of(std::span<const Point> points) noexcept {
  Rect box;
  for (const Point p : points) box.extend(p);
  return box;
}

}  // namespace

bool nib_meets(const Cubic& c, Point from, Point to, double radius_mm) noexcept {
  const Rect box = control_bounds(c);
  if (!box.intersects(box_of(from, to).inflated(radius_mm))) return false;
  const Steps steps(from, to, radius_mm);
  const double near = radius_mm - NibPush::kContactMm;
  for (int k = 0; k <= steps.count; ++k) {
    const Point p = steps.at(k);
    if (distance_squared(box, p) < near * near && nearest_within(c, p, near * near)) return true;
  }
  return steps.may_jump && crossing(c, from, to).has_value();
}

NibPush::NibPush(StrokePtr snapshot, double radius_mm)
    : strand_(snapshot),
      map_(*snapshot),
      stroke_(std::move(snapshot)),
      box_(bounds_of(strand_.points())),
      radius_mm_(radius_mm),
      is_in_pieces_(static_cast<std::size_t>(stroke_->segment_count()), 0) {
  note_material();
}

bool NibPush::move(Point from, Point to, Vec came_from) {
  return step(from, to, came_from) && settle();
}

bool NibPush::step(Point from, Point to, Vec came_from, int max_steps) {
  contact_.reset();
  if (!box_.intersects(box_of(from, to).inflated(radius_mm_))) return false;
  const Steps steps(from, to, radius_mm_, max_steps);
  bool moved = false;
  for (int k = 1; k <= steps.count; ++k) {
    const Point p = steps.at(k);
    if (steps.may_jump) moved = catch_jumped(steps.at(k - 1), p) || moved;
    moved = clear(p, came_from, 0.0) || moved;
  }
  return moved;
}

bool NibPush::settle() {
  if (!settled_) return true;
  Result<Stroke> now = strand_.stroke();
  if (now) {
    stroke_ = std::make_shared<const Stroke>(*std::move(now));
    settled_.reset();
  } else {
    undo();
  }
  return now.has_value();
}

void NibPush::undo() {
  if (!settled_) return;
  strand_ = *std::move(settled_);
  settled_.reset();
  note_material();
  box_ = bounds_of(strand_.points());
}

Point NibPush::position(double snapshot_u) const noexcept {
  const StrandPlace at = strand_.locate(snapshot_u);
  return evaluate(strand_.segment(at.segment), at.t);
}

/// Divides the ink at a parameter of the snapshot, so that the influence can be exactly 0 or 1
/// there.
void NibPush::cut(double snapshot_u) {
  const StrandPlace at = strand_.locate(snapshot_u);
  if (at.t <= 0.0 || at.t >= 1.0 || strand_.count() >= kMaxSegments) return;
  const auto [a, b] = split(strand_.segment(at.segment), at.t);
  if (std::min(control_length(a), control_length(b)) < kShortestPieceMm) return;
  if (strand_.divide(at.segment, at.t)) note_material();
}

bool NibPush::pull(double u, Point target, std::pair<double, double> pins) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  if (!settled_) settled_ = strand_;
  const double s = map_.length_at(u);
  const double reach =
      kReachRadii * radius_mm_ + kReachPerDepth * distance(strand_.snapshot()->position(u), target);
  const auto pinned = [&](double pin) {
    if (std::isnan(pin)) return kFar;
    const double mm = std::fabs(map_.way(s, map_.length_at(pin)));
    if (mm < kShortestPieceMm) return kFar;  // moves along
    if (mm < reach) cut(pin);
    return mm;
  };
  cut(u);
  pin_before_mm_ = pinned(pins.first);
  pin_after_mm_ = pinned(pins.second);
  const StrandPlace at = strand_.locate(u);
  const bool moved = displace({at, evaluate(strand_.segment(at.segment), at.t)}, target);
  pin_before_mm_ = pin_after_mm_ = kFar;
  box_ = bounds_of(strand_.points());
  return moved;
}

std::optional<NibPush::Nearest> NibPush::nearest_to(Point p, double within_mm) const {
  double best = within_mm * within_mm;
  std::optional<Nearest> found;
  for (int i = 0; i < strand_.count(); ++i) {
    const Cubic c = strand_.segment(i);
    if (distance_squared(control_bounds(c), p) >= best) continue;
    const auto hit = nearest_within(c, p, best);
    if (!hit || hit->distance_squared >= best) continue;
    best = hit->distance_squared;
    found = {{i, hit->t}, hit->point};
  }
  return found;
}

std::optional<NibPush::Under> NibPush::under(Point p, double within_mm) const {
  const auto near = nearest_to(p, within_mm);
  if (!near) return std::nullopt;
  const Point was = strand_.snapshot()->position(u_of(near->place));
  return Under{near->point, distance(near->point, was)};
}

bool NibPush::clear(Point p, Vec came_from, double room_mm) {
  bool moved = false;
  for (int k = 0; k < kCorrections; ++k) {
    const auto met = nearest_to(p, radius_mm_ - kContactMm);
    if (!met) break;
    if (!settled_) settled_ = strand_;
    const double depth = distance(p, met->point);
    Vec n = depth > 1e-9 ? (p - met->point) / depth : came_from;
    if (n == Vec{}) n = perp(tangent(strand_.segment(met->place.segment), met->place.t));
    // A correction may move another point back under the nib. Therefore each additional correction
    // moves the ink a little farther than the radius.
    const double more = k < kExactCorrections ? 0.0 : kRoomMm * (k - kExactCorrections + 1);
    contact_ = p - (radius_mm_ + room_mm + more) * n;
    if (!displace(*met, *contact_)) break;
    moved = true;
  }
  if (moved) box_ = bounds_of(strand_.points());
  return moved;
}

bool NibPush::catch_jumped(Point from, Point to) {
  bool moved = false;
  const Point beyond = to + radius_mm_ * normalized(to - from);
  for (int round = 0; round < kCorrections; ++round) {
    int i = 0;
    std::optional<double> t;
    while (i < strand_.count() && !(t = crossing(strand_.segment(i), from, to))) ++i;
    if (!t) break;
    if (!settled_) settled_ = strand_;
    if (!displace({{i, *t}, evaluate(strand_.segment(i), *t)}, beyond)) break;
    moved = true;
  }
  return moved;
}

double NibPush::u_of(StrandPlace place) const noexcept {
  const double from = strand_.snapshot_u(place.segment), to = strand_.snapshot_u(place.segment + 1);
  return from + place.t * (to - from);
}

void NibPush::note_material() {
  const Stroke& snapshot = *strand_.snapshot();
  const int n = strand_.count();
  const auto handle = [&](int i, double t) {  // handle length: a third of the derivative
    const double from = strand_.snapshot_u(i), to = strand_.snapshot_u(i + 1);
    const int segment = static_cast<int>(from);
    return norm(derivative(snapshot.segment(segment), from - segment + t * (to - from))) *
           (to - from) / 3.0;
  };
  material_.assign(static_cast<std::size_t>(n) + 1, {});
  for (int j = 0; j <= n; ++j) {
    Material& here = material_[static_cast<std::size_t>(j)];
    here.s_mm = map_.length_at(strand_.snapshot_u(j));
    const int before = j > 0 ? j - 1 : (strand_.closed() ? n - 1 : -1);
    const int after = j < n ? j : (strand_.closed() ? 0 : -1);
    if (before >= 0) here.handles_mm += handle(before, 1.0);
    if (after >= 0) here.handles_mm += handle(after, 0.0);
  }
}

bool NibPush::divide_within(double s_mm, double reach_mm) {
  // A segment of the snapshot may have been cut, so first all segments to divide are found.
  constexpr std::uint8_t kIsNext = 2;
  bool found = false;
  for (int i = strand_.count() - 1; i >= 0; --i) {
    const auto origin = static_cast<std::size_t>(strand_.snapshot_u(i));
    if (is_in_pieces_[origin] != 0) continue;
    const double to_start = std::fabs(map_.way(s_mm, material_[static_cast<std::size_t>(i)].s_mm));
    const double to_end =
        std::fabs(map_.way(s_mm, material_[static_cast<std::size_t>(i) + 1].s_mm));
    const double length = material_[static_cast<std::size_t>(i) + 1].s_mm -
                          material_[static_cast<std::size_t>(i)].s_mm;
    // Skips the segment unless one of its ends is within reach or the point at s_mm lies on it.
    if (std::min(to_start, to_end) >= reach_mm && to_start + to_end > length + 1e-6) continue;
    is_in_pieces_[origin] = kIsNext;
    found = true;
  }
  if (!found) return false;
  bool divided = false;
  for (int i = strand_.count() - 1; i >= 0; --i) {
    if (is_in_pieces_[static_cast<std::size_t>(strand_.snapshot_u(i))] != kIsNext) continue;
    const int largest = kMaxSegments - strand_.count() + 1;
    divided = strand_.divide_evenly(i, kPieceRadii * radius_mm_, largest) > 1 || divided;
  }
  for (std::uint8_t& state : is_in_pieces_) state = state != 0 ? 1 : 0;
  if (divided) note_material();
  return divided;
}

NibPush::Influence NibPush::influence_at(int joint, double s_mm, double reach_mm) const {
  // On a closed stroke both sides meet at half its length. The influence must have zero slope
  // there, so a reach of more than half of the length raises the influence everywhere instead.
  const double way = map_.way(s_mm, material_[static_cast<std::size_t>(joint)].s_mm);
  const double pin = is_pinned() ? (way > 0.0 ? pin_after_mm_ : pin_before_mm_) : reach_mm;
  const double half = strand_.closed() ? 0.5 * map_.length_mm() : reach_mm;
  const double radius = std::min({reach_mm, half, pin});
  const double base = is_pinned() ? 0.0 : 1.0 - radius / reach_mm;
  const double x = std::min(1.0, std::fabs(way) / radius);
  const double slope = (way > 0.0 ? -6.0 : 6.0) * x * (1.0 - x) / radius;
  return {base + (1.0 - base) * (1.0 - x * x * (3.0 - 2.0 * x)), (1.0 - base) * slope};
}

std::array<double, 3> NibPush::weights_at(int joint, const Influence& influence) const {
  const auto points = strand_.points();
  const auto n = static_cast<std::size_t>(strand_.count());
  const auto j = static_cast<std::size_t>(joint);
  const auto length = [&](std::size_t a, std::size_t b) { return distance(points[a], points[b]); };
  double before = j > 0 ? length(3 * j - 1, 3 * j) : 0.0;
  double after = j < n ? length(3 * j, 3 * j + 1) : 0.0;
  if (strand_.closed() && j == 0) before = length(3 * n - 1, 3 * n);
  if (strand_.closed() && j == n) after = length(0, 1);
  // Both handles of a joint turn by the same angle. The angle is that of the ink at the touch, so
  // it does not depend on how far the handles are stretched by now.
  const double both = before + after;
  // Towards a pin the influence may fall off within less than a handle. Then the handle would move
  // farther than the ink.
  const double slope = std::clamp(influence.slope * material_[j].handles_mm, -1.0, 1.0);
  const double turn =
      both > 0.0 ? (is_pinned() ? slope : influence.slope * material_[j].handles_mm) / both : 0.0;
  return {influence.weight - turn * before, influence.weight, influence.weight + turn * after};
}

bool NibPush::displace(Nearest at, Point target) {
  const double u = u_of(at.place);
  const double depth = distance(strand_.snapshot()->position(u), target);
  double reach = kReachRadii * radius_mm_ + kReachPerDepth * depth;
  // If the ink would be compressed too much, tries again with a larger reach.
  for (int trial = 0; trial < kReachTrials; ++trial, reach *= 2.0) {
    if (divide_within(map_.length_at(u), reach)) at.place = strand_.locate(u);
    if (displace_within(reach, at, target)) return true;
  }
  return false;
}

bool NibPush::displace_within(double reach, const Nearest& at, Point target) {
  const int n = strand_.count();
  const double s = map_.length_at(u_of(at.place));
  int first = at.place.segment, count = 1;
  const auto is_reached = [&](int joint) { return influence_at(joint, s, reach).weight > 0.0; };
  for (int i = first; count < n && is_reached(i) && strand_.previous(i) >= 0; ++count) {
    first = i = strand_.previous(i);
  }
  for (int i = at.place.segment; count < n && is_reached(i + 1) && strand_.next(i) >= 0; ++count) {
    i = strand_.next(i);
  }
  weights_.clear();
  for (int k = 0; k < count; ++k) strand_.prepare((first + k) % n);
  for (int k = 0; k < count; ++k) {
    const int i = (first + k) % n;
    const auto left = weights_at(i, influence_at(i, s, reach));
    const auto right = weights_at(i + 1, influence_at(i + 1, s, reach));
    if (k == 0) weights_.push_back(left[1]);
    weights_.insert(weights_.end(), {left[2], right[0], right[1]});
  }
  const auto held = static_cast<std::size_t>((at.place.segment - first + n) % n);
  EditWeights here;
  std::copy_n(weights_.begin() + static_cast<std::ptrdiff_t>(3 * held), 4, here.w.begin());
  const double gain = here.gain(at.place.t);
  // Near a pin the ink would have to move much farther than the point.
  if (!(gain > (is_pinned() ? 0.7 : 0.1))) return false;
  if (!strand_.shift(first, weights_, (target - at.point) / gain)) return false;
  for (int k = 0; k < count; ++k) strand_.limit_handles((first + k) % n, kLongestHandle);
  return true;
}

Result<Stroke> NibPush::finished(Point pen) const {
  Result<Stroke> refitted = with_good_shapes(strand_);
  if (!refitted) return refitted;
  // The refit may have moved the stroke towards the nib by kRefitToleranceMm, so the nib pushes
  // once more.
  NibPush again(std::make_shared<const Stroke>(*std::move(refitted)), radius_mm_);
  again.move(pen, pen);
  if (again.nearest_to(pen, radius_mm_ - kTouchMm) && !nearest_to(pen, radius_mm_ - kTouchMm)) {
    return strand_.stroke();
  }
  return *again.stroke();
}

}  // namespace felt
