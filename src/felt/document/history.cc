#include "felt/document/history.h"

#include <optional>
#include <utility>

namespace felt {
namespace {

std::size_t memory_of(const StrokePtr& stroke) noexcept {
  if (!stroke) return 0;
  const StrokeData& d = stroke->data();
  return sizeof(Stroke) + d.points.capacity() * sizeof(Point) +
         d.joints.capacity() * sizeof(JointKind) + d.widths.capacity() * sizeof(WidthKnot) +
         d.medium.capacity();
}

const PictureData* data_of(const std::optional<LayerState>& state) noexcept {
  return state && state->picture ? state->picture->data.get() : nullptr;
}

}  // namespace

std::size_t memory_of(const Edit& edit) noexcept {
  std::size_t bytes = sizeof(Edit) + edit.label.capacity() +
                      edit.changes.capacity() * sizeof(StrokeChange) +
                      edit.layers.capacity() * sizeof(LayerChange);
  for (const StrokeChange& c : edit.changes) bytes += memory_of(c.before) + memory_of(c.after);
  for (const LayerChange& c : edit.layers) {
    if (c.before) bytes += c.before->name.capacity();
    if (c.after) bytes += c.after->name.capacity();
    // The document has the picture, too, unless the edit adds or removes it.
    const PictureData *before = data_of(c.before), *after = data_of(c.after);
    if (before && before != after) bytes += before->png.size();
    if (after && before != after) bytes += after->png.size();
  }
  return bytes;
}

void History::record(Edit edit) {
  if (edit.empty()) return;
  while (steps_.size() > done_) {
    bytes_ -= steps_.back().bytes;
    steps_.pop_back();
  }
  const std::size_t bytes = memory_of(edit);
  steps_.push_back({std::move(edit), bytes, ++recorded_});
  bytes_ += bytes;
  ++done_;
  while (bytes_ > limit_ && steps_.size() > 1) {
    bytes_ -= steps_.front().bytes;
    forgotten_number_ = steps_.front().number;
    steps_.pop_front();
    --done_;
    ++forgotten_;
  }
}

Result<Edit> History::undo(Document& document) {
  if (!can_undo()) return fail(ErrorCode::kNotFound, "there is nothing to undo");
  Edit back = steps_[done_ - 1].edit.inverse();
  if (auto ok = document.apply(back); !ok) return tl::unexpected(ok.error());
  --done_;
  return back;
}

Result<Edit> History::redo(Document& document) {
  if (!can_redo()) return fail(ErrorCode::kNotFound, "there is nothing to redo");
  Edit again = steps_[done_].edit;
  if (auto ok = document.apply(again); !ok) return tl::unexpected(ok.error());
  ++done_;
  return again;
}

std::string_view History::undo_label() const noexcept {
  return can_undo() ? std::string_view(steps_[done_ - 1].edit.label) : std::string_view();
}

std::string_view History::redo_label() const noexcept {
  return can_redo() ? std::string_view(steps_[done_].edit.label) : std::string_view();
}

}  // namespace felt
