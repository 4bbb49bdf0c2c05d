#include "felt/document/edit.h"

#include <utility>

namespace felt {

Edit Edit::inverse() const {
  Edit result = *this;
  for (StrokeChange& c : result.changes) {
    std::swap(c.before, c.after);
    std::swap(c.before_place, c.after_place);
  }
  for (FillChange& c : result.fills) {
    std::swap(c.before, c.after);
    std::swap(c.before_place, c.after_place);
  }
  for (GuideChange& c : result.guides) std::swap(c.before, c.after);
  for (SymmetryChange& c : result.symmetries) std::swap(c.before, c.after);
  for (BodyEditChange& c : result.body_edits) std::swap(c.before, c.after);
  for (LayerChange& c : result.layers) {
    std::swap(c.before, c.after);
    std::swap(c.before_index, c.after_index);
  }
  return result;
}

}  // namespace felt
