#pragma once

#include <cstdint>

namespace felt::desktop {

/// What a drag on a body does in the solid view.
enum class BodyTool : std::uint8_t {
  kTurn,     ///< turns the bodies
  kCut,      ///< draws a stroke along which the body is cut
  kExtrude,  ///< draws a closed line on the body, then the profile of the new part
  kPaint,    ///< paints on the body
  kSmooth,   ///< smooths the body
};

}  // namespace felt::desktop
