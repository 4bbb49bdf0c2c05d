#include "felt/document/copy_limit.h"

#include <string>

namespace felt {

void InkSize::add(const Stroke& stroke) noexcept {
  ++objects;
  points += stroke.data().points.size();
}

void InkSize::add(const Fill& fill) noexcept {
  ++objects;
  for (const FillLoop& loop : fill.loops) points += loop.points.size();
}

void InkSize::add(const Document& document, const Layer& layer) {
  for (const StrokeId id : layer.strokes) add(*document.find(id));
  for (const FillId id : layer.fills) add(*document.find_fill(id));
}

Result<void> check_copies(const Document& document, InkSize copies) {
  if (copies.objects == 0) return {};
  InkSize all = copies;
  for (const Layer& layer : document.layers()) all.add(document, layer);
  if (all.objects <= kMaxCopiedObjects && all.points <= kMaxCopiedPoints) return {};
  return fail(ErrorCode::kLimitExceeded,
              "with the copies, the drawing would have " + std::to_string(all.objects) +
                  " strokes and fills with " + std::to_string(all.points) +
                  " control points; copies stop at " + std::to_string(kMaxCopiedObjects) + " and " +
                  std::to_string(kMaxCopiedPoints));
}

}  // namespace felt
