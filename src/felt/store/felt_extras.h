#pragma once

#include <memory>
#include <string>
#include <vector>

#include "felt/store/felt_recording.h"

namespace felt {

/// What a file holds besides the drawing and is not looked at unless asked: recordings, and the
/// tables and columns of a newer Feltline. Opening keeps the bytes of the file for it, so that
/// saving can carry it over. A value; copies share it.
struct FeltExtras {
  /// The file that was read, when it holds such things; null else. Checked when it was read.
  std::shared_ptr<const std::string> file;
  /// Recordings made since, the earliest first.
  std::vector<std::shared_ptr<const FeltRecording>> added;

  [[nodiscard]] bool empty() const noexcept { return !file && added.empty(); }
  /// The same things, by value; which other rows the files hold does not matter.
  friend bool operator==(const FeltExtras& a, const FeltExtras& b);
};

}  // namespace felt
