#include "felt/geometry/height_picture.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "felt/geometry/height_tile.h"

namespace felt {
namespace {

using height_tile::Tile;

/// The pixels that one cell of the tile covers. If the picture is enlarged, these are the two
/// neighbouring pixels, and `part` is the position between them, 0..1.
struct Covered {
  int first = 0, last = 0;
  double part = 0.0;
};

Covered covered(int place, int count) noexcept {
  const double step = static_cast<double>(count) / height_tile::kSide;
  if (step >= 1.0) {
    const int first = static_cast<int>(place * step);
    return {first, std::max(first, std::min(static_cast<int>((place + 1) * step), count) - 1), 0.0};
  }
  const double at = std::clamp((place + 0.5) * step - 0.5, 0.0, count - 1.0);
  const int first = static_cast<int>(at);
  return {first, std::min(first + 1, count - 1), at - first};
}

/// Returns the weight of a pixel in a cell: all covered pixels count the same if the picture is
/// shrunk; otherwise the two neighbours are interpolated linearly.
double share_of(const Covered& covered, int pixel, bool is_shrunk) noexcept {
  if (is_shrunk) return 1.0 / (covered.last - covered.first + 1);
  const double second = covered.first == covered.last ? 0.0 : covered.part;
  return pixel == covered.first ? 1.0 - second : second;
}

Tile fitted(const HeightPicture& picture) {
  Tile tile(std::size_t{height_tile::kSide} * height_tile::kSide, 0.0);
  const bool shrinks_x = picture.width >= height_tile::kSide,
             shrinks_y = picture.height >= height_tile::kSide;
  for (int y = 0; y < height_tile::kSide; ++y) {
    const Covered rows = covered(y, picture.height);
    for (int x = 0; x < height_tile::kSide; ++x) {
      const Covered columns = covered(x, picture.width);
      double sum = 0.0;
      for (int row = rows.first; row <= rows.last; ++row) {
        const std::size_t line =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width);
        double of_row = 0.0;
        for (int column = columns.first; column <= columns.last; ++column) {
          of_row += share_of(columns, column, shrinks_x) *
                    static_cast<double>(picture.heights[line + static_cast<std::size_t>(column)]);
        }
        sum += share_of(rows, row, shrinks_y) * of_row;
      }
      tile[static_cast<std::size_t>(y * height_tile::kSide + x)] = sum;
    }
  }
  return tile;
}

void remove_mean(Tile& tile) noexcept {
  double mean = 0.0;
  for (const double h : tile) mean += h / static_cast<double>(tile.size());
  for (double& h : tile) h -= mean;
}

double at(const Tile& tile, int x, int y, bool turned) noexcept {
  const int column = turned ? y : x, row = turned ? x : y;
  return tile[static_cast<std::size_t>((row & (height_tile::kSide - 1)) * height_tile::kSide +
                                       (column & (height_tile::kSide - 1)))];
}

/// Returns true if the seam is as smooth as the inside: the mean squared step from the last column
/// to the first is at most kLikely times that between other neighbouring columns.
bool meets(const Tile& tile, bool turned) noexcept {
  double seam = 0.0, within = 0.0;
  for (int y = 0; y < height_tile::kSide; ++y) {
    for (int x = 0; x < height_tile::kSide; ++x) {
      const double step = at(tile, x + 1, y, turned) - at(tile, x, y, turned);
      (x + 1 == height_tile::kSide ? seam : within) += step * step;
    }
  }
  constexpr double kLikely = 2.0;
  return seam <= kLikely * within / (height_tile::kSide - 1);
}

/// Blends the tile, near both edges, with a copy shifted by half its width. Divides by the root of
/// the sum of the squared weights, so that the rms height stays the same; this is right for
/// uncorrelated reliefs, as these two usually are.
Tile joined(const Tile& tile, bool turned) {
  Tile out(tile.size());
  for (int y = 0; y < height_tile::kSide; ++y) {
    for (int x = 0; x < height_tile::kSide; ++x) {
      const double from_edge =
          2.0 * std::min(x + 0.5, height_tile::kSide - x - 0.5) / height_tile::kSide;
      const double t = std::clamp(2.0 * from_edge, 0.0, 1.0);
      const double own = t * t * (3.0 - 2.0 * t);
      const double moved = 1.0 - own;
      const int column = turned ? y : x, row = turned ? x : y;
      out[static_cast<std::size_t>(row * height_tile::kSide + column)] =
          (own * at(tile, x, y, turned) + moved * at(tile, x + height_tile::kSide / 2, y, turned)) /
          std::sqrt(own * own + moved * moved);
    }
  }
  return out;
}

}  // namespace

Result<HeightField> height_field_of(const HeightPicture& picture, const HeightPictureSpec& spec) {
  const auto is_within = [](double value, double smallest, double largest) {
    return value >= smallest && value <= largest;
  };
  if (!is_within(spec.tile_mm, 5.0, 500.0) || !is_within(spec.height_um, 0.0, 1000.0)) {
    return fail(ErrorCode::kInvalidArgument,
                "a relief must be 5 to 500 mm wide and at most 1000 um high");
  }
  const bool fits = picture.width > 0 && picture.height > 0 &&
                    picture.heights.size() == static_cast<std::size_t>(picture.width) *
                                                  static_cast<std::size_t>(picture.height) &&
                    std::all_of(picture.heights.begin(), picture.heights.end(),
                                [](float h) { return std::isfinite(h); });
  if (!fits)
    return fail(ErrorCode::kInvalidData,
                "the number of heights does not match the size of the relief");
  Tile tile = fitted(picture);
  remove_mean(tile);
  for (const bool turned : {false, true}) {
    if (!meets(tile, turned)) tile = joined(tile, turned);
  }
  height_tile::keep_band(tile, 1.0, height_tile::kFadeFrom, height_tile::kMaxWaves);
  double squares = 0.0;
  for (const double h : tile) squares += h * h;
  const double rms = std::sqrt(squares / static_cast<double>(tile.size()));
  constexpr double kMin = 1e-5;  // of the range from black to white
  if (!(rms > kMin)) {
    return fail(ErrorCode::kInvalidData, "the relief of the picture is too fine to feel");
  }
  return HeightField({.wavelength_mm = spec.tile_mm / HeightField::kWavesPerTile,
                      .rms_um = rms * spec.height_um,
                      .character = HeightCharacter::kPicture},
                     tile);
}

}  // namespace felt
