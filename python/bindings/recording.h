#pragma once

#include <cstdint>
#include <vector>

#include "felt/store/felt_recording.h"

namespace felt::python {

/// One row of `Recording.samples`. Unknown numbers are NaN.
struct SampleRow {
  double t_ms = 0.0;
  double x = 0.0, y = 0.0, z = 0.0;
  double pressure = 0.0;
  double tilt = 0.0;
  double ask_x = 0.0, ask_y = 0.0, ask_z = 0.0;
  double sent_x = 0.0, sent_y = 0.0, sent_z = 0.0;
  std::uint32_t buttons = 0;
  std::uint8_t contact = 0;
};

/// A recording as Python holds it. It is never changed.
struct HeldRecording {
  explicit HeldRecording(FeltRecording from);

  FeltRecording recording;
  std::vector<SampleRow> rows;
};

}  // namespace felt::python
