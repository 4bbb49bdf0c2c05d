#pragma once

#include <functional>

#include "console.h"
#include "drawing_output.h"
#include "format.h"
#include "input.h"

namespace felt::cli {

/// Reads an input that is_lines(), encodes it for an output of that format, and passes it to `take`
/// in pieces of some strokes. Raw pen samples become ink. Bad records, and strokes that the format
/// cannot hold, are reported and skipped. Returns false if `take` returned false.
bool for_each_piece(const Input& input, Format format, Console& console,
                    const std::function<bool(const EncodedStrokes&)>& take);

/// Prints a notice for each kind of unsupported content in the file of that name. Returns false if
/// the console counts that as a failure.
bool tell_notices(const std::string& name, const ImportReport& report, Console& console);

}  // namespace felt::cli
