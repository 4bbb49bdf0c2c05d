#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "felt/document/edit.h"

namespace felt {

/// What a tool that reads finds under the pen (Tool::reading). Speech, sound and the cues of haptic
/// pens use it.
struct Reading {
  enum class Kind : std::uint8_t {
    kNothing,   ///< empty paper
    kLine,      ///< on a line
    kEnd,       ///< at an end of a line
    kCrossing,  ///< where lines meet or cross
    kFill,      ///< in a filled area
  };
  /// A line farther from the pen than this has no distance.
  static constexpr double kFarMm = 30.0;

  Kind kind = Kind::kNothing;
  StrokeId stroke{};       ///< kLine, kEnd and kCrossing: the line that the pen follows
  FillId fill{};           ///< kFill
  std::size_t lines = 0;   ///< kCrossing: number of lines that meet here
  double length_mm = 0.0;  ///< of the line
  /// Distance from the pen to the edge of the nearest ink; 0 on it, infinity beyond kFarMm.
  double distance_mm = std::numeric_limits<double>::infinity();
  bool is_down = false;      ///< the pen touches
  bool has_sound = false;    ///< the distance is meant to be heard (option "sound")
  std::uint32_t news = 0;    ///< grows when there is something else under the pen
  std::uint32_t clicks = 0;  ///< grows when the pen arrives at an end or a crossing
};

}  // namespace felt
