#pragma once

#include <functional>

#include "console.h"
#include "drawing_output.h"
#include "format.h"
#include "input.h"

namespace felt::cli {

/// Reads an input that is_lines(), made ready for an output of that format, and gives it to `take`
/// in pieces of some strokes; raw pen samples become ink. Bad records, and strokes that the format
/// cannot hold, are reported and left out. False when `take` returned false.
bool for_each_piece(const Input& input, Format format, Console& console,
                    const std::function<bool(const EncodedStrokes&)>& take);

/// Says what could not be taken of the file of that name: a line each. False where the console
/// counts that as a failure.
bool tell_notices(const std::string& name, const ImportReport& report, Console& console);

}  // namespace felt::cli
