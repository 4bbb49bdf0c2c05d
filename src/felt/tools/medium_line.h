#pragma once

#include "felt/material/materials.h"
#include "felt/stroke/fit/ink_fitter.h"

namespace felt {

/// How ink is made when it is drawn with a medium: its answer to lean, its tone, its name. The
/// range of widths and the pressure curve stay as `ink` has them (the pencil's options, which are
/// taken from the medium when it is taken); what leaning adds to the widest line is allowed for.
///
/// A medium whose tone says no more than the width does (all of the pencil's usual range, evenly)
/// has none of its own: its ink needs neither knots nor bytes for it.
InkFitOptions drawn_with(const Medium& medium, InkFitOptions ink);

}  // namespace felt
