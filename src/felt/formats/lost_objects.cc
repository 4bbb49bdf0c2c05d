#include "felt/formats/lost_objects.h"

#include "felt/formats/format_traits.h"

namespace felt {

LostObjects lost_objects(const Document& document, FileFormat format, bool compact) {
  const FormatTraits& traits = traits_of(format);
  const bool has_fills = format == FileFormat::kFelt || traits.picture;
  const bool has_pictures = format == FileFormat::kFelt || (traits.picture && !compact);
  LostObjects lost;
  for (const Layer& layer : document.layers()) {
    if (!layer.visible && !traits.layers) continue;
    if (!has_fills) lost.fills += layer.fills.size();
    if (!has_pictures && layer.picture) ++lost.pictures;
  }
  return lost;
}

}  // namespace felt
