#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/document/document.h"
#include "felt/store/database.h"

namespace felt {

/// The edits of the body of a drawing. The table exists only if the drawing has such edits. An
/// older program that saves the file keeps it. The columns are in an order that salvage cannot
/// mistake for another table.
inline constexpr std::string_view kBodyEditTable =
    "CREATE TABLE body_edit(id INTEGER PRIMARY KEY, kind TEXT NOT NULL, shape BLOB NOT NULL, "
    "checksum INTEGER NOT NULL)";

/// Largest size of the bytes of an edit of the body.
inline constexpr std::size_t kMaxBodyEditBytes =
    100 + 2 * BodyEdit::kMaxPoints * 3 * sizeof(double);

/// Appends an edit of the body without its kind as bytes, without loss (docs/formats/felt.md).
/// Equal values give equal bytes. Fails, and appends nothing, if check_body_edit() refuses it.
Result<void> append_body_edit_blob(std::string& out, const BodyEdit& edit);
/// Returns the edit of this kind that these bytes describe. Fails if the kind or the version is
/// unknown, the number of bytes is wrong, or the content is not valid.
Result<BodyEditPtr> read_body_edit_blob(std::string_view kind, std::string_view bytes);
/// Returns the checksum that is stored in the row of an edit.
std::int64_t body_edit_checksum(std::int64_t id, std::string_view kind, std::string_view bytes);

/// Creates and fills the table if the document needs it.
Result<void> write_body_edits(Database& database, const Document& document);
/// Reads the table of an untrusted database into an edit that adds its objects. Requires that the
/// database has the table. Fails if a value is invalid.
Result<void> read_body_edits(const Database& database, Edit& edit);

}  // namespace felt
