#pragma once

#include <string>

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "picture.h"

namespace felt::cli {

class Console;

/// Replaces a drawing by one for swell paper (prepare_for_swell_paper), and prints what was
/// changed, one notice for each kind of change, with the name of the output. If the drawing has no
/// page and no other one is chosen, `picture` gets an A4 page, as long as the ink fits on it.
Result<void> make_swell_drawing(Drawing& drawing, PictureOptions& picture,
                                const std::string& output, Console& console);

}  // namespace felt::cli
