#pragma once

#include "felt/base/result.h"
#include "felt/store/byte_stream.h"
#include "felt/store/database.h"
#include "felt/store/felt_file.h"

namespace felt {

/// A colour as the files have it, 0xRRGGBBAA.
std::int64_t number_of(Rgba c) noexcept;
Rgba color_of(std::int64_t n) noexcept;
bool is_color_number(std::int64_t n) noexcept;

/// The tables `palette` and `shown`, whose rows stand alone.
Result<void> write_sheet(const Database& db, const Drawing& drawing);
/// Reads them; the palette's name and columns are the drawing's row's.
Result<void> read_sheet(const Database& db, Drawing& drawing);
/// That a file may hold them.
Result<void> check_sheet(const Drawing& drawing);
/// What the checksum of the drawing covers of them.
void append_sheet_bytes(ByteWriter& out, const Drawing& drawing);

}  // namespace felt
