#pragma once

#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/document/palette.h"

namespace felt {

/// Reads the text of a .gpl file: the line "GIMP Palette"; then "Name: ..." and "Columns: N" if
/// any; then a line "R G B name" for each colour, 0..255, parted by spaces or tabs. Lines that
/// begin with # and empty lines mean nothing; lines may end in CR LF.
///
/// Error: the first line that is none of these, or a limit; the message is "file:line: reason".
/// Names are held to UTF-8 without control characters.
Result<Palette> read_gpl(const std::string& file, std::string_view text);

/// The text of a .gpl file that read_gpl() reads back as the same palette. Alpha is not written:
/// the format has none. Requires a palette within the limits whose names are what read_gpl() takes
/// and neither begin nor end with a space.
std::string write_gpl(const Palette& palette);

}  // namespace felt
