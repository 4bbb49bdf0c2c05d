#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "felt/geometry/height_field.h"
#include "felt/render/view.h"

namespace felt {

/// Returns the visible relief in units of its RMS: the height h plus its tooth. The tooth consists
/// of two finer copies of h, 4.5 and 8.1 times as fine and each rotated by about 30 degrees, so
/// that the lattice of the map is not visible. For wood the copies are 4 and 9 times as fine and
/// not rotated, so that their lines run along the fibres. The sum repeats with the tile of h,
/// because the copies are mapped with whole-number matrices.
double seen_relief(const HeightField& field, Point place) noexcept;

/// A relief that repeats without seams, as a square grid of texels. Each texel is one height. The
/// side of the grid is a power of two.
struct ReliefLevel {
  static constexpr double kPerRms = 32.0;  ///< a texel of 32 is 1 RMS high, so +-4 RMS fit

  int log2_side = 0;
  double kept = 1.0;  ///< fraction of the variance that is left; detail finer than a texel is lost
  std::vector<std::int8_t> texels{};
};

/// The relief of a field at all scales. A level is made when it is first requested, and then kept.
/// Safe to use from any thread.
class ReliefTexture {
 public:
  /// Requires that `field` outlives it.
  explicit ReliefTexture(const HeightField* field) noexcept : field_(field) {}

  /// Returns the coarsest level with texels no larger than 3/4 of a pixel. If there is none,
  /// returns the finest level, which has 64 texels per wavelength. Returns null if there is no
  /// relief, or if a tile, the square after which the relief repeats, is at most 8 pixels wide.
  /// Making a level takes 20 to 100 ms.
  std::shared_ptr<const ReliefLevel> level(double px_per_wavelength);

 private:
  static constexpr int kFinest = 11, kUsual = 10, kCoarsest = 3;

  const HeightField* field_;
  std::mutex mutex_;
  std::array<std::shared_ptr<const ReliefLevel>, kFinest + 1> levels_{};
};

/// Maps pixels of a view to texels of a level: the texel at the middle of pixel (x, y), or, if
/// texels are large, the mean of the texels around it. Steps from pixel to pixel in whole numbers,
/// so the result does not depend on which part of a picture is drawn.
class ReliefPlane {
 public:
  ReliefPlane() = default;
  /// Requires that `level` outlives it. The level is `tile_mm` wide, and its rows point along
  /// `turn`, a vector of length 1 on the page.
  ReliefPlane(const ReliefLevel& level, double tile_mm, const View& view, Vec turn = {1.0, 0.0});

  [[nodiscard]] bool is_flat() const noexcept { return texels_ == nullptr; }
  /// Adds the heights of `count` pixels from (x, y) on, times `weight` / 256, to `sums`.
  void add_row(int x, int y, int count, int weight, int* sums) const noexcept;

 private:
  const std::int8_t* texels_ = nullptr;
  int log2_side_ = 0;
  bool is_between_ = false;  // texels exceed 3/4 of a pixel: interpolates between them
  // Texel coordinates in fixed point: 2^kFraction is one texel. Coordinates beyond the side wrap
  // around.
  std::uint64_t u0_ = 0, v0_ = 0, ux_ = 0, vx_ = 0, uy_ = 0, vy_ = 0;
};

}  // namespace felt
