#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "felt/render/pressure_map.h"

namespace felt {

/// Finds the pixels that the path of a dry tip visits more than once, and stores the push of each
/// visit, so that tone builds up where a stroke crosses itself
/// (docs/design/rendering.md#where-a-stroke-crosses-itself). Reuses its buffers. Not thread-safe.
///
/// A visit is a stretch of the path that covers the pixel. Two strips that are at most
/// kSameVisit widths apart along the path belong to the same visit. Only blocks of 8 x 8 pixels in
/// which the path comes from two directions are searched; a stretch of the path whose directions
/// are within 45 degrees of the first one does not return to its own pixels.
class VisitMap {
 public:
  /// The visits of a pixel that are kept: the newest one, and those with the largest push. The tone
  /// of so many hardly grows further.
  static constexpr int kMax = 6;
  /// Distances along the path, in widths: up to the first one, two visits count as one; from the
  /// second one on, their tones build up fully, and between them in part.
  static constexpr float kSameVisit = 1.5F, kOtherVisit = 2.75F;
  /// Number of steps of coverage.
  static constexpr int kCoverSteps = 15;

  /// The visits of a pixel: the newest one, then the others. A value of 0 means none. The lower
  /// four bits of rho^2 in a value are the coverage of the pixel by that visit.
  struct Visits {
    const std::int32_t* values;
    const float* travels;
    [[nodiscard]] std::int32_t value(int n) const noexcept { return values[n * kTipLanes]; }
    [[nodiscard]] float travel(int n) const noexcept { return travels[n * kTipLanes]; }
  };

  /// Finds the visits in the area of a map from its strips, which must have TipAt::travel. If the
  /// path is a ring, `ring` is its whole length in widths, otherwise 0.
  void find(const PressureMap& map, double ring);
  void clear() noexcept { has_visits_ = false; }
  /// Returns the length of the ring, or 0.
  [[nodiscard]] float ring() const noexcept { return ring_; }

  /// Returns true if the block of the pixel may have pixels with several visits. Requires a pixel
  /// of the area. Then visits() is valid for this pixel.
  [[nodiscard]] bool is_searched(int x, int y) const noexcept {
    return has_visits_ && blocks_[block_of(x, y)] < 0;
  }
  [[nodiscard]] bool is_empty() const noexcept { return !has_visits_; }
  [[nodiscard]] Visits visits(int x, int y) const noexcept {
    const std::size_t first = first_of(x, y);
    return {values_.data() + first, travels_.data() + first};
  }
  static std::int32_t cover_of(std::int32_t value) noexcept {
    return (value >> PressureMap::kRimShift) & kCoverSteps;
  }

  /// Returns how much of two visits counts as separate, 0..1, if they are `apart` widths from each
  /// other along the path.
  static float separate(float apart) noexcept {
    const float x = (apart - kSameVisit) / (kOtherVisit - kSameVisit);
    return x <= 0.0F ? 0.0F : x >= 1.0F ? 1.0F : x * x * (3.0F - 2.0F * x);
  }

 private:
  static constexpr int kSide = kTipLanes;
  static constexpr std::size_t kPerRow = std::size_t{kMax} * kSide;

  [[nodiscard]] std::size_t block_of(int x, int y) const noexcept {
    return static_cast<std::size_t>((y - area_.y0) / kSide) * columns_ +
           static_cast<std::size_t>((x - area_.x0) / kSide);
  }
  [[nodiscard]] std::size_t first_of(int x, int y) const noexcept {
    const auto number = static_cast<std::size_t>(-1 - blocks_[block_of(x, y)]);
    return (number * kSide + static_cast<std::size_t>((y - area_.y0) % kSide)) * kPerRow +
           static_cast<std::size_t>((x - area_.x0) % kSide);
  }
  void mark(std::span<const TipStrip> strips);
  void mark_strip(const TipStrip& strip, std::int32_t stretch);

  PixelRect area_;
  std::size_t columns_ = 0;
  bool has_visits_ = false;
  float ring_ = 0.0F;
  // For each block 0, the number of the only stretch that touches it, or -1 - n for the n-th block
  // that is searched.
  std::vector<std::int32_t> blocks_;
  std::size_t searched_ = 0;
  std::vector<std::int32_t> values_;
  std::vector<float> travels_;
};

}  // namespace felt
