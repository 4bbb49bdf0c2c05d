#pragma once

#include <memory>

#include "felt/geometry/point.h"
#include "felt/render/relief_texture.h"

namespace felt {

/// The grain that dry media add by themselves: dust, crumbs, and the fine tooth of the paper.
///
/// Unlike a relief, it has no wavelength. It is white noise, smoothed with round kernels of several
/// sizes, each about twice as wide as the one before, and added. So the correlation of two points
/// falls steadily with their distance, and nobody sees a cell or a lattice at any scale. It repeats
/// after kWavesPerTile crumbs, and is rotated against the page, so that a horizontal or vertical
/// line never meets the same grain again.
///
/// Uses only integers and + - * / and sqrt, so it is the same on every machine.
namespace dust {

/// Side of the tile, in widths of the coarsest crumbs (MediumLook::crumb_mm).
inline constexpr double kWavesPerTile = 64.0;
/// The direction of the tile's rows on the page: 24 degrees.
inline constexpr Vec kTurn{0.91354546, 0.40673664};

/// Returns the height at a point of a dust whose coarsest crumbs have width 1. Its mean is 0 and
/// its RMS 1.
double height(Point place);

/// Returns the level of detail for a tile of `px_per_tile` pixels (ReliefTexture::level). The first
/// call takes about 50 ms. Safe to use from any thread.
std::shared_ptr<const ReliefLevel> level(double px_per_tile);

}  // namespace dust
}  // namespace felt
