#pragma once

#include <cstddef>
#include <cstdint>

/// Limits of the SVG reader, in addition to those for all XML (limits.h). docs/formats/svg.md gives
/// users the same numbers. A file beyond one of the first two is refused. For all others, the
/// content beyond the limit is skipped with a notice.
namespace felt::limits {

/// Attributes of one element.
inline constexpr std::size_t kMaxSvgAttributes = 1000;
/// Bytes that entities of the document type may add to a file.
inline constexpr std::size_t kMaxSvgEntityBytes = std::size_t{1} << 20;

/// Elements that `use` repeats, in the whole file.
inline constexpr std::int64_t kMaxSvgUseElements = 100'000;
/// Bytes of attributes that are read again because of `use`.
inline constexpr std::int64_t kMaxSvgUseBytes = std::int64_t{64} << 20;
/// Curves: for a file of n bytes, kSpareSvgSegments + n / 2, and at most kMaxSvgSegments. A file
/// has room for n / 2 of its own; the rest is for those that `use` repeats.
inline constexpr std::size_t kMaxSvgSegments = 20'000'000;
inline constexpr std::size_t kSpareSvgSegments = 500'000;
/// A number in path data. In our files numbers are steps of 0.001 mm.
inline constexpr double kMaxSvgPathNumber = 1e13;
/// Dashes of all lines together.
inline constexpr std::size_t kMaxSvgDashes = 100'000;
/// Segments of one stroke, fewer than a .felt file allows. A longer path becomes several strokes.
inline constexpr std::size_t kMaxSvgStrokeSegments = 250'000;
/// Layers of a drawing. Further layers are merged into the last one.
inline constexpr std::size_t kMaxSvgLayers = 10'000;
}  // namespace felt::limits
