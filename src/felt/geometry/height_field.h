#pragma once

#include <cstdint>
#include <vector>

#include "felt/geometry/point.h"

namespace felt {

/// What grain to make.
struct HeightFieldSpec {
  double wavelength_mm = 1.0;  ///< > 0; all of it lies within a factor 1.25 of this
  double rms_um = 2.0;         ///< >= 0
  std::uint32_t seed = 1;
};

/// The relief of a surface: one for the hand and the eye (R47; specification 5i). A square tile
/// that repeats without a seam, made from a seed, immutable; any thread may read it.
///
/// Made of 96 waves of equal height whose wave numbers lie on the lattice of the tile, in a ring
/// around the wavelength, with phases at random: band-limited by construction, so that the
/// stiffness that a hand feels in it is bounded. Between the 256 x 256 heights of the tile runs a
/// cubic B-spline: height, slope and curvature are all continuous, or the hand would feel texels.
///
/// Made with + - * / and sqrt alone: the same seed gives the same heights on every machine.
class HeightField {
 public:
  static constexpr int kSide = 256;            ///< heights along a side of the tile
  static constexpr double kWavesPerTile = 32;  ///< side of the tile = 32 wavelengths
  static constexpr double kBand = 1.25;

  struct Sample {
    double height_mm = 0.0;
    Vec slope{};  ///< gradient, mm per mm
  };

  /// 20 ms or so: not on the haptic thread.
  explicit HeightField(const HeightFieldSpec& spec);

  /// Height and slope at a point. Real-time safe; points that are not finite or beyond 1e6 mm read
  /// as flat.
  [[nodiscard]] Sample at(Point p) const noexcept;

  [[nodiscard]] const HeightFieldSpec& spec() const noexcept { return spec_; }
  [[nodiscard]] double tile_mm() const noexcept { return kWavesPerTile * spec_.wavelength_mm; }
  [[nodiscard]] double shortest_wavelength_mm() const noexcept {
    return spec_.wavelength_mm / kBand;
  }
  // Upper bounds over the tile, found when it was made.
  [[nodiscard]] double max_height_mm() const noexcept { return max_height_mm_; }
  [[nodiscard]] double max_slope() const noexcept { return max_slope_; }
  /// Largest second derivative in any direction, 1/mm.
  [[nodiscard]] double max_curvature_per_mm() const noexcept { return max_curvature_per_mm_; }

 private:
  void make_waves();
  void find_bounds() noexcept;

  HeightFieldSpec spec_;
  std::vector<float> heights_mm_;  // coefficients of the spline, row by row
  double max_height_mm_ = 0.0;
  double max_slope_ = 0.0;
  double max_curvature_per_mm_ = 0.0;
};

}  // namespace felt
