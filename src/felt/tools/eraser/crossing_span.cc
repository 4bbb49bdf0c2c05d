#include "felt/tools/eraser/crossing_span.h"

#include <algorithm>
#include <cmath>

#include "felt/document/stroke_index.h"
#include "felt/geometry/intersect.h"
#include "felt/geometry/nearest.h"

namespace felt {
namespace {

/// A crossing within kHere of the touched parameter does not count on either side.
constexpr double kHere = 1e-9;
/// Neighbouring segments always meet at their joint. Crossings within kSameCrossingMm of the joint
/// count as the joint.
constexpr double kSameCrossingMm = 0.01;

}  // namespace

const std::vector<double>* StrokeCrossings::on_segment(int segment, const Scene& scene,
                                                       int& budget) {
  const auto known = found_.find(segment);
  if (known != found_.end()) return &known->second;
  if (work_.segment != segment) {
    start(segment, scene);
    budget -= 10 + static_cast<int>(work_.candidates.size());
  }
  while (work_.next < work_.candidates.size()) {
    if (budget <= 0) return nullptr;
    meet(work_.candidates[work_.next++], scene, budget);
  }
  std::sort(work_.places.begin(), work_.places.end());
  work_.segment = -1;
  return &(found_[segment] = std::move(work_.places));
}

void StrokeCrossings::start(int segment, const Scene& scene) {
  work_ = {.segment = segment, .candidates = {}, .next = 0, .places = {}};
  const Rect area = bounds(stroke_->segment(segment)).inflated(kTeeMm);
  scene.index.for_each_segment_in(area, [&](StrokeId stroke, int i) {
    if (stroke != id_ || i != segment) work_.candidates.push_back({stroke, i});
  });
  // Sorts the candidates, because the order of the index is not defined.
  std::sort(work_.candidates.begin(), work_.candidates.end());
  meet_itself();
}

void StrokeCrossings::meet_itself() {
  if (const auto loop = self_intersection(stroke_->segment(work_.segment))) {
    // A closed stroke of one segment meets itself at its seam, which is not a crossing.
    const bool seam = stroke_->closed() && stroke_->segment_count() == 1 && loop->t1 < 1e-6 &&
                      loop->t2 > 1.0 - 1e-6;
    if (seam) return;
    work_.places.push_back(work_.segment + loop->t1);
    work_.places.push_back(work_.segment + loop->t2);
  }
}

bool StrokeCrossings::is_at_shared_joint(const Candidate& with, double t, Point at) const {
  if (with.stroke != id_) return false;
  const int n = stroke_->segment_count(), i = work_.segment;
  const Cubic mine = stroke_->segment(i);
  const auto is_next = [&](int a, int b) {
    return b == a + 1 || (stroke_->closed() && a == n - 1 && b == 0);
  };
  const auto is_near = [&](Point joint, double t0, double t1) {
    return distance(at, joint) <= kSameCrossingMm &&
           control_length(sub_segment(mine, t0, t1)) <= kSameCrossingMm;
  };
  return (is_next(i, with.segment) && is_near(mine.p[3], t, 1.0)) ||
         (is_next(with.segment, i) && is_near(mine.p[0], 0.0, t));
}

void StrokeCrossings::meet(const Candidate& with, const Scene& scene, int& budget) {
  const StrokePtr other = scene.document.find(with.stroke);
  if (!other || with.segment >= other->segment_count()) return;
  const Cubic mine = stroke_->segment(work_.segment);
  const Crossings met = intersections(mine, other->segment(with.segment), kMaxPairs);
  budget -= 3 + met.pairs;
  for (const Crossing& c : met) {
    if (!is_at_shared_joint(with, c.t1, c.point)) work_.places.push_back(work_.segment + c.t1);
  }
  meet_tips(with, *other, mine);
}

void StrokeCrossings::meet_tips(const Candidate& with, const Stroke& other, const Cubic& mine) {
  if (other.closed()) return;
  if (with.stroke == id_ && std::abs(with.segment - work_.segment) <= 1) return;
  const auto meet_tip = [&](Point tip) {
    const auto hit = nearest_within(mine, tip, kTeeMm * kTeeMm);
    if (!hit) return;
    // If the end of the other stroke extends beyond this curve, the crossing is already in the
    // list.
    for (const double u : work_.places) {
      if (distance(stroke_->position(u), tip) <= kTeeMm) return;
    }
    // The nearest point may be on a neighbouring segment.
    const int next = work_.segment + (hit->t <= 0.0 ? -1 : hit->t >= 1.0 ? 1 : 0);
    if (next != work_.segment && next >= 0 && next < stroke_->segment_count() &&
        nearest(stroke_->segment(next), tip).distance_squared < hit->distance_squared) {
      return;
    }
    work_.places.push_back(work_.segment + hit->t);
  };
  if (with.segment == 0) meet_tip(other.segment(0).p[0]);
  if (with.segment == other.segment_count() - 1) meet_tip(other.segment(with.segment).p[3]);
}

bool SpanSearch::advance(StrokeCrossings& crossings, const Scene& scene, int& budget) {
  if (!left_done_ && !go_left(crossings, scene, budget)) return false;
  if (!right_done_ && !go_right(crossings, scene, budget)) return false;
  const Stroke& stroke = crossings.stroke();
  if (!stroke.closed() && from_ <= 0.0 && to_ >= stroke.segment_count()) whole_ = true;
  // Both sides have reached the same crossing, which is the only one.
  if (stroke.closed() && std::fabs(from_ - to_) <= kHere) whole_ = true;
  return true;
}

bool SpanSearch::go_left(StrokeCrossings& crossings, const Scene& scene, int& budget) {
  const Stroke& stroke = crossings.stroke();
  const int n = stroke.segment_count();
  const int start = std::clamp(static_cast<int>(from_), 0, n - 1);
  for (const int last = stroke.closed() ? n : start; left_ <= last; ++left_) {
    const auto* places = crossings.on_segment((start - left_ + n) % n, scene, budget);
    if (!places) return false;
    // Finds the largest parameter; on the first segment, the largest one before the touch.
    auto end = places->end();
    if (left_ == 0) end = std::lower_bound(places->begin(), end, from_ - kHere);
    if (end == places->begin()) continue;
    from_ = *(end - 1);
    left_done_ = true;
    return true;
  }
  left_done_ = true;
  if (stroke.closed()) {
    whole_ = right_done_ = true;
  } else {
    from_ = 0.0;
  }
  return true;
}

bool SpanSearch::go_right(StrokeCrossings& crossings, const Scene& scene, int& budget) {
  const Stroke& stroke = crossings.stroke();
  const int n = stroke.segment_count();
  const int start = std::clamp(static_cast<int>(to_), 0, n - 1);
  for (const int last = stroke.closed() ? n : n - 1 - start; right_ <= last; ++right_) {
    const auto* places = crossings.on_segment((start + right_) % n, scene, budget);
    if (!places) return false;
    auto first = places->begin();
    if (right_ == 0) first = std::upper_bound(first, places->end(), to_ + kHere);
    if (first == places->end()) continue;
    to_ = *first;
    right_done_ = true;
    return true;
  }
  right_done_ = true;
  to_ = n;
  return true;
}

}  // namespace felt
