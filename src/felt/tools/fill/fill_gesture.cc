#include "felt/tools/fill/fill_gesture.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "felt/document/edit_builder.h"
#include "felt/fill/fill_shape.h"

namespace felt {

FillGesture::FillGesture(const Scene& scene, FillMap* map, double gap_mm, bool removes)
    : map_(map), gap_mm_(gap_mm), removes_(removes) {
  for (const Layer& layer : scene.document.layers()) {
    if (!can_fill_in(layer)) continue;
    for (const FillId id : layer.fills) {
      const FillPtr fill = scene.document.find_fill(id);
      present_.push_back({id, fill, fill_bounds(*fill)});
    }
  }
  std::reverse(present_.begin(), present_.end());
}

const FillGesture::Target* FillGesture::find(const std::vector<Target>& targets, Point p) {
  const auto found = std::find_if(targets.begin(), targets.end(), [p](const Target& target) {
    return distance_squared(target.box, p) == 0.0 && is_in_fill(*target.fill, p);
  });
  return found == targets.end() ? nullptr : &*found;
}

bool FillGesture::visit(Point p, const Scene& scene) {
  if (find(targets_, p)) return false;
  if (const Target* present = find(present_, p)) {
    targets_.push_back(*present);
    return true;
  }
  const Layer* layer = scene.document.layer(scene.layer);
  if (removes_ || !map_ || !layer || !can_fill_in(*layer)) return false;
  // Asks this first, because looking for the gap of an open area takes much longer.
  if (!map_->map(gap_mm_).loop_around(p)) return false;
  Result<FoundFill> found = map_->face_at(p, gap_mm_, scene.color);
  if (!found || !check_fill(found->fill)) return false;
  bridges_.insert(bridges_.end(), found->bridges.begin(), found->bridges.end());
  const auto fill = std::make_shared<const Fill>(std::move(found->fill));
  targets_.push_back({{}, fill, fill_bounds(*fill)});
  return true;
}

Edit FillGesture::edit(const Scene& scene) const {
  EditBuilder builder(scene.document);
  const bool again = targets_.size() == 1 && targets_.front().fill->color == scene.color;
  for (const Target& target : targets_) {
    if (!target.id) {
      builder.add_fill(scene.layer, target.fill);
    } else if (removes_ || again) {
      builder.remove_fill(target.id);
    } else if (target.fill->color != scene.color) {
      Fill recolored = *target.fill;
      recolored.color = scene.color;
      builder.replace_fill(target.id, std::make_shared<const Fill>(std::move(recolored)));
    }
  }
  return std::move(builder).build("Fill");
}

const Fill* FillGesture::area_at(Point p) const {
  const Target* target = find(targets_, p);
  return target ? target->fill.get() : nullptr;
}

}  // namespace felt
