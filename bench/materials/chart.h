#pragma once

#include <span>
#include <string_view>

#include "felt/base/result.h"
#include "felt/render/image.h"

namespace felt::bench {

/// Returns a chart of every surface with these media (given by their ids) at three forces (0.25,
/// 0.7, 1.6 N). The simulated hand draws the lines in a session. They are rendered at 200 dpi as
/// the medium looks on the surface.
Result<Image> draw_chart(std::span<const std::string_view> media);

}  // namespace felt::bench
