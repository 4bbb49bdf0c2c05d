#pragma once

#include "felt/stroke/stroke.h"

namespace felt::desktop {

/// A lower contrast is hard to see (WCAG 2.2, 1.4.11).
inline constexpr double kFaintContrast = 3.0;

/// Returns the contrast ratio of two opaque colours, 1..21, as defined by WCAG 2.2.
double contrast_of(Rgba a, Rgba b);
/// Returns the colour that results from `color` over the opaque `ground`.
Rgba seen_on(Rgba color, Rgba ground);
/// Returns the colour of the paper that the user sees. A page without paper is shown as white.
Rgba seen_paper(Rgba paper);
/// Returns true if ink of this colour almost disappears on the paper: the contrast is below 1.5,
/// and no channel differs by more than a quarter. So yellow on white counts as visible.
bool is_hard_to_see(Rgba ink, Rgba paper);
/// Returns a colour that is visible on the paper: `usual` with the opacity of `ink` if its contrast
/// is enough, otherwise black or white, and these opaque if their contrast would not be enough
/// with the opacity of `ink`.
Rgba visible_instead_of(Rgba ink, Rgba usual, Rgba paper);

}  // namespace felt::desktop
