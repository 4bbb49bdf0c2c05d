#include "felt/document/history.h"

#include <algorithm>
#include <optional>
#include <set>
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

std::size_t memory_of(const FillPtr& fill) noexcept {
  if (!fill) return 0;
  std::size_t bytes = sizeof(Fill) + fill->loops.capacity() * sizeof(FillLoop);
  for (const FillLoop& loop : fill->loops) {
    bytes += loop.points.capacity() * sizeof(Point) + loop.pieces.capacity() * sizeof(FillPiece);
  }
  return bytes;
}

std::size_t memory_of(const DrawingGuidePtr& guide) noexcept {
  if (!guide) return 0;
  return sizeof(DrawingGuide) + guide->points.capacity() * sizeof(Point) +
         guide->times_ms.capacity() * sizeof(double);
}

std::size_t memory_of(const SymmetryPtr& group) noexcept {
  return group ? sizeof(SymmetryGroup) + group->images.capacity() * sizeof(SymmetryImage) : 0;
}

std::size_t memory_of(const BodyEditPtr& edit) noexcept {
  if (!edit) return 0;
  return sizeof(BodyEdit) + (edit->path_mm.capacity() + edit->profile_mm.capacity()) * sizeof(Vec3);
}

std::size_t memory_of(const std::optional<LayerState>& state) noexcept {
  if (!state) return 0;
  return state->name.capacity() +
         (state->timing ? sizeof(KeyTiming) + state->timing->pairs.capacity() * sizeof(KeyPair)
                        : 0);
}

const PictureData* data_of(const std::optional<LayerState>& state) noexcept {
  return state && state->picture ? state->picture->data.get() : nullptr;
}

/// Adds changes of fills to those of the edit before. Returns false and changes nothing if one of
/// them adds, removes or moves a fill.
bool extend_fills(std::vector<FillChange>& fills, const std::vector<FillChange>& further) {
  const auto stays = [](const FillChange& c) {
    return c.before && c.after && c.before_place == c.after_place;
  };
  if (!std::all_of(fills.begin(), fills.end(), stays)) return false;
  if (!std::all_of(further.begin(), further.end(), stays)) return false;
  for (const FillChange& c : further) {
    const auto known = std::find_if(fills.begin(), fills.end(),
                                    [&c](const FillChange& first) { return first.id == c.id; });
    if (known == fills.end()) {
      fills.push_back(c);
    } else {
      known->after = c.after;
    }
  }
  return true;
}

/// Returns true if each change of a symmetry group continues the one of the edit before.
bool continue_groups(const std::vector<SymmetryChange>& groups,
                     const std::vector<SymmetryChange>& further) {
  const auto continues = [](const SymmetryChange& first, const SymmetryChange& second) {
    return first.id == second.id && first.before && first.after && second.after &&
           (first.after == second.before || (second.before && *first.after == *second.before));
  };
  return std::equal(groups.begin(), groups.end(), further.begin(), further.end(), continues);
}

/// Returns true if each change of a layer continues the one of the edit before, and none adds,
/// removes or moves a layer.
bool continue_layers(const std::vector<LayerChange>& layers,
                     const std::vector<LayerChange>& further) {
  const auto stays = [](const LayerChange& c) {
    return c.before && c.after && c.before_index == c.after_index;
  };
  const auto continues = [&stays](const LayerChange& first, const LayerChange& second) {
    return first.id == second.id && stays(first) && stays(second) && first.after == second.before;
  };
  return std::equal(layers.begin(), layers.end(), further.begin(), further.end(), continues);
}

}  // namespace

std::size_t memory_of(const Edit& edit) noexcept {
  std::size_t bytes =
      sizeof(Edit) + edit.label.capacity() + edit.changes.capacity() * sizeof(StrokeChange) +
      edit.layers.capacity() * sizeof(LayerChange) + edit.fills.capacity() * sizeof(FillChange) +
      edit.guides.capacity() * sizeof(GuideChange) +
      edit.symmetries.capacity() * sizeof(SymmetryChange) +
      edit.body_edits.capacity() * sizeof(BodyEditChange);
  for (const StrokeChange& c : edit.changes) bytes += memory_of(c.before) + memory_of(c.after);
  for (const FillChange& c : edit.fills) bytes += memory_of(c.before) + memory_of(c.after);
  for (const GuideChange& c : edit.guides) bytes += memory_of(c.before) + memory_of(c.after);
  for (const SymmetryChange& c : edit.symmetries) {
    bytes += memory_of(c.before) + memory_of(c.after);
  }
  for (const BodyEditChange& c : edit.body_edits) {
    bytes += memory_of(c.before) + memory_of(c.after);
  }
  std::set<const PictureData*> counted;
  const auto count = [&](const PictureData* data) {
    if (data && counted.insert(data).second) bytes += data->png.size();
  };
  for (const LayerChange& c : edit.layers) {
    bytes += memory_of(c.before) + memory_of(c.after);
    // The document has the picture, too, unless the edit adds or removes it.
    const PictureData *before = data_of(c.before), *after = data_of(c.after);
    if (before == after) continue;
    count(before);
    count(after);
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

bool History::extend(const Edit& edit) {
  const auto has_more = [](const Edit& e) {
    return !e.guides.empty() || !e.body_edits.empty() || e.toggles_guides;
  };
  if (done_ == 0 || can_redo() || has_more(edit)) return false;
  Step& step = steps_.back();
  const auto continues = [](const StrokeChange& first, const StrokeChange& second) {
    return first.id == second.id && first.before && first.after && first.after == second.before &&
           second.after && first.after_place == second.before_place;
  };
  if (step.edit.label != edit.label || has_more(step.edit) ||
      !std::equal(step.edit.changes.begin(), step.edit.changes.end(), edit.changes.begin(),
                  edit.changes.end(), continues) ||
      !continue_groups(step.edit.symmetries, edit.symmetries) ||
      !continue_layers(step.edit.layers, edit.layers)) {
    return false;
  }
  if (!extend_fills(step.edit.fills, edit.fills)) return false;
  for (std::size_t i = 0; i < edit.changes.size(); ++i) {
    step.edit.changes[i].after = edit.changes[i].after;
    step.edit.changes[i].after_place = edit.changes[i].after_place;
  }
  for (std::size_t i = 0; i < edit.layers.size(); ++i) {
    step.edit.layers[i].after = edit.layers[i].after;
  }
  for (std::size_t i = 0; i < edit.symmetries.size(); ++i) {
    step.edit.symmetries[i].after = edit.symmetries[i].after;
  }
  bytes_ -= std::exchange(step.bytes, memory_of(step.edit));
  bytes_ += step.bytes;
  step.number = ++recorded_;
  return true;
}

bool History::join(Edit& edit) {
  if (done_ == 0 || can_redo() || edit.empty() || !edit.layers.empty()) return false;
  Step& step = steps_.back();
  edit.layers = std::exchange(step.edit.layers, {});
  if (!step.edit.empty()) {  // it does more
    step.edit.layers = std::exchange(edit.layers, {});
    return false;
  }
  step.edit = std::move(edit);
  bytes_ -= std::exchange(step.bytes, memory_of(step.edit));
  bytes_ += step.bytes;
  step.number = ++recorded_;
  return true;
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
