#pragma once

#include <memory>
#include <string>
#include <vector>

#include "felt/document/drawing.h"
#include "felt/store/felt_recording.h"

namespace felt {

/// Content of a file besides the drawing: recordings, and the tables and columns of a newer
/// Feltline. It keeps the bytes of the file that was opened, so that saving can carry the content
/// over.
struct FeltExtras final : DrawingExtras {
  /// The bytes of the file that was read, which were checked at that time; null if that file has no
  /// such content.
  std::shared_ptr<const std::string> file;
  /// Recordings made since the file was read, the earliest first.
  std::vector<std::shared_ptr<const FeltRecording>> added;

  /// Compares by value: the added recordings, and, from each file, the content that saving would
  /// carry over.
  [[nodiscard]] bool equals(const DrawingExtras& other) const override;
};

/// Returns the extras of a drawing; they are empty if the drawing has no extras.
const FeltExtras& felt_extras(const Drawing& drawing);

}  // namespace felt
