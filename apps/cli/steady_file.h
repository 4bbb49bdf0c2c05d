#pragma once

#include <cstddef>
#include <string>

#include "felt/base/result.h"
#include "felt/stroke/steady/shake.h"

namespace felt::cli {

/// Maximum sizes of the files that calibration reads and that --steady names.
inline constexpr std::size_t kMaxSpiralBytes = std::size_t{256} << 20, kMaxShakeBytes = 64 << 10;

/// Returns the shaking that --steady names: "HZ,MM,DEG", or a file of `feltline steady calibrate`.
/// The message of an error names the file and the reason.
Result<Shake> shake_of(const std::string& argument);

}  // namespace felt::cli
