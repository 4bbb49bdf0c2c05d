#pragma once

#include <span>
#include <string_view>

#include "felt/base/result.h"
#include "felt/render/image.h"

namespace felt::bench {

/// Every surface with these media, by their ids, at three forces (0.25, 0.7, 1.6 N), drawn by the
/// simulated hand through the session and rendered as they look on it, at 200 dpi.
Result<Image> draw_chart(std::span<const std::string_view> media);

}  // namespace felt::bench
