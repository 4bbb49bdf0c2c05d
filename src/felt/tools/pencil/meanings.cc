#include "felt/tools/pencil/meanings.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "felt/document/document.h"
#include "felt/document/edit_builder.h"
#include "felt/document/stroke_index.h"
#include "felt/recognise/double_loop.h"
#include "felt/recognise/scratch_out.h"

namespace felt {
namespace {

/// Returns points along a stroke, close enough to see how much of it is in an area.
std::vector<Point> probes_of(const Stroke& stroke) {
  constexpr int kPerSegment = 6;
  std::vector<Point> points;
  for (int i = 0; i < stroke.segment_count(); ++i) {
    const Cubic curve = stroke.segment(i);
    for (int k = 0; k < kPerSegment; ++k) {
      points.push_back(evaluate(curve, static_cast<double>(k) / kPerSegment));
    }
  }
  points.push_back(stroke.position(stroke.segment_count()));
  return points;
}

/// Returns the strokes for which is_meant(points) is true, and the box around them.
template <class IsMeant>
std::vector<StrokeId> strokes_meant(const Scene& scene, const Rect& area, Rect& box,
                                    IsMeant is_meant) {
  std::vector<StrokeId> found;
  for (const StrokeId id : scene.index.strokes_in(area)) {
    const StrokePtr stroke = scene.document.find(id);
    if (!stroke || !is_meant(probes_of(*stroke))) continue;
    found.push_back(id);
    box.extend(stroke->bounds());
  }
  return found;
}

std::optional<OfferChoice> crossed_out(std::span<const Point> path, const Scene& scene) {
  const std::optional<ScratchOut> scratch = ScratchOut::find(path);
  if (!scratch) return std::nullopt;
  Rect box;
  const std::vector<StrokeId> covered =
      strokes_meant(scene, scratch->bounds(), box,
                    [&](const std::vector<Point>& line) { return scratch->covers(line); });
  if (covered.empty() || !scratch->is_about(box)) return std::nullopt;
  EditBuilder builder(scene.document);
  for (const StrokeId id : covered) builder.remove(id);
  return OfferChoice{OfferKind::kDelete, covered.size(), std::move(builder).build("Scratch out"),
                     std::nullopt};
}

std::optional<OfferChoice> enclosed(std::span<const Point> path, const Scene& scene) {
  const std::optional<DoubleLoop> loop = DoubleLoop::find(path);
  if (!loop) return std::nullopt;
  Rect box;
  const std::vector<StrokeId> inside =
      strokes_meant(scene, loop->bounds(), box,
                    [&](const std::vector<Point>& line) { return loop->encloses(line); });
  if (inside.empty() || !loop->is_about(box)) return std::nullopt;
  Selection selection;
  for (const StrokeId id : inside) {
    selection.set_whole(id, scene.document.find(id)->data().points.size());
  }
  return OfferChoice{OfferKind::kSelect, inside.size(), {}, std::move(selection)};
}

}  // namespace

std::optional<Offer> line_meanings(std::span<const Point> path, const Edit& ink,
                                   const GestureOptions& options, const Scene& scene) {
  if (path.empty() || ink.empty()) return std::nullopt;
  Offer offer;
  offer.at = path.back();
  if (options.scratch_out) {
    if (auto choice = crossed_out(path, scene)) offer.choices.push_back(*std::move(choice));
  }
  if (options.double_loop) {
    if (auto choice = enclosed(path, scene)) offer.choices.push_back(*std::move(choice));
  }
  if (offer.choices.empty()) return std::nullopt;
  offer.chosen = offer.choices.size();
  offer.choices.push_back({OfferKind::kInk, 0, ink, std::nullopt});
  return offer;
}

}  // namespace felt
