#include "felt/tools/stroke_hold.h"

#include <cmath>
#include <limits>

#include "felt/document/stroke_index.h"
#include "felt/geometry/nearest.h"

namespace felt {
namespace {

/// Accuracy of arc lengths. A pen resolves only 0.03 mm.
constexpr double kArcAccuracyMm = 1e-5;

}  // namespace

bool StrokeHold::take(const Scene& scene, Point pen) {
  const auto hit = scene.index.nearest(pen, kReachMm);
  if (!hit) {
    release();
    return false;
  }
  StrokePtr stroke = scene.document.find(hit->stroke);
  if (stroke != stroke_) {
    map_ = std::make_unique<ArcMap>(*stroke, kArcAccuracyMm);
    stroke_ = std::move(stroke);
  }
  id_ = hit->stroke;
  pen_ = pen;
  is_near_ = true;
  go_to(hit->u);
  way_mm_.reset();
  return true;
}

void StrokeHold::release() noexcept {
  map_.reset();
  stroke_.reset();
  way_mm_.reset();
  is_near_ = false;
}

void StrokeHold::go_to(double u) noexcept {
  place_ = {u, map_->length_at(u), stroke_->position(u)};
}

double StrokeHold::find_near(Point pen, double window_mm, double& u) const noexcept {
  const int n = stroke_->segment_count();
  const bool closed = stroke_->closed();
  double best = std::numeric_limits<double>::infinity();
  const auto look_at = [&](int i) {
    const auto found = nearest_within(stroke_->segment(i), pen, best);
    if (!found || !(found->distance_squared < best)) return;
    best = found->distance_squared;
    u = i + found->t;
  };
  const int here = std::min(static_cast<int>(place_.u), n - 1);
  look_at(here);
  // Searches outwards in both directions until the window ends or, on a closed stroke, until both
  // directions meet.
  double ahead = map_->start_of(here + 1) - place_.length_mm;
  double behind = place_.length_mm - map_->start_of(here);
  const auto length_of = [&](int i) { return map_->start_of(i + 1) - map_->start_of(i); };
  int last = here, first = here, left = n - 1;
  while (left > 0) {
    const bool on = ahead < window_mm && (closed || last + 1 < n);
    const bool back = behind < window_mm && (closed || first > 0);
    if (!on && !back) break;
    if (on) {
      last = (last + 1) % n;
      look_at(last);
      ahead += length_of(last);
      --left;
    }
    if (back && left > 0) {
      first = (first + n - 1) % n;
      look_at(first);
      behind += length_of(first);
      --left;
    }
  }
  return std::sqrt(best);
}

bool StrokeHold::follow(const Scene& scene, Point pen) {
  const double step = distance(pen_, pen);
  const bool was_near = is_near_;
  const double from = place_.length_mm;
  pen_ = pen;
  double u = place_.u;
  way_mm_.reset();
  is_near_ = find_near(pen, kWindowMm + 2.0 * step, u) <= kReachMm;
  if (is_near_) {
    go_to(u);
    if (was_near) way_mm_ = map_->way(from, place_.length_mm);
    return true;
  }
  const auto hit = scene.index.nearest(pen, kReachMm);
  is_near_ = hit && hit->stroke == id_;
  if (is_near_) go_to(hit->u);
  return is_near_;
}

}  // namespace felt
