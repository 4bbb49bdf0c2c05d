#pragma once

namespace felt::desktop {

/// In `Settings`: dry ink shows the relief of the sheet, on the canvas, and at first in what is
/// exported and printed.
inline constexpr auto kShowsGrain = "canvas/grain";
inline constexpr bool kShowsGrainDefault = true;

}  // namespace felt::desktop
