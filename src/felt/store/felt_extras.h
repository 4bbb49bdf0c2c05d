#pragma once

#include <memory>
#include <string>
#include <vector>

#include "felt/document/drawing.h"
#include "felt/store/felt_recording.h"

namespace felt {

/// What a file holds besides the drawing: recordings, and the tables and columns of a newer
/// Feltline. Opening keeps the bytes of the file for it, so that saving can carry it over.
struct FeltExtras final : DrawingExtras {
  /// The file that was read, if it holds such things; else null. Checked when it was read.
  std::shared_ptr<const std::string> file;
  /// Recordings made since, the earliest first.
  std::vector<std::shared_ptr<const FeltRecording>> added;

  /// Compares by value; which other rows the files hold does not matter.
  [[nodiscard]] bool equals(const DrawingExtras& other) const override;
};

/// Returns what a drawing carries: empty if that is nothing.
const FeltExtras& felt_extras(const Drawing& drawing);

}  // namespace felt
