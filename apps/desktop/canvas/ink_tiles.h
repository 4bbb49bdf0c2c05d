#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "felt/render/tile_painter.h"

namespace felt::desktop {

/// The position of a tile in a plane (see PlaneSpec): tile (x, y) begins at pixel (256 x, 256 y).
struct TilePlace {
  std::int64_t y = 0;
  std::int64_t x = 0;

  friend constexpr auto operator<=>(const TilePlace&, const TilePlace&) noexcept = default;
};

/// A rectangle of pixels of a plane. Its coordinates have 64 bits, because a plane covers the whole
/// page at its scale. x1 and y1 are exclusive.
struct PlaneRect {
  std::int64_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  friend constexpr bool operator==(const PlaneRect&, const PlaneRect&) noexcept = default;
  [[nodiscard]] constexpr bool empty() const noexcept { return x1 <= x0 || y1 <= y0; }
  [[nodiscard]] constexpr PlaneRect inflated(std::int64_t px) const noexcept {
    return {x0 - px, y0 - px, x1 + px, y1 + px};
  }
  [[nodiscard]] constexpr PlaneRect intersected(const PlaneRect& o) const noexcept {
    return {x0 > o.x0 ? x0 : o.x0, y0 > o.y0 ? y0 : o.y0, x1 < o.x1 ? x1 : o.x1,
            y1 < o.y1 ? y1 : o.y1};
  }
};

constexpr std::int64_t floor_to_tile(std::int64_t px) noexcept {
  return px >= 0 ? px / kTileSide : -((kTileSide - 1 - px) / kTileSide);
}

/// The range of tiles that a rectangle of a plane touches, from `first` to `last` inclusive.
struct TileRange {
  TilePlace first, last;

  static constexpr TileRange of(const PlaneRect& px) noexcept {
    return {{floor_to_tile(px.y0), floor_to_tile(px.x0)},
            {floor_to_tile(px.y1 - 1), floor_to_tile(px.x1 - 1)}};
  }
  [[nodiscard]] constexpr bool contains(TilePlace p) const noexcept {
    return p.x >= first.x && p.x <= last.x && p.y >= first.y && p.y <= last.y;
  }
};

constexpr PlaneRect rect_of(TilePlace place) noexcept {
  const std::int64_t x = place.x * kTileSide, y = place.y * kTileSide;
  return {x, y, x + kTileSide, y + kTileSide};
}

/// The pixels of a tile: premultiplied BGRA, rows from top to bottom. It is shared between threads
/// and therefore never changes once published.
struct TilePicture {
  static constexpr std::size_t kBytes = std::size_t{4} * kTileSide * kTileSide;
  std::vector<std::uint8_t> bytes = std::vector<std::uint8_t>(kBytes);
};
/// A published tile. Null means that the tile has no ink.
using TilePtr = std::shared_ptr<const TilePicture>;

/// A plane is a picture of the whole drawing at one scale, angle and style. It is divided into
/// tiles. Pixel (0, 0) of a plane is at a fixed point of the page, so panning does not change the
/// pixels.
struct PlaneSpec {
  std::uint64_t id = 0;
  View view;
  InkStyle style;
  /// If set, the plane shows only the layers above this one. New ink is drawn in this layer, so the
  /// layers above cover it.
  std::optional<LayerId> above{};
};

/// A tile that the worker made, or that it dropped to save memory.
struct TileNews {
  std::uint64_t plane = 0;
  TilePlace place;
  bool is_there = true;
  TilePtr picture;
  PixelRect changed;  ///< changed part of the tile
  /// The tile contains the effect of every order (InkWorker) up to the order with this number.
  std::uint64_t order = 0;
};

}  // namespace felt::desktop
