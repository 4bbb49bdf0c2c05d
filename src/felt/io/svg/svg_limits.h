#pragma once

#include <cstddef>
#include <cstdint>

/// What the reader of SVG accepts beyond what holds for all XML (limits.h); docs/formats/svg.md
/// tells users the same numbers. Beyond the first two a file is refused, of the others the rest is
/// left out with a notice.
namespace felt::limits {

/// Of one element.
inline constexpr std::size_t kMaxSvgAttributes = 1000;
/// What entities of the document type may add to a file.
inline constexpr std::size_t kMaxSvgEntityBytes = std::size_t{1} << 20;

/// Elements that `use` repeats, all of a file together.
inline constexpr std::int64_t kMaxSvgUseElements = 100'000;
/// Bytes of attributes that `use` makes us read again.
inline constexpr std::int64_t kMaxSvgUseBytes = std::int64_t{64} << 20;
/// Curves: of a file with n bytes, kSpareSvgSegments + n / 2, and at most kMaxSvgSegments. A file
/// has room for n / 2 of its own; the others are for those that `use` repeats.
inline constexpr std::size_t kMaxSvgSegments = 20'000'000;
inline constexpr std::size_t kSpareSvgSegments = 500'000;
/// A number of path data: of ours they are steps of 0.001 mm.
inline constexpr double kMaxSvgPathNumber = 1e13;
/// Dashes of all lines together.
inline constexpr std::size_t kMaxSvgDashes = 100'000;
/// Segments of one stroke, fewer than a .felt file takes; a longer path becomes several strokes.
inline constexpr std::size_t kMaxSvgStrokeSegments = 250'000;
/// Layers of a drawing; further ones join the last.
inline constexpr std::size_t kMaxSvgLayers = 10'000;
}  // namespace felt::limits
