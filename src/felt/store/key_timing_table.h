#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/document/edit.h"
#include "felt/store/database.h"

namespace felt {

class Document;

/// The timings of layers as key drawings. The table exists only if a layer has a timing. An older
/// program that saves the file keeps the rows of the layers that still exist. The columns are in an
/// order that salvage cannot mistake for another table.
inline constexpr std::string_view kKeyTimingTable =
    "CREATE TABLE key_timing(id INTEGER PRIMARY KEY, timing BLOB NOT NULL, "
    "layer INTEGER NOT NULL, checksum INTEGER NOT NULL)";

/// Largest size of the bytes of a timing.
inline constexpr std::size_t kMaxKeyTimingBytes = std::size_t{1} << 18;

/// Appends a timing as bytes, without loss (docs/formats/felt.md). Equal values give equal bytes.
/// Fails, and appends nothing, if check_key_timing() refuses it.
Result<void> append_key_timing_blob(std::string& out, const KeyTiming& timing);
/// Returns the timing that these bytes describe. Fails if the version is unknown, the number of
/// bytes is wrong, or the content is not valid.
Result<KeyTimingPtr> read_key_timing_blob(std::string_view bytes);
/// Returns the checksum that is stored in the row of a timing.
std::int64_t key_timing_checksum(std::int64_t layer, std::string_view bytes);

/// Creates and fills the table if the document needs it.
Result<void> write_key_timings(Database& database, const Document& document);
/// Reads the table of an untrusted database into the layers that an edit adds. Requires that the
/// database has the table. Fails if a value is invalid, or if a layer does not exist or has two
/// rows.
Result<void> read_key_timings(const Database& database, Edit& edit);

}  // namespace felt
