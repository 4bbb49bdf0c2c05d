#pragma once

#include <chrono>
#include <future>
#include <string>

#include "felt/base/result.h"
#include "felt/session/session.h"

namespace felt::cli {

/// A copy of a drawing in the making, as .ndjson beside the output to come: a maker's library that
/// falls over takes the program with it, and all the ink but this. Written anew every few seconds
/// while the drawing changes, whole or not at all, by a thread of its own: a slow disk holds nobody
/// up. The one who draws calls all functions.
class RecordCopy {
 public:
  using Clock = std::chrono::steady_clock;

  /// For what will be `output`; the copy of one that is no file ("-", a pipe) is in the folder for
  /// temporary files. Its name has our process's number, so that no other copy is overwritten.
  explicit RecordCopy(const std::string& output, Clock::duration every = std::chrono::seconds(3));

  [[nodiscard]] const std::string& path() const noexcept { return path_; }
  /// The drawing is not what it was.
  void note_edit() noexcept { is_changed_ = true; }
  /// Each turn. Writes when it is time, never while the last copy is on its way.
  void keep(const Session& session);
  /// The drawing is safe where it belongs: removes the copy.
  void remove();

 private:
  std::string path_;
  Clock::duration every_;
  Clock::time_point next_;
  bool is_changed_ = false;
  std::future<Result<void>> writing_;
};

}  // namespace felt::cli
