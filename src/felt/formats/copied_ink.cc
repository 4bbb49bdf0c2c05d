#include "felt/formats/copied_ink.h"

#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "felt/formats/drawing_materials.h"
#include "felt/io/drawing_builder.h"
#include "felt/stroke/edit/mend_joints.h"

namespace felt {
namespace {

/// Adds the fills of visible layers for which `goes_along` is true to a layer of a new drawing.
void add_copied_fills(const Document& document, const std::function<bool(const Fill&)>& goes_along,
                      std::size_t to, DrawingBuilder& builder) {
  for (const Layer& layer : document.layers()) {
    if (!layer.visible) continue;
    for (const FillId id : layer.fills) {
      const FillPtr fill = document.find_fill(id);
      if (goes_along(*fill)) builder.add_fill(to, fill, fill_name(id));
    }
  }
}

}  // namespace

Drawing copied_drawing(const Session& session, const std::function<bool(StrokeId)>& is_copied) {
  const Document& document = session.seen();
  DrawingBuilder builder;
  const std::size_t kept = builder.add_layer({"Ink"});
  std::set<std::string> media;
  std::set<StrokeId> kept_ids;
  for (const Layer& layer : document.layers()) {
    if (!layer.visible) continue;
    for (const StrokeId id : layer.strokes) {
      if (!is_copied(id)) continue;
      kept_ids.insert(id);
      const StrokePtr stroke = document.find(id);
      media.insert(stroke->medium());
      builder.add(kept, stroke, id);
    }
  }
  const bool is_all = session.selection().empty();
  const auto goes_along = [&](const Fill& fill) {
    return goes_with_strokes(fill, [&](StrokeId id) { return kept_ids.contains(id); }) ||
           (is_all && !goes_with_strokes(fill, [](StrokeId) { return true; }));
  };
  add_copied_fills(document, goes_along, kept, builder);
  const std::vector<std::string> ids(media.begin(), media.end());
  builder.drawing().materials = texts_of_used(Document(), {}, session.materials(), ids);
  return std::move(builder).build();
}

VisibleInk moved_ink(VisibleInk ink, Vec by_mm) {
  if (by_mm == Vec{}) return ink;
  for (StrokePtr& s : ink.strokes) {
    StrokeData data = s->data();
    for (Point& p : data.points) p = p + by_mm;
    mend_rounding(data);
    if (Result<Stroke> stroke = Stroke::create(std::move(data))) {
      s = std::make_shared<const Stroke>(*std::move(stroke));
    }
  }
  for (FillPtr& f : ink.fills) {
    Fill fill = *f;
    for (FillLoop& loop : fill.loops) {
      for (Point& point : loop.points) point = point + by_mm;
    }
    f = std::make_shared<const Fill>(std::move(fill));
  }
  return ink;
}

}  // namespace felt
