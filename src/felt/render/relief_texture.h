#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "felt/geometry/height_field.h"
#include "felt/render/view.h"

namespace felt {

/// The relief that an eye sees, in its RMS: h and its tooth, the same map 4.5 and 8.1 times finer,
/// each turned by some 30 degrees, so that it never shows its lattice; wood's finer lines stay
/// along the wood. Repeats with the tile of h, because tooth is a rotation by whole numbers.
double seen_relief(const HeightField& field, Point place) noexcept;

/// A relief in little squares of equal height, a power of two along a side, without a seam.
struct ReliefLevel {
  static constexpr double kPerRms = 32.0;  ///< a texel of 32 is one RMS high: +-4 RMS fit

  int log2_side = 0;
  double kept = 1.0;  ///< variance that is left of 1: what is finer than a texel is gone
  std::vector<std::int8_t> texels{};
};

/// The relief of a field at all scales, made when first asked for and kept. Any thread.
class ReliefTexture {
 public:
  /// `field` must outlive it.
  explicit ReliefTexture(const HeightField* field) noexcept : field_(field) {}

  /// The coarsest level with texels no larger than 3/4 of a pixel, or the finest one, 64 texels a
  /// wavelength. Null: a pixel is as large as the tile. Makes a level in 20 to 100 ms.
  std::shared_ptr<const ReliefLevel> level(double px_per_wavelength);

 private:
  static constexpr int kFinest = 11, kUsual = 10, kCoarsest = 3;

  const HeightField* field_;
  std::mutex mutex_;
  std::array<std::shared_ptr<const ReliefLevel>, kFinest + 1> levels_{};
};

/// A level as a view shows it: which texel lies at the middle of pixel (x, y), or between which.
/// All in whole numbers, and the same ones whichever part of a picture they are asked for.
class ReliefPlane {
 public:
  ReliefPlane() = default;
  /// `level` must outlive it; it is `tile_mm` wide.
  ReliefPlane(const ReliefLevel& level, double tile_mm, const View& view);

  [[nodiscard]] bool is_flat() const noexcept { return texels_ == nullptr; }
  /// Adds the heights of `count` pixels from (x, y) on, `weight` / 256 of them, to `sums`.
  void add_row(int x, int y, int count, int weight, int* sums) const noexcept;

 private:
  const std::int8_t* texels_ = nullptr;
  int log2_side_ = 0;
  bool is_between_ = false;  // texels are larger than pixels: bilinear
  // Texels, of which 2^kFraction are one; what exceeds the side falls off at the top.
  std::uint64_t u0_ = 0, v0_ = 0, ux_ = 0, vx_ = 0, uy_ = 0, vy_ = 0;
};

}  // namespace felt
