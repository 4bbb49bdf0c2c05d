#pragma once

#include <cstddef>
#include <cstdint>

/// Limits of the SVG reader, in addition to those for all XML (limits.h). docs/formats/svg.md gives
/// users the same numbers. A file beyond one of the first two limits is refused. For all other
/// limits, the content beyond the limit is skipped with a notice.
namespace felt::limits {

/// Maximum number of attributes of one element.
inline constexpr std::size_t kMaxSvgAttributes = 1000;
/// Maximum number of bytes that entities of the document type may add to a file.
inline constexpr std::size_t kMaxSvgEntityBytes = std::size_t{1} << 20;

/// Maximum number of elements that `use` repeats in the whole file.
inline constexpr std::int64_t kMaxSvgUseElements = 100'000;
/// Maximum number of bytes of attributes that are read again because of `use`.
inline constexpr std::int64_t kMaxSvgUseBytes = std::int64_t{64} << 20;
/// A file of n bytes may have at most kSpareSvgSegments + n / 2 curves, and at most kMaxSvgSegments
/// in any case. The text of the file cannot contain more than n / 2 curves; kSpareSvgSegments is
/// for curves that `use` repeats.
inline constexpr std::size_t kMaxSvgSegments = 20'000'000;
inline constexpr std::size_t kSpareSvgSegments = 500'000;
/// Maximum magnitude of a number in path data.
inline constexpr double kMaxSvgPathNumber = 1e13;
/// Maximum number of dashes of all lines together.
inline constexpr std::size_t kMaxSvgDashes = 100'000;
/// Maximum number of segments of one stroke. This is less than a .felt file allows. A longer path
/// becomes several strokes.
inline constexpr std::size_t kMaxSvgStrokeSegments = 250'000;
/// Maximum number of pictures, and of their pixels together. 2^27 is twice the largest picture; a
/// small file could otherwise take minutes, because its pictures are unpacked once to check them.
inline constexpr std::size_t kMaxSvgPictures = 200;
inline constexpr std::int64_t kMaxSvgPicturePixels = std::int64_t{1} << 27;
/// Maximum number of bytes of pictures in other files together.
inline constexpr std::size_t kMaxSvgPictureFileBytes = std::size_t{256} << 20;
/// Maximum number of groups with a blend mode. Each becomes a layer that is blended as a whole,
/// which takes the time and memory of a picture of the page. The blend mode of further groups is
/// ignored.
inline constexpr std::size_t kMaxSvgBlendedGroups = 200;
/// Maximum number of layers of a drawing. Further layers are merged into the last one.
inline constexpr std::size_t kMaxSvgLayers = 10'000;
}  // namespace felt::limits
