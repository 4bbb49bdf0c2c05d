#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string_view>

#include "felt/base/result.h"
#include "felt/document/document.h"

namespace felt {

/// What was done to a document, so that it can be undone and done again: one step a gesture (R52).
/// The steps hold the strokes themselves, so undo restores them bit for bit.
///
/// Memory: any number of steps up to `memory_limit_bytes` of strokes and lists; beyond that the
/// oldest are forgotten, silently as far as the document goes. The newest step is always kept, or
/// the largest change would be the one that cannot be undone. A stroke is charged to every step
/// that holds it, so the true use is lower than what is counted, never higher. One thread.
class History {
 public:
  static constexpr std::size_t kDefaultLimitBytes = std::size_t{256} << 20;

  explicit History(std::size_t memory_limit_bytes = kDefaultLimitBytes) noexcept
      : limit_(memory_limit_bytes) {}

  /// Remembers an edit that has just been applied. What had been undone is forgotten. An empty edit
  /// is no step.
  void record(Edit edit);

  /// Takes the last step back and returns the edit that did so, already applied. Error: there is
  /// none, or the document was changed behind the history's back; nothing changes then.
  Result<Edit> undo(Document& document);
  /// Does the last undone step again; likewise.
  Result<Edit> redo(Document& document);

  [[nodiscard]] bool can_undo() const noexcept { return done_ > 0; }
  [[nodiscard]] bool can_redo() const noexcept { return done_ < steps_.size(); }
  /// Label of what undo() would take back, "" for nothing. Valid until the next call that changes.
  [[nodiscard]] std::string_view undo_label() const noexcept;
  [[nodiscard]] std::string_view redo_label() const noexcept;
  /// Which step was done last, 0 for none: the same number means the same document, whatever was
  /// undone and done again in between.
  [[nodiscard]] std::uint64_t position() const noexcept {
    return done_ > 0 ? steps_[done_ - 1].number : forgotten_number_;
  }
  /// Steps that can be undone.
  [[nodiscard]] std::size_t undo_count() const noexcept { return done_; }
  /// All that are remembered: those that can be undone, the oldest first, then those that can be
  /// done again.
  [[nodiscard]] std::size_t step_count() const noexcept { return steps_.size(); }
  /// Label of the step with this index. Requires i < step_count(). Valid as undo_label() is.
  [[nodiscard]] std::string_view label(std::size_t i) const noexcept {
    return steps_[i].edit.label;
  }
  /// Steps that were forgotten for want of memory.
  [[nodiscard]] std::size_t forgotten_count() const noexcept { return forgotten_; }
  [[nodiscard]] std::size_t memory_bytes() const noexcept { return bytes_; }

 private:
  struct Step {
    Edit edit;
    std::size_t bytes = 0;
    std::uint64_t number = 0;  // in the order of record()
  };

  std::deque<Step> steps_;  // done ones, then undone ones
  std::size_t done_ = 0;
  std::size_t bytes_ = 0;
  std::size_t limit_;
  std::size_t forgotten_ = 0;
  std::uint64_t recorded_ = 0;
  std::uint64_t forgotten_number_ = 0;  // of the last step that was forgotten
};

/// Memory that an edit keeps alive, in bytes; each stroke counted once per mention.
std::size_t memory_of(const Edit& edit) noexcept;

}  // namespace felt
