#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "felt/geometry/point.h"

namespace felt {

/// What a relief looks like. None has waves shorter than wavelength_mm / 1.25.
enum class HeightCharacter : std::uint8_t {
  kGrain,    ///< even in all directions, all waves within a factor 1.25 of the wavelength
  kRough,    ///< cold-pressed paper: round hills of several sizes, and the mark of the felt
  kWeave,    ///< canvas: two crossed systems of threads, a wavelength apart
  kFibres,   ///< fibres that lie across each other
  kWood,     ///< year rings cut lengthwise, along x, and fine fibre between them
  kPicture,  ///< somebody's own (height_picture.h)
};

/// What relief to make.
struct HeightFieldSpec {
  double wavelength_mm = 1.0;  ///< > 0; the tile is 32 of it
  double rms_um = 2.0;         ///< >= 0
  std::uint32_t seed = 1;
  HeightCharacter character = HeightCharacter::kGrain;
};

/// The relief of a surface: one for the hand and the eye (R47; specification 5i). A square tile
/// that repeats without a seam, made from a seed, immutable; any thread may read it.
///
/// Band-limited, so that the stiffness that a hand feels in it is bounded. Grain is that by
/// construction, 96 waves of equal height whose wave numbers lie on the lattice of the tile, in a
/// ring around the wavelength, with phases at random; what another character draws goes through a
/// Fourier transform that leaves nothing shorter. Between the 256 x 256 heights of the tile runs a
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

  /// 20 to 60 ms: not on the haptic thread. A character kPicture without a picture is grain.
  explicit HeightField(const HeightFieldSpec& spec);
  /// From kSide x kSide heights in any unit, row by row, that repeat without a seam and hold no
  /// wave shorter than wavelength_mm / 1.25 (height_picture.h makes such); they get the rms of
  /// `spec`. Anything else than that many finite numbers is flat.
  HeightField(const HeightFieldSpec& spec, const std::vector<double>& tile);
  /// The same relief in another size, without making it again: shares the tile. Flat where a figure
  /// is not finite or not > 0.
  [[nodiscard]] HeightField scaled(double wavelength_mm, double rms_um) const;

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
  /// Of wavelength 1 and rms 1; coefficients of the spline, row by row.
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
