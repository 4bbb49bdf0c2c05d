#pragma once

namespace felt::desktop {

/// In `Settings`: dry ink shows the relief of the surface on the canvas. Also the first value for
/// export and print.
inline constexpr auto kShowsGrain = "canvas/grain";
inline constexpr bool kShowsGrainDefault = true;

}  // namespace felt::desktop
