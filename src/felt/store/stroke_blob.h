#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Largest stroke: that many segments, and breakpoints of its width.
inline constexpr std::size_t kMaxStrokeSegments = 1'000'000;
inline constexpr std::size_t kMaxStrokeKnots = 1'000'000;
/// Longest name of a material, in bytes of UTF-8.
inline constexpr std::size_t kMaxMaterialNameBytes = 4096;
/// No stroke has more bytes as a blob.
inline constexpr std::size_t kMaxStrokeBlobBytes =
    17 * (3 * kMaxStrokeSegments + 1) + 26 * kMaxStrokeKnots + kMaxStrokeSegments / 8 + 8192;

/// Appends a stroke as bytes, exactly (docs/formats/felt.md): a version, the shape with every
/// double to its last bit, and a CRC-32C of it all. Equal strokes give equal bytes. Nothing is
/// appended on error: the stroke is larger than the limits above.
Result<void> append_stroke_blob(std::string& out, const Stroke& stroke);

/// The stroke that the whole of these bytes says. Error: an unknown version, a wrong checksum, too
/// few bytes or too many, or no stroke (Stroke::create).
Result<Stroke> read_stroke_blob(std::string_view bytes);

}  // namespace felt
