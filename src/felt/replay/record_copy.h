#pragma once

#include <chrono>
#include <future>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/session/session.h"

namespace felt {

/// Keeps a copy of a drawing in progress, as .ndjson next to the future output, because a crash in
/// a vendor's library would otherwise lose all ink. The copy contains the finished strokes,
/// followed by the drawn part of the stroke in progress. While the drawing changes, the copy is
/// rewritten every few seconds, completely or not at all. A separate thread writes the copy, so
/// that a slow disk does not delay the drawing. Call all functions on the thread that draws.
class RecordCopy {
 public:
  using Clock = std::chrono::steady_clock;

  /// Keeps a copy for a future file `output`. If `output` is not a file ("-", a pipe), the copy is
  /// in the folder for temporary files. The name of the copy contains our process id, so that no
  /// other copy is overwritten.
  explicit RecordCopy(const std::string& output, Clock::duration every = std::chrono::seconds(3));

  [[nodiscard]] const std::string& path() const noexcept { return path_; }
  /// Records that the drawing has changed.
  void note_edit() noexcept { is_changed_ = true; }
  /// Writes a copy if the interval has passed, but not while the previous copy is still being
  /// written. Call it on each pass of the loop that draws.
  void keep(const Session& session);
  /// Waits until the current copy is written.
  void wait();
  /// Removes the copy. Call it when the drawing has been saved.
  void remove();

 private:
  std::string path_;
  Clock::duration every_;
  Clock::time_point next_;
  bool is_changed_ = false;  // since the last copy
  std::future<Result<void>> writing_;
};

/// Returns the copies in these folders that were left behind by processes that no longer exist.
std::vector<std::string> find_record_copies(const std::vector<std::string>& folders);

}  // namespace felt
