#pragma once

#include <functional>

#include "console.h"
#include "drawing_output.h"
#include "felt/session/session_options.h"
#include "format.h"
#include "input.h"

namespace felt::cli {

/// Reads an input for which is_lines() is true, encodes its strokes for an output in `format`, and
/// passes them to `take`, several strokes at a time. Raw pen samples are fitted first. Bad records,
/// and strokes that the format cannot hold, are reported and skipped. Returns false if `take`
/// returned false.
bool for_each_piece(const Input& input, Format format, Console& console,
                    const std::function<bool(const EncodedStrokes&)>& take);

/// Prints a notice for each kind of unsupported content in the file called `name`. Returns false if
/// the console counts a notice as a failure.
bool report_notices(const std::string& name, const ImportReport& report, Console& console);

/// Prints how many gestures in the script called `name` changed nothing, and why the first did.
void note_refusals(const std::string& name, const Refusals& refusals, Console& console);

}  // namespace felt::cli
