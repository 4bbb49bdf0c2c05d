#pragma once

#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/document/palette.h"

namespace felt {

/// Reads the text of a .gpl file: the line "GIMP Palette"; then "Name: ..." and "Columns: N", both
/// optional; then a line "R G B name" for each colour, 0..255, separated by spaces or tabs. Empty
/// lines and lines that begin with # are ignored. Lines may end in CR LF.
///
/// Fails at the first line that has another form, or if a limit is exceeded. The message is
/// "file:line: reason". Names must be UTF-8 without control characters.
Result<Palette> read_gpl(const std::string& file, std::string_view text);

/// Returns the text of a .gpl file that read_gpl() reads back as the same palette. Alpha is not
/// written, because the format has no alpha. Requires a palette within the limits, with names that
/// read_gpl() accepts and that neither begin nor end with a space.
std::string write_gpl(const Palette& palette);

}  // namespace felt
