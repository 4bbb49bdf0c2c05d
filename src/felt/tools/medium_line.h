#pragma once

#include "felt/material/materials.h"
#include "felt/stroke/fit/ink_fitter.h"

namespace felt {

/// Returns `ink` with the name, the tone and the response to tilt of a medium. The range of widths
/// and the pressure curve stay as in `ink` (the pencil's options, which are set from the medium
/// when the user picks it), except that the maximum width is multiplied by the factor by which tilt
/// may broaden the line.
///
/// If the tone of a medium is the default function of the width, and the range of widths is the
/// pencil's default, no tone is set. The ink then needs no knots for tone, and files do not store
/// it.
InkFitOptions drawn_with(const Medium& medium, InkFitOptions ink);

}  // namespace felt
