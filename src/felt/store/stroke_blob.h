#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Limits of a stroke: the number of its segments, and the number of its width knots.
inline constexpr std::size_t kMaxStrokeSegments = 1'000'000;
inline constexpr std::size_t kMaxStrokeKnots = 1'000'000;
/// Longest name of a medium, in bytes of UTF-8.
inline constexpr std::size_t kMaxMaterialNameBytes = 4096;
/// Upper bound of the size of a stroke's blob, in bytes.
inline constexpr std::size_t kMaxStrokeBlobBytes =
    17 * (3 * kMaxStrokeSegments + 1) + 26 * kMaxStrokeKnots + kMaxStrokeSegments / 8 + 8192;

/// Appends a stroke as bytes, without loss (docs/formats/felt.md): a version, the shape with every
/// double bit for bit, and a CRC-32C of everything. Equal strokes give equal bytes. Fails, and
/// appends nothing, if the stroke is larger than the limits above.
Result<void> append_stroke_blob(std::string& out, const Stroke& stroke);

/// Returns the stroke that these bytes describe. Fails if the version is unknown, the checksum is
/// wrong, the number of bytes is wrong, or the content is not a valid stroke (Stroke::create).
Result<Stroke> read_stroke_blob(std::string_view bytes);

}  // namespace felt
