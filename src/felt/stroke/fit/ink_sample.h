#pragma once

#include <cstdint>
#include <optional>

#include "felt/geometry/point.h"

namespace felt {

/// One pen sample as the ink sees it: where, how hard, when.
struct InkSample {
  Point position;                       ///< mm, sheet frame
  std::optional<double> pressure;       ///< 0..1, absent where the source has none
  std::optional<std::int64_t> time_ns;  ///< since the drawing session began; may run backwards
  std::optional<double> lean_deg{};     ///< from the upright, 0..90 (geometry/lean.h makes a share
                                        ///< of it); absent where the source has none

  friend constexpr bool operator==(const InkSample&, const InkSample&) noexcept = default;
};

}  // namespace felt
