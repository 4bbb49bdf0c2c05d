// The guides and symmetry groups of a document, which are in no layer.
#include "felt/document/document.h"

namespace felt {

DrawingGuidePtr Document::find_guide(GuideId id) const {
  const auto found = guides_.find(id);
  return found == guides_.end() ? nullptr : found->second;
}
SymmetryPtr Document::find_symmetry(SymmetryId id) const {
  const auto found = symmetries_.find(id);
  return found == symmetries_.end() ? nullptr : found->second;
}
SymmetryId Document::symmetry_of(StrokeId id) const {
  const auto found = symmetry_of_.find(id);
  return found == symmetry_of_.end() ? SymmetryId{} : found->second;
}

std::vector<DrawingGuidePtr> Document::visible_guides() const {
  std::vector<DrawingGuidePtr> visible;
  if (!shows_guides_) return visible;
  for (const auto& [id, guide] : guides_) visible.push_back(guide);
  return visible;
}

}  // namespace felt
