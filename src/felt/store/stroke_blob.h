#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// Largest stroke, in bytes of its blob: a million segments and their widths.
inline constexpr std::size_t kMaxStrokeBlobBytes = std::size_t{64} << 20;

/// Appends a stroke as bytes, exactly (docs/formats/felt.md): a version, the shape with every
/// double by its bits, and a CRC-32C of it all. Equal strokes give equal bytes. Nothing is
/// appended on error: the stroke is larger than kMaxStrokeBlobBytes.
Result<void> append_stroke_blob(std::string& out, const Stroke& stroke);

/// The stroke that the whole of these bytes says. Error: an unknown version, a wrong checksum, too
/// few bytes or too many, or no stroke (Stroke::create).
Result<Stroke> read_stroke_blob(std::string_view bytes);

}  // namespace felt
