#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/document/fill.h"

namespace felt {

/// Upper bound of the size of a fill's blob, in bytes.
inline constexpr std::size_t kMaxFillBlobBytes =
    (48 + 26) * kMaxFillSegments + 20 * kMaxFillLoops + 64;

/// Appends a fill as bytes, without loss (docs/formats/felt.md): a version, the colour, the gap and
/// the loops. Equal fills give equal bytes. The bytes have no checksum of their own. Fails, and
/// appends nothing, if the fill is not valid (check_fill).
Result<void> append_fill_blob(std::string& out, const Fill& fill);

/// Returns the fill that these bytes describe. Fails if the version is unknown, the number of bytes
/// is wrong, or the content is not a valid fill (check_fill).
Result<FillPtr> read_fill_blob(std::string_view bytes);

}  // namespace felt
