#include "felt/document/selection.h"

#include <algorithm>
#include <utility>

#include "felt/base/check.h"

namespace felt {
namespace {

bool all_set(const Selection::Marks& marks) {
  return std::find(marks.begin(), marks.end(), 0) == marks.end();
}

/// Gives the first and the last point of a stroke that is closed now the same mark: they are one
/// point, and were two if the edit closed the stroke.
void mark_shared_point(Selection::Marks& marks) {
  marks.front() = marks.back() = marks.front() | marks.back();
}

/// Returns true if the stroke's layer is visible and not locked. Requires that the document has it.
bool is_editable(const Document& document, StrokeId id) {
  const Layer& layer = *document.layer(document.layer_of(id));
  return layer.visible && !layer.locked;
}

}  // namespace

const Selection::Marks* Selection::find(StrokeId id) const noexcept {
  const auto found = strokes_.find(id);
  return found == strokes_.end() ? nullptr : &found->second;
}

bool Selection::is_whole(StrokeId id) const noexcept {
  const Marks* marks = find(id);
  return marks && all_set(*marks);
}

std::size_t Selection::point_count() const noexcept {
  std::size_t count = 0;
  for (const auto& [id, marks] : strokes_) {
    count += static_cast<std::size_t>(std::count(marks.begin(), marks.end(), 1));
  }
  return count;
}

void Selection::set(StrokeId id, Marks marks) {
  if (std::find(marks.begin(), marks.end(), 1) == marks.end()) {
    strokes_.erase(id);
  } else {
    strokes_[id] = std::move(marks);
  }
}

void Selection::set_whole(StrokeId id, std::size_t points) {
  set(id, Marks(points, 1));
}

void Selection::remove(StrokeId id) {
  strokes_.erase(id);
}

void Selection::follow(const Edit& edit) {
  for (const StrokeChange& change : edit.changes) {
    const auto found = strokes_.find(change.id);
    if (found == strokes_.end()) continue;
    if (!change.after) {
      strokes_.erase(found);
      continue;
    }
    const std::size_t points = change.after->data().points.size();
    if (found->second.size() == points) {
      if (change.after->closed()) mark_shared_point(found->second);
    } else if (all_set(found->second)) {
      found->second.assign(points, 1);
    } else {
      strokes_.erase(found);
    }
  }
}

void Selection::follow(const Edit& edit, const Document& document) {
  follow(edit);
  if (!edit.layers.empty()) {
    hold_to(document);
    return;
  }
  for (const StrokeChange& change : edit.changes) {
    if (change.after && !is_editable(document, change.id)) strokes_.erase(change.id);
  }
}

void Selection::hold_to(const Document& document) {
  std::erase_if(strokes_, [&](const auto& entry) {
    const StrokePtr stroke = document.find(entry.first);
    return !stroke || stroke->data().points.size() != entry.second.size() ||
           !is_editable(document, entry.first);
  });
}

Rect Selection::bounds(const Document& document) const {
  Rect box;
  for (const auto& [id, marks] : strokes_) {
    const StrokePtr stroke = document.find(id);
    FELT_CHECK(stroke && stroke->data().points.size() == marks.size());
    for (std::size_t i = 0; i < marks.size(); ++i) {
      if (marks[i]) box.extend(stroke->data().points[i]);
    }
  }
  return box;
}

Selection select_all(const Document& document) {
  Selection all;
  for (const Layer& layer : document.layers()) {
    if (!layer.visible || layer.locked) continue;
    for (const StrokeId id : layer.strokes) {
      all.set_whole(id, document.find(id)->data().points.size());
    }
  }
  return all;
}

}  // namespace felt
