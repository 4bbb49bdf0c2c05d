#include "felt/document/drawing.h"

#include <tuple>

#include "felt/document/visible_strokes.h"

namespace felt {

bool operator==(const Drawing& a, const Drawing& b) {
  const auto rest = [](const Drawing& d) {
    return std::tie(d.document, d.page, d.has_page, d.color, d.layer, d.palette, d.view,
                    d.materials);
  };
  const bool same_extras =
      a.extras == b.extras || (a.extras && b.extras && a.extras->equals(*b.extras));
  return same_extras && rest(a) == rest(b) && used_names(a) == used_names(b);
}

StrokeNames used_names(const Drawing& drawing) {
  StrokeNames names;
  if (!drawing.names) return names;
  for (const auto& [id, name] : *drawing.names) {
    if (drawing.document.find(id)) names.emplace_hint(names.end(), id, name);
  }
  return names;
}

std::string name_in_file(const Drawing& drawing, StrokeId id) {
  if (drawing.names) {
    if (const auto named = drawing.names->find(id); named != drawing.names->end()) {
      return named->second;
    }
  }
  return stroke_name(id);
}

}  // namespace felt
