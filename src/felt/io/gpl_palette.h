#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// A colour with what people call it; the name may be empty.
struct NamedColor {
  Rgba color;
  std::string name;
  friend bool operator==(const NamedColor&, const NamedColor&) = default;
};

/// Colours to choose from, as GIMP, Inkscape, Krita and others keep them in .gpl files.
struct GplPalette {
  std::string name;         ///< "" where the file has none
  std::size_t columns = 0;  ///< to show it in; 0 for any
  std::vector<NamedColor> colors;
  friend bool operator==(const GplPalette&, const GplPalette&) = default;
};

/// What a palette file may hold. Everything above is an error that names its line.
struct GplLimits {
  static constexpr std::size_t kMaxBytes = std::size_t{1} << 20;
  static constexpr std::size_t kMaxColors = 10'000;
  static constexpr std::size_t kMaxNameBytes = 200;
  static constexpr std::size_t kMaxColumns = 64;
};

/// Reads the text of a .gpl file: the line "GIMP Palette"; then "Name: ..." and "Columns: N" if
/// any; then a line "R G B name" for each colour, 0..255, parted by spaces or tabs. Lines that
/// begin with # and empty lines mean nothing; lines may end in CR LF.
///
/// Error: the first line that is none of these, or a limit; the message is "file:line: reason".
/// Names are held to UTF-8 without control characters.
Result<GplPalette> read_gpl(const std::string& file, std::string_view text);

/// The text of a .gpl file that read_gpl() reads back as the same palette. Alpha is not written:
/// the format has none. Requires a palette within the limits whose names are what read_gpl() takes
/// and neither begin nor end with a space.
std::string write_gpl(const GplPalette& palette);

}  // namespace felt
