#include "felt/tools/pencil/as_drawn.h"

#include <algorithm>

namespace felt {

std::optional<Edit> replaced_line(const Edit& drawn, const Edit& other) {
  if (drawn.changes.size() != other.changes.size()) return std::nullopt;
  Edit edit{.label = "As drawn", .changes = {}};
  for (const StrokeChange& old : drawn.changes) {
    const auto same = std::find_if(other.changes.begin(), other.changes.end(),
                                   [&](const StrokeChange& c) { return c.id == old.id; });
    if (same == other.changes.end() || !same->after != !old.after) return std::nullopt;
    if (!old.after) continue;  // both edits remove it
    if (same->after_place != old.after_place) return std::nullopt;
    if (*same->after == *old.after) continue;
    edit.changes.push_back({old.id, old.after, same->after, old.after_place, old.after_place});
  }
  if (edit.empty()) return std::nullopt;
  return edit;
}

}  // namespace felt
