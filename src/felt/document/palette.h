#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "felt/stroke/stroke.h"

namespace felt {

/// A colour and its name, which may be empty.
struct NamedColor {
  Rgba color;
  std::string name;
  friend bool operator==(const NamedColor&, const NamedColor&) = default;
};

/// Colours to choose from. Files hold a palette within PaletteLimits.
struct Palette {
  std::string name;         ///< "" if it has none
  std::size_t columns = 0;  ///< number of columns in which to show it; 0 if any number will do
  std::vector<NamedColor> colors;
  friend bool operator==(const Palette&, const Palette&) = default;
};

/// The largest palette that a file may hold. If a limit is exceeded, readers fail and name the
/// line.
struct PaletteLimits {
  static constexpr std::size_t kMaxBytes = std::size_t{1} << 20;  ///< of a .gpl file
  static constexpr std::size_t kMaxColors = 10'000;
  static constexpr std::size_t kMaxNameBytes = 200;
  static constexpr std::size_t kMaxColumns = 64;
};

}  // namespace felt
