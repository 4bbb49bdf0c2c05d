#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "felt/autosave/working_store.h"
#include "felt/base/result.h"
#include "felt/store/felt_file.h"

namespace felt {

// What the rows of a working store say, for who writes and who reads them.

/// "FltW", and the version of this format. It never leaves the machine: another version is not
/// read.
inline constexpr std::uint32_t kWorkingApplicationId = 0x466c7457;
inline constexpr std::uint32_t kWorkingVersion = 1;

/// The schema.
inline constexpr std::array kWorkingTables = {
    // Parts of bases; id = generation << 32 | part.
    "CREATE TABLE base(id INTEGER PRIMARY KEY, crc INTEGER NOT NULL, bytes BLOB NOT NULL)",
    // Bases that are whole, what edits they come after, and how many parts they have.
    "CREATE TABLE generation(id INTEGER PRIMARY KEY, serial INTEGER NOT NULL, "
    "parts INTEGER NOT NULL, crc INTEGER NOT NULL)",
    "CREATE TABLE edit(serial INTEGER PRIMARY KEY, crc INTEGER NOT NULL, bytes BLOB NOT NULL)",
    "CREATE TABLE about(id INTEGER PRIMARY KEY, crc INTEGER NOT NULL, bytes BLOB NOT NULL)",
    "CREATE TABLE live(sequence INTEGER PRIMARY KEY, kind INTEGER NOT NULL, "
    "length INTEGER NOT NULL, crc INTEGER NOT NULL, bytes BLOB NOT NULL)"};

inline constexpr std::size_t kBasePartBytes = std::size_t{64}
                                              << 10;  ///< as a rule; a damaged page costs eight
inline constexpr std::size_t kLeastTextBytes = 4;

constexpr std::int64_t base_row(std::uint64_t generation, std::uint64_t part) noexcept {
  return static_cast<std::int64_t>(generation << 32 | part);
}

/// The database until its schema is whole.
inline constexpr const char* kNewStoreFile = "store.new";
/// What recovery calls the copy that it reads.
inline constexpr const char* kCopiedStoreFile = "copy.db";
/// Deletes what is ours in such a folder, and the folder where nothing else is in it.
Result<void> remove_store_folder(const std::string& folder);

/// Of a row: its numbers, then its bytes.
std::int64_t row_crc(std::uint64_t a, std::uint64_t b, std::string_view bytes) noexcept;

/// The first part of a base: everything but the strokes.
Result<std::string> base_head_bytes(const StoredDrawing& drawing);
/// The drawing without its strokes: all its layers, ids that were ever taken.
Result<StoredDrawing> read_base_head(std::string_view bytes);

/// Further parts: a run of strokes of one layer.
struct BaseRun {
  LayerId layer;
  std::vector<std::pair<StrokeId, StrokePtr>> strokes;
};
/// Takes strokes from `index` on and moves it, until the part is full or the layer ends.
Result<std::string> base_run_bytes(const Document& document, const Layer& layer,
                                   std::size_t& index);
Result<BaseRun> read_base_run(std::string_view bytes);

Result<std::string> about_bytes(const WorkingAbout& about);
/// The head's document is empty.
Result<WorkingAbout> read_about(std::string_view bytes);

}  // namespace felt
