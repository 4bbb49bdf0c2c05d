#pragma once

#include "felt/base/result.h"
#include "felt/store/byte_writer.h"
#include "felt/store/database.h"
#include "felt/store/felt_file.h"

namespace felt {

/// Convert between a colour and its number in files, 0xRRGGBBAA.
std::int64_t number_of(Rgba c) noexcept;
Rgba color_of(std::int64_t n) noexcept;
bool is_color_number(std::int64_t n) noexcept;

/// Writes the tables `palette` and `shown`, whose rows do not refer to other tables.
Result<void> write_page(const Database& db, const Drawing& drawing);
/// Reads the tables `palette` and `shown`. The palette's name and columns are in the row of the
/// table `drawing`.
Result<void> read_page(const Database& db, Drawing& drawing);
/// Checks that palette and view are within the limits of the format.
Result<void> check_page(const Drawing& drawing);
/// Appends the part of palette and view that the drawing's checksum covers.
void append_page_bytes(ByteWriter& out, const Drawing& drawing);

}  // namespace felt
