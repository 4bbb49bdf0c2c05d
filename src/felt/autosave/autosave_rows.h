#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "felt/autosave/autosave_database.h"
#include "felt/base/result.h"
#include "felt/store/felt_file.h"

namespace felt {

// The rows of an autosave database, for writing and reading.

/// The SQLite application id "FltW", and the version of this format. Other versions are not read.
/// This is acceptable because the file never leaves the machine.
inline constexpr std::uint32_t kAutosaveApplicationId = 0x466c7457;
inline constexpr std::uint32_t kAutosaveVersion = 1;

/// The schema.
inline constexpr std::array kAutosaveTables = {
    // Parts of bases; id = generation << 32 | part.
    "CREATE TABLE base(id INTEGER PRIMARY KEY, crc INTEGER NOT NULL, bytes BLOB NOT NULL)",
    // Complete bases, one in each row: the serial number of the last edit that the base contains,
    // and the number of its parts.
    "CREATE TABLE generation(id INTEGER PRIMARY KEY, serial INTEGER NOT NULL, "
    "parts INTEGER NOT NULL, crc INTEGER NOT NULL)",
    "CREATE TABLE edit(serial INTEGER PRIMARY KEY, crc INTEGER NOT NULL, bytes BLOB NOT NULL)",
    "CREATE TABLE about(id INTEGER PRIMARY KEY, crc INTEGER NOT NULL, bytes BLOB NOT NULL)",
    "CREATE TABLE live(sequence INTEGER PRIMARY KEY, kind INTEGER NOT NULL, "
    "length INTEGER NOT NULL, crc INTEGER NOT NULL, bytes BLOB NOT NULL)"};

/// Usual size of a part. A damaged SQLite page destroys up to eight parts.
inline constexpr std::size_t kBasePartBytes = std::size_t{64} << 10;
inline constexpr std::size_t kMinTextBytes = 4;

constexpr std::int64_t base_row(std::uint64_t generation, std::uint64_t part) noexcept {
  return static_cast<std::int64_t>(generation << 32 | part);
}

/// Name of the database until its schema is complete.
inline constexpr const char* kNewDatabaseFile = "store.new";
/// Name of the copy that recovery reads.
inline constexpr const char* kCopiedDatabaseFile = "copy.db";
/// Deletes the autosave's files in a folder. Also deletes the folder if it contains no other files.
Result<void> remove_autosave_folder(const std::string& folder);

/// Returns the checksum of a row, which covers its numbers and then its bytes.
std::int64_t row_crc(std::uint64_t a, std::uint64_t b, std::string_view bytes) noexcept;

/// Returns the first part of a base, which has everything except strokes and fills.
Result<std::string> base_head_bytes(const Drawing& drawing);
/// Reads the first part of a base. The returned drawing has all its layers, but no strokes and
/// fills. Its document reserves the ids that were ever used.
Result<Drawing> read_base_head(std::string_view bytes);

/// The content of each part after the first: consecutive strokes and fills of one
/// layer.
struct BaseRun {
  LayerId layer;
  std::vector<std::pair<StrokeId, StrokePtr>> strokes;
  std::vector<std::pair<FillId, FillPtr>> fills;
};
/// Returns a part with the strokes and then the fills of `layer` from `index` on, until the part is
/// full or the layer ends. Fills are counted after strokes. Sets `index` to the first object that
/// is not in the part.
Result<std::string> base_run_bytes(const Document& document, const Layer& layer,
                                   std::size_t& index);
Result<BaseRun> read_base_run(std::string_view bytes);

Result<std::string> info_bytes(const AutosaveInfo& about);
/// Reads an AutosaveInfo. The document of AutosaveInfo::head is empty.
Result<AutosaveInfo> read_info(std::string_view bytes);

}  // namespace felt
