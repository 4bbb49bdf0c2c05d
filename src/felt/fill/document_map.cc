#include "felt/fill/document_map.h"

#include <map>
#include <vector>

namespace felt {

FillMap* DocumentMap::after(const Document& document, const Edit& edit, const Rect& area) {
  std::map<StrokeId, StrokePtr> wanted;
  for (const Layer& layer : document.layers()) {
    if (strokes_ == Of::kVisibleStrokes && !layer.visible) continue;
    for (const StrokeId id : layer.strokes) wanted.emplace_hint(wanted.end(), id, nullptr);
  }
  for (auto& [id, stroke] : wanted) stroke = document.find(id);
  for (const StrokeChange& change : edit.changes) wanted[change.id] = change.after;
  if (wanted.size() > kMaxStrokes) {
    std::erase_if(wanted, [&area](const auto& entry) {
      return entry.second && !entry.second->bounds().intersects(area);
    });
    if (wanted.size() > kMaxNearStrokes) return nullptr;
  }
  std::vector<FillLine> changes;
  for (const auto& [id, line] : map_.meetings().lines()) {
    if (!wanted.contains(id)) changes.push_back({id, nullptr});
  }
  for (auto& [id, stroke] : wanted) {
    const MeetingLine* known = map_.meetings().find(id);
    if (stroke != (known ? known->stroke : nullptr)) changes.push_back({id, std::move(stroke)});
  }
  map_.update(changes);
  return &map_;
}

}  // namespace felt
