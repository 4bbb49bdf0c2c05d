#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/document.h"
#include "felt/store/database.h"

namespace felt {

/// The tables `guide` and `symmetry` of a file. A drawing without guides or without linked strokes
/// does not have the table, nor do files that were written before these existed. An older program
/// that saves the file keeps both tables.
inline constexpr std::string_view kGuideTable =
    "CREATE TABLE guide(id INTEGER PRIMARY KEY, shown INTEGER NOT NULL, guide BLOB NOT NULL, "
    "checksum INTEGER NOT NULL)";
inline constexpr std::string_view kSymmetryTable =
    "CREATE TABLE symmetry(id INTEGER PRIMARY KEY, strokes BLOB NOT NULL, "
    "checksum INTEGER NOT NULL)";

/// Largest number of guides and of symmetry groups that a table may have.
inline constexpr std::size_t kMaxStoredGuides = 10'000;
inline constexpr std::size_t kMaxStoredSymmetries = 10'000'000;

/// Appends a guide or a symmetry group as bytes, without loss (docs/formats/felt.md). Equal values
/// give equal bytes. Fails, and appends nothing, if the value is not valid.
Result<void> append_guide_blob(std::string& out, const DrawingGuide& guide);
Result<void> append_symmetry_blob(std::string& out, const SymmetryGroup& group);
/// Returns the guide or group that these bytes describe. Fails if the version is unknown, the
/// number of bytes is wrong, or the content is not valid.
Result<DrawingGuidePtr> read_guide_blob(std::string_view bytes);
Result<SymmetryPtr> read_symmetry_blob(std::string_view bytes);

/// Creates and fills the tables that the document needs.
Result<void> write_guides(Database& database, const Document& document);
/// Read a table from an untrusted database into an edit that adds its objects. Require that the
/// database has the table. Of more than kMaxDrawingGuides guides, those with the lowest ids are
/// read, and a notice is added to `notices`, unless it is null.
Result<void> read_guides(const Database& database, Edit& edit, std::vector<std::string>* notices);
Result<void> read_symmetries(const Database& database, Edit& edit);
/// Returns the notice about a file with this number of guides, which is more than
/// kMaxDrawingGuides.
std::string too_many_guides(std::size_t count);
/// Returns the checksum that is stored in the row of a guide or of a group, whose `shown` is 0.
std::int64_t guide_checksum(std::int64_t id, std::int64_t shown, std::string_view bytes);

}  // namespace felt
