#pragma once

#include <memory>
#include <vector>

#include "felt/render/relief_texture.h"

namespace felt {

/// A square of heights that repeats. Its side is a power of two.
struct ReliefSquare {
  int side = 0;
  std::vector<float> heights;

  /// Returns the height at (x, y), which may lie outside.
  [[nodiscard]] float at(int x, int y) const noexcept {
    const auto mask = static_cast<unsigned>(side - 1);
    return heights[(static_cast<unsigned>(y) & mask) * static_cast<unsigned>(side) +
                   (static_cast<unsigned>(x) & mask)];
  }
};

/// Returns the square at half of the resolution: the means of 2 x 2 heights.
ReliefSquare halved(const ReliefSquare& from);

/// Returns the square as texels. Its heights are in units of the RMS of the finest square.
std::shared_ptr<const ReliefLevel> level_of(const ReliefSquare& square);

}  // namespace felt
