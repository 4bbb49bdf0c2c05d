#pragma once

namespace felt::desktop {

/// Setting: whether dry ink on the canvas shows the relief of the surface. This is also the initial
/// value for export and print.
inline constexpr auto kShowsGrain = "canvas/grain";
inline constexpr bool kShowsGrainDefault = true;

}  // namespace felt::desktop
