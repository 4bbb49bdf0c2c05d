#include "felt/tools/eraser/eraser_aim.h"

#include <algorithm>

#include "felt/document/stroke_index.h"
#include "felt/tools/eraser/eraser_gesture.h"

namespace felt {

void EraserAim::clear() {
  marks_.clear();
  crossings_.reset();
  search_.reset();
}

void EraserAim::update(Point pen, std::int64_t time_ns, EraserMode mode,
                       const EraserSettings& settings, const Scene& scene) {
  if (mode == EraserMode::kCrossing) {
    // Computed in double, because the difference of two invalid times may overflow 64 bits.
    const double age = static_cast<double>(time_ns) - static_cast<double>(since_ns_);
    if (!(age >= 0.0 && age < static_cast<double>(kFreshNs))) {
      clear();
      since_ns_ = time_ns;
    }
    aim_at_part(pen, settings, scene);
  } else {
    clear();
    if (mode == EraserMode::kStroke) aim_at_strokes(pen, settings, scene);
  }
}

bool EraserAim::is_marked(double u) const noexcept {
  return std::any_of(marks_.begin(), marks_.end(), [&](const Mark& m) {
    return m.from < m.to ? u >= m.from && u <= m.to : u >= m.from || u <= m.to;
  });
}

void EraserAim::aim_at_part(Point pen, const EraserSettings& settings, const Scene& scene) {
  const auto hit = aimed_at(pen, settings, scene);
  const StrokePtr stroke = hit ? scene.document.find(hit->stroke) : nullptr;
  if (!stroke) {
    clear();
    return;
  }
  if (!crossings_ || crossings_->id() != hit->stroke || crossings_->pointer() != stroke) {
    clear();
    crossings_.emplace(hit->stroke, stroke);
  }
  if (is_marked(hit->u)) return;
  marks_.clear();
  if (!search_) {
    search_.emplace(ParameterSet::Interval{hit->u, hit->u});
  }
  int budget = EraserGesture::kCrossingBudget;
  if (!search_->advance(*crossings_, scene, budget)) return;
  const double n = stroke->segment_count();
  const bool whole = search_->is_whole();
  marks_.push_back({stroke, whole ? 0.0 : search_->from(), whole ? n : search_->to()});
  search_.reset();
}

void EraserAim::aim_at_strokes(Point pen, const EraserSettings& settings, const Scene& scene) {
  const Capsule ring{pen, pen, settings.radius_mm, settings.include_width};
  std::vector<StrokeId> met;
  ParameterSet covered;
  const auto visit = [&](StrokeId id, int segment) {
    if (met.size() >= kMaxMarked || std::find(met.begin(), met.end(), id) != met.end()) return;
    const StrokePtr stroke = scene.document.find(id);
    if (stroke && add_swept(*stroke, segment, ring, covered)) met.push_back(id);
    covered = {};
  };
  if (ring.adds_half_width) {
    scene.index.for_each_ink_in(ring.bounds(), visit);
  } else {
    scene.index.for_each_segment_in(ring.bounds(), visit);
  }
  std::sort(met.begin(), met.end());
  for (const StrokeId id : met) {
    const StrokePtr stroke = scene.document.find(id);
    marks_.push_back({stroke, 0.0, static_cast<double>(stroke->segment_count())});
  }
}

void EraserAim::draw(Overlay& overlay) const {
  for (const Mark& m : marks_) add_span(overlay, *m.stroke, m.from, m.to, Overlay::Role::kCut);
}

}  // namespace felt
