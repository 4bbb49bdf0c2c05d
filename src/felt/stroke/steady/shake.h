#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "felt/base/result.h"

namespace felt {

/// How a hand shakes: the motion that SteadyLine removes from a line. find_shake() measures it.
struct Shake {
  static constexpr double kMinHz = 3.0, kMaxHz = 12.0;
  static constexpr double kMinAmplitudeMm = 0.1, kMaxAmplitudeMm = 10.0;
  static constexpr double kMaxAxisDeg = 180.0;

  double hz = 5.0;            ///< mean frequency
  double amplitude_mm = 1.0;  ///< along the axis, from the middle to the turning point
  double axis_deg = 0.0;      ///< direction of the largest motion, 0..180, from +x to +y

  friend bool operator==(const Shake&, const Shake&) noexcept = default;
};

/// Returns "5.2,1.1,30": frequency, amplitude and axis with two decimals.
std::string shake_to_text(const Shake& shake);
/// Reads the text of shake_to_text(). Fails if the text does not consist of three numbers, or if a
/// number is out of range.
Result<Shake> shake_from_text(std::string_view text);

/// Returns the text of a file that keeps a Shake (docs/formats/steady.md): one line for each value,
/// "hz = 5.20".
std::string write_shake(const Shake& shake);
/// Reads the text of such a file. Empty lines and lines that begin with "#" are ignored. Fails with
/// the number of the line if the text is not valid, or if a value is missing.
Result<Shake> read_shake(std::string_view text);

}  // namespace felt
