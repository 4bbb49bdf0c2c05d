#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "felt/geometry/point.h"

namespace felt {

/// The pattern of a relief. No pattern has waves shorter than wavelength_mm / 1.25.
enum class HeightCharacter : std::uint8_t {
  kGrain,    ///< equal in all directions, all waves within a factor 1.25 of the wavelength
  kRough,    ///< cold-pressed paper: round hills of several sizes, and the imprint of a press cloth
  kWeave,    ///< canvas: two crossed sets of threads, each thread one wavelength from the next
  kFibres,   ///< fibres that cross each other
  kWood,     ///< annual rings cut lengthwise, along x, and fine fibre between them
  kPicture,  ///< a custom picture (height_picture.h)
};

/// The parameters of a relief.
struct HeightFieldSpec {
  double wavelength_mm = 1.0;  ///< > 0; the tile is 32 wavelengths wide
  double rms_um = 2.0;         ///< >= 0
  std::uint32_t seed = 1;
  HeightCharacter character = HeightCharacter::kGrain;
};

/// The relief of a surface, which the user feels and sees (R47; docs/design/forces.md#texture). It
/// is a square tile, made from a seed, that repeats without a visible edge. Immutable; any thread
/// may read it.
///
/// The relief is band-limited, so that the stiffness that the user feels in it is bounded. Grain is
/// band-limited by construction: it is the sum of 96 waves of equal amplitude and random phase. In
/// x and in y, each wave fits a whole number of times into the tile, and its length is within a
/// factor of 1.25 of the wavelength. The other characters are filtered with a Fourier transform,
/// which removes shorter waves. The 256 x 256 heights of the tile are interpolated with a cubic
/// B-spline, so that height, slope and curvature are continuous; otherwise the user would feel the
/// cells of the tile.
///
/// Uses only + - * / and sqrt, so that the same seed gives the same heights on every machine.
class HeightField {
 public:
  static constexpr int kSide = 256;            ///< heights along a side of the tile
  static constexpr double kWavesPerTile = 32;  ///< side of the tile = 32 wavelengths
  static constexpr double kBand = 1.25;        ///< shortest wave = wavelength / kBand

  struct Sample {
    double height_mm = 0.0;
    Vec slope{};  ///< gradient, mm per mm
  };

  /// Makes the relief of a character. For kPicture, makes grain, because the picture is not known
  /// here. Takes 20 to 60 ms, so do not call it on the haptic thread.
  explicit HeightField(const HeightFieldSpec& spec);
  /// Makes a relief from kSide x kSide heights in any unit, row by row, which are scaled to the rms
  /// of `spec`. The heights should repeat without a seam and have no wave shorter than
  /// wavelength_mm / 1.25, like those that height_picture.h makes. The relief is flat if the number
  /// of heights is wrong or a height is not finite.
  HeightField(const HeightFieldSpec& spec, const std::vector<double>& tile);
  /// Returns the same relief in another size. The copy shares the tile, so this is fast. The result
  /// is flat if a value is not finite or not > 0.
  [[nodiscard]] HeightField scaled(double wavelength_mm, double rms_um) const;

  /// Returns the height and slope at a point. Both are 0 if the relief is flat, or if a coordinate
  /// is not finite or its magnitude is above 1e6 mm. Real-time safe.
  [[nodiscard]] Sample at(Point p) const noexcept;

  [[nodiscard]] const HeightFieldSpec& spec() const noexcept { return spec_; }
  [[nodiscard]] double tile_mm() const noexcept { return kWavesPerTile * spec_.wavelength_mm; }
  [[nodiscard]] double shortest_wavelength_mm() const noexcept {
    return spec_.wavelength_mm / kBand;
  }
  /// Returns an upper bound of the magnitude of the height anywhere.
  [[nodiscard]] double max_height_mm() const noexcept { return max_height_mm_; }
  [[nodiscard]] double max_slope() const noexcept { return max_slope_; }
  /// Returns an upper bound of the second derivative in any direction, 1/mm.
  [[nodiscard]] double max_curvature_per_mm() const noexcept { return max_curvature_per_mm_; }

 private:
  /// The spline coefficients of a tile of wavelength 1 and rms 1, row by row.
  struct Tile {
    std::vector<float> heights;
    double max_height = 0.0, max_slope = 0.0, max_curvature = 0.0;
  };
  static std::shared_ptr<const Tile> tile_of(const std::vector<double>& heights);
  static void find_bounds(Tile& tile) noexcept;
  void size();

  HeightFieldSpec spec_;
  std::shared_ptr<const Tile> tile_;  // null: flat
  double rms_mm_ = 0.0;
  double max_height_mm_ = 0.0;
  double max_slope_ = 0.0;
  double max_curvature_per_mm_ = 0.0;
};

}  // namespace felt
