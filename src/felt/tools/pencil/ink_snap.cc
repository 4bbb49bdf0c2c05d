#include "felt/tools/pencil/ink_snap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "felt/base/constants.h"
#include "felt/tools/connecting.h"
#include "felt/tools/pencil/snap_rules.h"

namespace felt {
namespace {

using namespace snap_rules;

/// A movement that ends at distance d lasts about another 3 d / v (minimum jerk: d = 10 A u^3, v =
/// 30 A u^2 / T with u the remaining fraction of the time T; Flash and Hogan 1985). A hand cannot
/// stop in less than 0.12 s (visual correction takes 0.1 to 0.2 s; Crossman and Goodeve).
constexpr double kRemainingS = 0.12;
constexpr double kRestingMmPerS = 15.0;
constexpr double kSlowMmPerS = 100.0;
/// If the pen is faster than this, the user flicks it off the surface or passes the target.
constexpr double kMaxEndMmPerS = 150.0;
constexpr double kMaxCloseMmPerS = 400.0;
constexpr double kMaxMeetMmPerS = 60.0;

/// A pen rests beside its target if it has been slower than the first speed for kRestNs; it no
/// longer does above the second. Writing hands pass many ends, and are that slow for a shorter
/// time.
constexpr double kRestMmPerS = 20.0, kLeavesMmPerS = 60.0;
constexpr double kRestNs = 150e6;

/// If the gap is less than kSureShare of the extent of an outline, the outline is closed from every
/// direction.
constexpr double kSureShare = 0.2;

constexpr double kCrossingStepMm = 0.5;
/// Each step of the pen is checked for crossings in pieces of about 1 mm, but in at most
/// kMaxCrossingPieces pieces.
constexpr int kMaxCrossingPieces = 32;
/// If a line crosses another line within this distance of its end, it is not heading for any line.
constexpr double kClearMm = 4.0;
constexpr double kMeetDeg = 35.0;
/// A line that continues another line straight ahead begins at most kDashMm from the end of that
/// line. If it begins farther away, it is the next dash of a dashed line.
constexpr double kDashMm = 0.8, kDashDeg = 40.0;
/// An attraction ends if the pen moves away from the target by kLeaveMm.
constexpr double kLeaveMm = 1.0;
/// Reach of the attraction while hovering.
constexpr double kAirReachMm = 1.4;
constexpr std::size_t kMaxCandidates = 4;

}  // namespace

void InkSnap::hover(Point pen, std::int64_t time_ns, bool is_near, const SnapOptions& options,
                    const Scene& scene) {
  options_ = options;
  if (!is_in_air_) track_.begin(pen, time_ns);
  is_in_air_ = true;
  track_.push(pen, time_ns);
  target_.reset();
  if (!is_near || options.mode == SnapMode::kOff) {
    attraction_.reset();
    return;
  }
  find_attraction(scene);
  const double within = kStartShare * options.radius_mm;
  if (!snaps(options.mode) || track_.speed_mm_per_s() > kSlowMmPerS) return;
  if (const auto end = nearest_end({within, 180.0, within, 0.0, 0.0, false}, scene)) {
    target_ = SnapTarget{end->id, end->point};
  }
}

void InkSnap::begin(Point pen, std::int64_t time_ns, const SnapOptions& options,
                    const Scene& scene) {
  end(last_);
  options_ = options;
  is_drawing_ = true;
  slow_since_ns_ = time_ns;
  track_.begin(pen, time_ns);
  crossings_from_ = pen;
  if (options.mode != SnapMode::kOff) find_begun_on(scene);
}

void InkSnap::end(std::optional<StrokeId> drawn) noexcept {
  last_ = drawn;
  is_drawing_ = is_in_air_ = rests_ = false;
  begun_on_.reset();
  begun_part_ = {};
  target_.reset();
  start_target_.reset();
  attraction_.reset();
  crossed_.clear();
  first_crossing_mm_.reset();
  last_crossing_mm_.reset();
}

void InkSnap::update(Point pen, std::int64_t time_ns, const SnapOptions& options,
                     const Scene& scene) {
  options_ = options;
  track_.push(pen, time_ns);
  if (options.mode == SnapMode::kOff) return;
  if (distance(crossings_from_, pen) >= kCrossingStepMm) note_crossings(scene);
  target_.reset();
  if (snaps(options.mode)) {
    const double r = options.radius_mm;
    const double early = std::min(kEarlyS * track_.speed_mm_per_s(), r);
    target_ =
        find({r, 45.0, 0.5 * r, kCloseShare * r + early, kSureShare, false}, kMeetShare * r, scene);
    start_target_ = find_start(scene);
  }
  follow_rest(time_ns);
  find_attraction(scene);
}

void InkSnap::find_begun_on(const Scene& scene) {
  const auto hit = scene.index.nearest_tip(scene.document, track_.start(), options_.radius_mm, {});
  const StrokePtr stroke = hit ? stroke_with_tip(scene.document, hit->id) : nullptr;
  if (!stroke || is_dot(*stroke)) return;
  begun_on_ = hit->id;
  // Measures the stroke from its other end to this end. Areas are relative to this end.
  const bool start = hit->id.tip == StrokeTip::kStart;
  const int n = stroke->segment_count();
  Point last = tip_point(*stroke, opposite(hit->id.tip));
  const Point far_end = last;
  for (int i = 0; i < n; ++i) {
    const Cubic c = stroke->segment(start ? n - 1 - i : i);
    for (int k = 1; k <= 4; ++k) {
      const Point p = evaluate(c, start ? 1.0 - 0.25 * k : 0.25 * k);
      begun_part_.area_mm2 += 0.5 * cross(last - hit->point, p - hit->point);
      begun_part_.length_mm += distance(last, p);
      begun_part_.extent_mm = std::max(begun_part_.extent_mm, distance(far_end, p));
      last = p;
    }
  }
}

void InkSnap::note_crossings(const Scene& scene) {
  const Point to = track_.pen();
  const int pieces = std::clamp(static_cast<int>(std::min(distance(crossings_from_, to), 1e3)), 1,
                                kMaxCrossingPieces);
  bool any = false;
  Point from = crossings_from_;
  for (int i = 1; i <= pieces; ++i) {
    const Point next = lerp(crossings_from_, to, static_cast<double>(i) / pieces);
    any = append_crossed(scene, from, next, crossed_) || any;
    from = next;
  }
  crossings_from_ = to;
  if (!any) return;
  if (!first_crossing_mm_) first_crossing_mm_ = track_.length_mm();
  last_crossing_mm_ = track_.length_mm();
}

bool InkSnap::is_heading_for(Point target, const Aim& aim) const noexcept {
  const Vec way = target - track_.pen();
  const double gap = norm(way);
  if (gap > aim.within_mm) return false;
  if (is_drawing_ && track_.passed_within_mm(target) <= aim.miss_mm) return true;
  if (!is_drawing_ && gap <= aim.miss_mm) return true;
  const auto heading = track_.heading(gap);
  return heading && angle_between(*heading, way) * kDegPerRad <= aim.cone_deg;
}

bool InkSnap::is_slow(double gap_mm) const noexcept {
  const double speed = track_.speed_mm_per_s();
  return speed <= std::min(kSlowMmPerS, std::max(kRestingMmPerS, 3.0 * gap_mm / kRemainingS));
}

bool InkSnap::closes(Point target, const Part& before) const noexcept {
  const Point from = track_.start(), pen = track_.pen();
  const double gap = distance(pen, target);
  const double extent = std::max(before.extent_mm, track_.extent_mm());
  if (extent < kMinExtentMm || gap > kMaxGapShare * extent) return false;
  if (std::fabs(track_.turns()) > kMaxTurns) return false;
  const double length = before.length_mm + track_.length_mm() + gap;
  const double area = before.area_mm2 + track_.area_mm2() + 0.5 * cross(pen - from, target - from);
  const bool is_large = extent >= kLargeMm && gap <= kLargeShare * extent;
  const double roundness = 4.0 * std::numbers::pi * std::fabs(area) / (length * length);
  return roundness >= (is_large ? kMinRoundnessOfLarge : kMinRoundness);
}

/// The shape of an outline is better evidence than the direction of its last millimetre. So the pen
/// may head for the start less exactly than for the end of another line, and if the gap is small
/// compared with the outline, the direction of the pen does not matter.
bool InkSnap::is_closing(Point target, const Part& before, const Aim& aim) const noexcept {
  const double gap = distance(track_.pen(), target);
  const double speed = track_.speed_mm_per_s();
  if (gap > aim.closing_mm || speed > kMaxCloseMmPerS || !closes(target, before)) return false;
  const double extent = std::max(before.extent_mm, track_.extent_mm());
  const bool is_sure = gap <= aim.sure_share * extent && speed <= kMaxMeetMmPerS;
  return is_sure || is_heading_for(target, {.within_mm = aim.closing_mm,
                                            .cone_deg = aim.cone_deg + 15.0,
                                            .miss_mm = aim.miss_mm + 0.3,
                                            .closing_mm = 0.0,
                                            .sure_share = 0.0,
                                            .felt = aim.felt});
}

/// Returns true if the line may join this end. While hovering, only the conditions that need no
/// direction are checked.
bool InkSnap::may_join(const TipHit& end, const Scene& scene) const {
  const StrokePtr stroke = stroke_with_tip(scene.document, end.id);
  if (!stroke || is_dot(*stroke) || end.id == begun_on_) return false;
  if (!is_drawing_ && last_ == end.id.stroke) return false;
  if (is_drawing_) {
    if (track_.extent_mm() < kDotMm || track_.speed_mm_per_s() > kMaxEndMmPerS) return false;
    const auto heading = track_.heading(end.distance_mm);
    if (!heading || turns_back(*stroke, end.id.tip, *heading, end.distance_mm)) return false;
    if (is_drawn_over(crossed_, end.id.stroke, end.point)) return false;
  }
  return !is_crowded(scene, end, begun_on_ ? begun_on_->stroke : StrokeId{});
}

std::optional<TipHit> InkSnap::nearest_end(const Aim& aim, const Scene& scene) const {
  std::array<TipId, kMaxCandidates> seen;
  for (std::size_t count = 0; count < kMaxCandidates; ++count) {
    const auto hit = scene.index.nearest_tip(scene.document, track_.pen(), aim.within_mm,
                                             std::span(seen).first(count));
    if (!hit) break;
    const bool is_begun_on = begun_on_ && begun_on_->stroke == hit->id.stroke;
    const bool is_left = aim.felt && last_ == hit->id.stroke;
    if (!is_begun_on && !is_left && is_heading_for(hit->point, aim) && may_join(*hit, scene))
      return hit;
    seen[count] = hit->id;
  }
  return std::nullopt;
}

/// Returns the first of these targets that applies: the start of the line being drawn, the other
/// end of the line on which it was begun, an end of another line, or a point on a line just ahead.
std::optional<SnapTarget> InkSnap::find(const Aim& aim, double meet_mm, const Scene& scene) const {
  if (is_drawing_ && is_closing(track_.start(), {}, aim)) return SnapTarget{{}, track_.start()};
  if (begun_on_) {
    const TipId other{begun_on_->stroke, opposite(begun_on_->tip)};
    const StrokePtr stroke = stroke_with_tip(scene.document, other);
    const Point at = stroke ? tip_point(*stroke, other.tip) : Point{};
    const double gap = distance(track_.pen(), at);
    if (stroke && is_closing(at, begun_part_, aim) && may_join({other, at, gap}, scene)) {
      return SnapTarget{other, at};
    }
  }
  if (const auto end = nearest_end(aim, scene)) return SnapTarget{end->id, end->point};
  return is_drawing_ ? find_curve(meet_mm, scene) : std::nullopt;
}

std::optional<SnapTarget> InkSnap::find_curve(double within_mm, const Scene& scene) const {
  const double length = track_.length_mm();
  if (length < kClearMm || track_.speed_mm_per_s() > kMaxMeetMmPerS) return std::nullopt;
  if (last_crossing_mm_ && length - *last_crossing_mm_ < kClearMm) return std::nullopt;
  const auto heading = track_.heading(0.0);
  if (!heading) return std::nullopt;
  const auto hit = first_hit(scene, track_.pen(), *heading, kClearMm);
  if (!hit || hit->hits > 1 || hit->distance_mm > within_mm || hit->angle_deg < kMeetDeg) {
    return std::nullopt;
  }
  return SnapTarget{{hit->stroke}, hit->point, true};
}

bool InkSnap::may_begin_on(const TipId& end, const Scene& scene) const {
  const StrokePtr stroke = stroke_with_tip(scene.document, end);
  if (!stroke) return false;
  const Point at = tip_point(*stroke, end.tip);
  const Vec direction = *track_.first_direction();
  const double gap = distance(at, track_.start());
  if (turns_back(*stroke, end.tip, -direction, gap)) return false;
  const Vec outward = -inward_direction(*stroke, end.tip);
  if (angle_between(direction, outward) * kDegPerRad < kDashDeg &&
      dot(track_.start() - at, outward) > kDashMm) {
    return false;
  }
  if (is_drawn_over(crossed_, end.stroke, at)) return false;
  const bool closes_both = target_ && !target_->on_curve && target_->tip.stroke == end.stroke;
  if (gap > kStartShare * options_.radius_mm && !closes_both) return false;
  return !is_crowded(scene, {end, at}, StrokeId{});
}

/// Returns the end on which the line was begun. If there is none, returns a point on another line
/// just behind the start of the line.
std::optional<SnapTarget> InkSnap::find_start(const Scene& scene) const {
  const auto direction = track_.first_direction();
  if (!direction || track_.extent_mm() < kDotMm) return std::nullopt;
  if (begun_on_ && may_begin_on(*begun_on_, scene)) {
    const StrokePtr stroke = scene.document.find(begun_on_->stroke);
    return SnapTarget{*begun_on_, tip_point(*stroke, begun_on_->tip)};
  }
  if (track_.length_mm() < kClearMm) return std::nullopt;
  if (first_crossing_mm_ && *first_crossing_mm_ < kClearMm) return std::nullopt;
  const auto hit = first_hit(scene, track_.start(), -*direction, kClearMm);
  const double within = kMeetShare * options_.radius_mm;
  if (!hit || hit->hits > 1 || hit->distance_mm > within || hit->angle_deg < kMeetDeg) {
    return std::nullopt;
  }
  return SnapTarget{{hit->stroke}, hit->point, true};
}

void InkSnap::follow_rest(std::int64_t time_ns) noexcept {
  if (track_.speed_mm_per_s() > (rests_ ? kLeavesMmPerS : kRestMmPerS)) {
    slow_since_ns_ = time_ns;
    rests_ = false;
  }
  // Subtracts in double, because the difference of two arbitrary times may not fit into 64 bits.
  const double slow_ns = static_cast<double>(time_ns) - static_cast<double>(slow_since_ns_);
  rests_ = rests_ || slow_ns >= kRestNs;
}

void InkSnap::find_attraction(const Scene& scene) {
  if (!attracts(options_.mode)) {
    attraction_.reset();
    return;
  }
  if (attraction_) {
    const double gap = distance(track_.pen(), attraction_->point);
    const bool stays = is_still_there(*attraction_, scene.document) &&
                       track_.speed_mm_per_s() <= kMaxEndMmPerS &&
                       gap <= std::min(options_.reach_mm, closest_mm_ + kLeaveMm);
    closest_mm_ = std::min(closest_mm_, gap);
    if (stays) return;
    attraction_.reset();
  }
  if (!is_slow(options_.reach_mm)) return;
  const Aim on_surface{options_.reach_mm, 25.0, 0.4, options_.reach_mm, 0.0, true};
  const Aim in_air{std::min(options_.reach_mm, kAirReachMm), 12.0, 0.3, 0.0, 0.0, true};
  auto found =
      find(is_drawing_ ? on_surface : in_air, 2.0 * kMeetShare * options_.radius_mm, scene);
  if (!found) return;
  closest_mm_ = distance(track_.pen(), found->point);
  if (is_slow(closest_mm_)) attraction_ = found;
}

}  // namespace felt
