#include "felt/formats/lost_objects.h"

#include "felt/formats/format_traits.h"

namespace felt {

LostObjects lost_objects(const Document& document, FileFormat format, bool compact) {
  const FormatTraits& traits = traits_of(format);
  const bool has_fills = format == FileFormat::kFelt || traits.picture;
  const bool has_pictures = format == FileFormat::kFelt || (traits.picture && !compact);
  const bool has_blends = has_fills || format == FileFormat::kInkml;
  const bool has_groups = !traits.layers || compact || has_blends;
  const bool is_picture = traits.picture && (!traits.layers || compact);
  const bool has_motion = format == FileFormat::kFelt || is_picture;
  const LayerGroup* last = nullptr;
  LostObjects lost;
  if (!has_motion) lost.body_edits = document.body_edits().size();
  for (const Layer& layer : document.layers()) {
    if (!layer.visible && !traits.layers) continue;
    if (!has_fills) lost.fills += layer.fills.size();
    if (!has_pictures && layer.picture) ++lost.pictures;
    if (!has_motion && layer.timing) ++lost.timings;
    const bool begins_group = layer.group && (!last || last->id != layer.group->id);
    last = layer.group.get();
    if (!has_groups && begins_group) ++lost.groups;
    if (has_blends) continue;
    if (layer.blend != BlendMode::kNormal) ++lost.blends;
    if (begins_group && layer.group->blend != BlendMode::kNormal) ++lost.blends;
  }
  return lost;
}

}  // namespace felt
