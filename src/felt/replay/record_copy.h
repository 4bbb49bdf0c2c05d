#pragma once

#include <chrono>
#include <future>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/session/session.h"

namespace felt {

/// A copy of a drawing in progress, as .ndjson beside the output to come: a vendor's library that
/// crashes takes the program with it, and all the ink but this. It has the finished strokes and, as
/// the last one, the stroke in progress as far as it is drawn. Written again every few seconds
/// while the drawing changes, whole or not at all, by its own thread, so that a slow disk delays
/// nothing. Call all functions on the thread that draws.
class RecordCopy {
 public:
  using Clock = std::chrono::steady_clock;

  /// For what will be `output`; the copy of one that is no file ("-", a pipe) is in the folder for
  /// temporary files. Its name has our process's number, so that no other copy is overwritten.
  explicit RecordCopy(const std::string& output, Clock::duration every = std::chrono::seconds(3));

  [[nodiscard]] const std::string& path() const noexcept { return path_; }
  /// The drawing has changed.
  void note_edit() noexcept { is_changed_ = true; }
  /// Each turn. Writes when it is time, never while the last copy is on its way.
  void keep(const Session& session);
  /// Waits until the copy in progress is written.
  void wait();
  /// The drawing is safe where it belongs: removes the copy.
  void remove();

 private:
  std::string path_;
  Clock::duration every_;
  Clock::time_point next_;
  bool is_changed_ = false;  // since the last copy
  std::future<Result<void>> writing_;
};

/// The copies in these folders that processes which are gone left behind.
std::vector<std::string> find_record_copies(const std::vector<std::string>& folders);

}  // namespace felt
