#include "felt/tools/eraser/eraser_gesture.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "felt/document/stroke_index.h"
#include "felt/stroke/drawn_profile.h"
#include "felt/stroke/edit/hold_profile.h"
#include "felt/tools/eraser/kept_widths.h"

namespace felt {
namespace {

/// Returns the stroke with the drawn widths as breakpoints, so that the widths of a part can change
/// without the rest. If that needs no breakpoint, returns the stroke itself.
StrokePtr as_drawn(const StrokePtr& stroke) {
  StrokeData data = stroke->data();
  data.widths = drawn_knots(*stroke, 0.1 * InkNarrowing::kWidthErrorMm);
  if (data.widths.size() == stroke->widths().size()) return stroke;
  auto drawn = Stroke::create(std::move(data));
  return drawn ? std::make_shared<const Stroke>(*std::move(drawn)) : stroke;
}

}  // namespace

std::optional<StrokeHit> aimed_at(Point pen, const EraserSettings& settings, const Scene& scene) {
  const double more = settings.include_width ? scene.index.widest_half_mm() : 0.0;
  const auto hit = scene.index.nearest(pen, settings.radius_mm + more);
  if (!hit || !settings.include_width) return hit;
  const StrokePtr stroke = scene.document.find(hit->stroke);
  const double half_width = stroke ? 0.5 * drawn_width_mm(*stroke, hit->u) : 0.0;
  return hit->distance_mm < settings.radius_mm + half_width ? hit : std::nullopt;
}

bool EraserGesture::begin(Point pen, std::int64_t time_ns, const Scene& scene) {
  pen_ = pen;
  time_ns_ = shown_ns_ = time_ns;
  if (mode_ == EraserMode::kCrossing) {
    if (const auto hit = aimed_at(pen, settings_, scene)) {
      const ParameterSet::Interval at{hit->u, hit->u};
      pending_.push_back({hit->stroke, at, SpanSearch(at)});
    }
  } else {
    sweep(pen, pen, scene);
  }
  search(kCrossingBudget, scene);
  cut(kMaxCuts, time_ns, scene);
  return std::exchange(changed_, false);
}

bool EraserGesture::move(Point pen, std::int64_t time_ns, const Scene& scene) {
  const Point from = std::exchange(pen_, pen);
  if (from != pen) sweep(from, pen, scene);
  search(kCrossingBudget, scene);
  // Computed in double, because the difference of two invalid times may overflow 64 bits.
  const double ms = 1e-6 * (static_cast<double>(time_ns) - static_cast<double>(time_ns_));
  time_ns_ = time_ns;
  cut(static_cast<int>(std::clamp(kCutsPerMs * ms, 1.0 * kCutsPerMs, 1.0 * kMaxCuts)), time_ns,
      scene);
  return shows(time_ns);
}

bool EraserGesture::press_through(std::int64_t time_ns, const Scene& scene) {
  mode_ = EraserMode::kStroke;
  pending_.clear();
  sweep(pen_, pen_, scene);
  cut(kMaxCuts, time_ns, scene);
  return std::exchange(changed_, false);
}

bool EraserGesture::shows(std::int64_t time_ns) {
  if (!changed_) return false;
  const double many = static_cast<double>(divisions_.size());
  const double pause = std::clamp(static_cast<double>(kShowNsPerStroke) * many,
                                  static_cast<double>(kShowNs), static_cast<double>(kMaxShowNs));
  const double since = static_cast<double>(time_ns) - static_cast<double>(shown_ns_);
  if (since >= 0.0 && since < pause) return false;
  shown_ns_ = time_ns;
  changed_ = false;
  return true;
}

void EraserGesture::finish(const Scene& scene) {
  search(std::numeric_limits<int>::max(), scene);
  while (!to_cut_.empty()) cut_next(time_ns_, scene);
}

void EraserGesture::sweep(Point from, Point to, const Scene& scene) {
  const bool crossing = mode_ == EraserMode::kCrossing;
  const Capsule capsule{from, to, crossing ? kPointMm : settings_.radius_mm,
                        settings_.include_width && !crossing, from != to && !crossing};
  looked_at_ = nullptr;
  const std::size_t before = pending_.size();
  const auto visit = [&](StrokeId id, int segment) { meet(id, segment, capsule, scene); };
  if (capsule.adds_half_width) {
    scene.index.for_each_ink_in(capsule.bounds(), visit);
  } else {
    scene.index.for_each_segment_in(capsule.bounds(), visit);
  }
  // Sorts them, so that the order does not depend on the index.
  std::sort(pending_.begin() + static_cast<std::ptrdiff_t>(before), pending_.end(),
            [](const Pending& a, const Pending& b) {
              return a.stroke != b.stroke ? a.stroke < b.stroke : a.touched.from < b.touched.from;
            });
}

void EraserGesture::meet_touched(StrokeId id, int segment, const Capsule& capsule,
                                 const Scene& scene) {
  const auto known = lines_.find(id);
  // The drawn ink may be wider than that of equation (3), so the line is made before it is touched.
  const StrokePtr& stroke = known != lines_.end()     ? known->second.stroke
                            : settings_.include_width ? line_of(id, scene).stroke
                                                      : looked_at(id, scene);
  covered_ = {};
  if (!stroke || !add_swept(*stroke, segment, capsule, covered_)) return;
  Line& line = line_of(id, scene);
  bool changed = false;
  if (line.ink) {
    changed = line.ink->add(segment, covered_, capsule);
  } else {
    for (const auto& part : covered_.intervals()) changed |= line.erased.add(part);
  }
  if (changed) mark(id, line);
}

const StrokePtr& EraserGesture::looked_at(StrokeId id, const Scene& scene) {
  if (!looked_at_ || looked_at_id_ != id) {
    looked_at_ = scene.document.find(id);
    looked_at_id_ = id;
  }
  return looked_at_;
}

void EraserGesture::meet(StrokeId id, int segment, const Capsule& capsule, const Scene& scene) {
  if (guard_ && guard_->is_guarded(id)) return;
  const auto known = lines_.find(id);
  const double u = segment;
  if (known != lines_.end() && known->second.erased.contains({u, u + 1.0})) return;
  if (mode_ == EraserMode::kTouched) {
    meet_touched(id, segment, capsule, scene);
    return;
  }
  covered_ = {};
  if (!looked_at(id, scene) || !add_swept(*looked_at_, segment, capsule, covered_)) return;
  if (mode_ == EraserMode::kStroke) {
    erase(id, {0.0, static_cast<double>(looked_at_->segment_count())}, scene);
    return;
  }
  for (const auto& part : covered_.intervals()) pending_.push_back({id, part, SpanSearch(part)});
}

EraserGesture::Line& EraserGesture::line_of(StrokeId id, const Scene& scene) {
  const auto known = lines_.find(id);
  if (known != lines_.end()) return known->second;
  const StrokePtr stroke = scene.document.find(id);
  if (mode_ == EraserMode::kTouched && settings_.include_width) {
    return lines_.try_emplace(id, stroke, as_drawn(stroke), settings_.radius_mm).first->second;
  }
  return lines_.try_emplace(id, stroke).first->second;
}

void EraserGesture::mark(StrokeId id, Line& line) {
  if (!std::exchange(line.waits, true)) to_cut_.push_back(id);
}

void EraserGesture::erase(StrokeId id, ParameterSet::Interval part, const Scene& scene) {
  Line& line = line_of(id, scene);
  if (line.erased.add(part)) mark(id, line);
}

/// Processes the pending touches in order until the budget is used up. For each touch, finds the
/// span between the crossings around it and erases it.
void EraserGesture::search(int budget, const Scene& scene) {
  while (!pending_.empty() && budget > 0) {
    Pending& next = pending_.front();
    Line& line = line_of(next.stroke, scene);
    if (!line.erased.contains(next.touched)) {
      if (!line.crossings) line.crossings.emplace(next.stroke, line.stroke);
      if (!next.search.advance(*line.crossings, scene, budget)) return;
      const double n = line.stroke->segment_count();
      const double from = next.search.from(), to = next.search.to();
      if (next.search.is_whole()) {
        erase(next.stroke, {0.0, n}, scene);
      } else if (from < to) {
        erase(next.stroke, {from, to}, scene);
      } else {
        erase(next.stroke, {from, n}, scene);
        erase(next.stroke, {0.0, to}, scene);
      }
    }
    pending_.pop_front();
  }
}

bool EraserGesture::Line::is_due(std::int64_t time_ns) const noexcept {
  if (!cut_ns) return true;
  // Computed in double, as in move().
  const double since = static_cast<double>(time_ns) - static_cast<double>(*cut_ns);
  return since < 0.0 ||
         since >= static_cast<double>(kCutPauseNs) +
                      static_cast<double>(kCutPauseNsPerPlace) * static_cast<double>(cut_places);
}

void EraserGesture::cut(int max_cuts, std::int64_t time_ns, const Scene& scene) {
  const auto waiting = std::min<std::size_t>(to_cut_.size(), kMaxWaiting);
  for (std::size_t k = 0; k < waiting && max_cuts > 0; ++k) {
    if (lines_.at(to_cut_.front()).is_due(time_ns)) {
      cut_next(time_ns, scene);
      --max_cuts;
    } else {
      to_cut_.push_back(to_cut_.front());
      to_cut_.pop_front();
    }
  }
}

void EraserGesture::cut_next(std::int64_t time_ns, const Scene& scene) {
  const StrokeId id = to_cut_.front();
  to_cut_.pop_front();
  Line& line = lines_.at(id);
  line.waits = false;
  line.cut_ns = time_ns;
  const bool is_gone = line.erased.contains({0.0, 1.0 * line.stroke->segment_count()});
  if (line.ink && !is_gone) {
    line.cut_places = line.ink->place_count();
    InkNarrowing::Result left = line.ink->result();
    line.remains.cut(left.holes, kept_widths(*line.original, *line.stroke, left));
  } else {
    line.cut_places = line.erased.intervals().size();
    line.remains.cut(line.erased);
  }
  cut_places_ += line.cut_places;
  if (line.remains.is_whole()) {
    divisions_.unset(id);
  } else {
    divisions_.set(scene.document, id, line.remains.pieces());
  }
  changed_ = true;
}

}  // namespace felt
