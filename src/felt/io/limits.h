#pragma once

#include <cstddef>

#include "felt/geometry/point.h"

/// What the readers of this layer accept. Everything above is an error that names its place;
/// nothing is clamped in silence. docs/formats/ndjson.md and events.md tell users the same numbers.
namespace felt::limits {

/// Longest line, terminator not counted. A longer one is skipped without being kept in memory.
/// Room for a stroke of ten million samples at 50 characters each.
inline constexpr std::size_t kMaxLineBytes = std::size_t{512} << 20;

/// Longest number as written.
inline constexpr std::size_t kMaxNumberChars = 64;

/// Largest magnitude of a coordinate of raw ink, in the unit of the file. 1e9 mm is 1000 km.
inline constexpr double kMaxCoordinate = kMaxCoordinateMm;

/// Largest magnitude of a number in a sketch: a curve through ink at the limit above may reach a
/// little beyond it, and its handles as far as the samples are apart.
inline constexpr double kMaxSketchNumber = 1e10;

/// Largest magnitude of a time in ms, so that it fits int64 nanoseconds. Larger than
/// kMaxCoordinate because recorders write milliseconds since 1970 (1.8e12).
inline constexpr double kMaxTimeMs = 9e12;

/// Latest time of an event in ms since the session began: 11 days, which a double of milliseconds
/// holds to the nanosecond.
inline constexpr double kMaxEventTimeMs = 1e9;

/// Longest stroke id or material name, in bytes after unescaping.
inline constexpr std::size_t kMaxNameBytes = 4096;

/// Longest text of a material that a drawing carries, in bytes, and how many it carries.
inline constexpr std::size_t kMaxMaterialTextBytes = std::size_t{64} << 10;
inline constexpr std::size_t kMaxMaterialTexts = 64;

/// Deepest nesting inside a key that we ignore.
inline constexpr int kMaxIgnoredDepth = 64;

/// Largest file of a foreign format, also once it is unpacked.
inline constexpr std::size_t kMaxImportBytes = std::size_t{256} << 20;

/// A packed file may become this many times larger, once it is past kFreeInflatedBytes.
inline constexpr std::size_t kMaxInflation = 100;
inline constexpr std::size_t kFreeInflatedBytes = std::size_t{8} << 20;

/// Deepest nesting of XML elements; a root without children is 1 deep.
inline constexpr int kMaxXmlDepth = 256;

/// Most XML elements in a file.
inline constexpr std::size_t kMaxXmlElements = 2'000'000;

/// Points of a stroke of a foreign format; more of them become several strokes, one after the
/// other.
inline constexpr std::size_t kMaxStrokePoints = 500'000;

}  // namespace felt::limits
