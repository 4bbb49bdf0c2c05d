#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string_view>

#include "felt/base/result.h"
#include "felt/document/document.h"

namespace felt {

/// The edits of a document, for undo and redo: one step per gesture (R52). The steps hold the
/// strokes themselves, so undo restores them bit for bit.
///
/// The number of steps is not limited, but together they may take at most `memory_limit_bytes`
/// (memory_of()). If this limit is exceeded, the oldest steps are discarded; the document does not
/// change. The newest step is always kept, because otherwise the largest change could not be
/// undone. A stroke is counted in every step that holds it, so the memory in use never exceeds the
/// counted memory. Not thread-safe.
class History {
 public:
  static constexpr std::size_t kDefaultLimitBytes = std::size_t{256} << 20;

  explicit History(std::size_t memory_limit_bytes = kDefaultLimitBytes) noexcept
      : limit_(memory_limit_bytes) {}

  /// Records an edit that has just been applied, and discards the undone steps. Ignores an empty
  /// edit.
  void record(Edit edit);

  /// Adds an edit that has just been applied to the newest step, so that both are undone together.
  /// Returns false and does nothing if this is impossible: if there are undone steps or no step, if
  /// the label differs, or if the edit does not replace exactly the strokes and change exactly the
  /// symmetry groups and states of layers of the step.
  bool extend(const Edit& edit);

  /// Moves an edit that has just been applied into the newest step, if this step does nothing but
  /// change layers: both are undone together, with the label of the edit. Returns false and does
  /// nothing if this is impossible: if there are undone steps or no step, if the step does more, or
  /// if the edit is empty or changes layers, too.
  bool join(Edit& edit);

  /// Undoes the last step. Returns the edit that was applied for this. Fails without a change if no
  /// step can be undone, or if the document was changed without record().
  Result<Edit> undo(Document& document);
  /// Redoes the last undone step. Returns the edit that was applied for this. Fails under the same
  /// conditions as undo().
  Result<Edit> redo(Document& document);

  [[nodiscard]] bool can_undo() const noexcept { return done_ > 0; }
  [[nodiscard]] bool can_redo() const noexcept { return done_ < steps_.size(); }
  /// Returns the label of the step that undo() would undo, or "" if no step can be undone. Valid
  /// until the next call that changes the history.
  [[nodiscard]] std::string_view undo_label() const noexcept;
  [[nodiscard]] std::string_view redo_label() const noexcept;
  /// Returns the serial number of the newest step that is not undone, even if this step was
  /// discarded; 0 if there is none. Equal numbers mean equal documents, even if steps were undone
  /// and redone in between.
  [[nodiscard]] std::uint64_t position() const noexcept {
    return done_ > 0 ? steps_[done_ - 1].number : forgotten_number_;
  }
  /// Returns the number of steps that can be undone.
  [[nodiscard]] std::size_t undo_count() const noexcept { return done_; }
  /// Returns the number of steps that can be undone or redone. Index 0 is the oldest step that can
  /// be undone; the steps that can be redone come last.
  [[nodiscard]] std::size_t step_count() const noexcept { return steps_.size(); }
  /// Returns the label of step i. Requires i < step_count(). Valid until the next call that changes
  /// the history.
  [[nodiscard]] std::string_view label(std::size_t i) const noexcept {
    return steps_[i].edit.label;
  }
  /// Returns the number of steps that were discarded because of the memory limit.
  [[nodiscard]] std::size_t forgotten_count() const noexcept { return forgotten_; }
  [[nodiscard]] std::size_t memory_bytes() const noexcept { return bytes_; }

 private:
  struct Step {
    Edit edit;
    std::size_t bytes = 0;
    std::uint64_t number = 0;  // in the order of record()
  };

  std::deque<Step> steps_;  // done steps, then undone steps
  std::size_t done_ = 0;
  std::size_t bytes_ = 0;
  std::size_t limit_;
  std::size_t forgotten_ = 0;
  std::uint64_t recorded_ = 0;
  std::uint64_t forgotten_number_ = 0;  // number of the last discarded step
};

/// Returns the memory, in bytes, of an edit, its strokes and its fills. Each counts once for each
/// time that the edit contains it.
std::size_t memory_of(const Edit& edit) noexcept;

}  // namespace felt
