#pragma once

#include "felt/geometry/vec3.h"

namespace felt::desktop {

/// A pen that touches a body, as the solid view shows it. Positions are in mm in the frame of the
/// solid (SolidBody).
struct SolidTouchMarks {
  Vec3 pen_mm;    ///< position of the device
  Vec3 proxy_mm;  ///< the point on the surface that stands for it; shown as a small ball
  Vec3 force_n;   ///< the force on the hand, in N; shown as a line that starts at the proxy
};

}  // namespace felt::desktop
