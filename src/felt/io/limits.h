#pragma once

#include <cstddef>

#include "felt/geometry/point.h"

/// Limits of the readers in this layer. Anything beyond a limit is an error that names its
/// position; no value is clamped silently. docs/formats/ndjson.md and events.md give users the same
/// numbers.
namespace felt::limits {

/// Longest line, without its terminator. A longer line is skipped without being kept in memory. The
/// limit is enough for a stroke of ten million samples at 50 characters each.
inline constexpr std::size_t kMaxLineBytes = std::size_t{512} << 20;

/// Longest number, in characters.
inline constexpr std::size_t kMaxNumberChars = 64;

/// Largest magnitude of a coordinate of raw ink, in the unit of the file. 1e9 mm is 1000 km.
inline constexpr double kMaxCoordinate = kMaxCoordinateMm;

/// Largest magnitude of a number in a sketch line (a fitted stroke). It is larger than
/// kMaxCoordinate, because a curve that was fitted to samples near kMaxCoordinate may reach
/// slightly beyond it, and the control points of the curve may lie even farther out.
inline constexpr double kMaxSketchNumber = 1e10;

/// Largest magnitude of a time in ms, so that it fits int64 nanoseconds. It must allow milliseconds
/// since 1970 (1.8e12), which some recorders write.
inline constexpr double kMaxTimeMs = 9e12;

/// Latest time of an event, in ms since the session began: 11 days. In that range, a double in
/// milliseconds still distinguishes all nanoseconds.
inline constexpr double kMaxEventTimeMs = 1e9;

/// Longest stroke id or material name, in bytes after unescaping.
inline constexpr std::size_t kMaxNameBytes = 4096;

/// Longest text of a material in a drawing, in bytes, and largest number of such texts.
inline constexpr std::size_t kMaxMaterialTextBytes = std::size_t{64} << 10;
inline constexpr std::size_t kMaxMaterialTexts = 64;

/// Deepest nesting in the value of an ignored key.
inline constexpr int kMaxIgnoredDepth = 64;

/// Largest file of a foreign format, both packed and unpacked.
inline constexpr std::size_t kMaxImportBytes = std::size_t{256} << 20;

/// Largest ratio of unpacked to packed size, for files whose unpacked size exceeds
/// kFreeInflatedBytes.
inline constexpr std::size_t kMaxInflation = 100;
inline constexpr std::size_t kFreeInflatedBytes = std::size_t{8} << 20;

/// Deepest nesting of XML elements. A root without children has depth 1.
inline constexpr int kMaxXmlDepth = 256;

/// Largest number of XML elements in a file.
inline constexpr std::size_t kMaxXmlElements = 2'000'000;

/// Largest number of points in a stroke of a foreign format. A longer stroke is divided into
/// several consecutive strokes.
inline constexpr std::size_t kMaxStrokePoints = 500'000;

}  // namespace felt::limits
