#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/edit.h"
#include "felt/store/database.h"

namespace felt {

class Document;

/// Opacities and pictures of layers. Each table exists only if a layer needs it. An older program
/// that saves the file keeps the rows of the layers that still exist.
inline constexpr std::string_view kLayerLookTable =
    "CREATE TABLE layer_look(id INTEGER PRIMARY KEY, layer INTEGER NOT NULL, "
    "opacity REAL NOT NULL)";
inline constexpr std::string_view kPictureTable =
    "CREATE TABLE picture(id INTEGER PRIMARY KEY, layer INTEGER NOT NULL, a REAL NOT NULL, "
    "b REAL NOT NULL, c REAL NOT NULL, d REAL NOT NULL, e REAL NOT NULL, f REAL NOT NULL, "
    "exported INTEGER NOT NULL, png BLOB NOT NULL, checksum INTEGER NOT NULL)";

/// The values of a row of the table `picture`.
struct PictureRow {
  std::array<double, 6> place{};  ///< a to f
  std::int64_t exported = 0;
  std::shared_ptr<const PictureData> data;  ///< null: not read
  std::int64_t same_as = 0;  ///< the row that has the bytes of the picture; 0: this one
  std::int64_t checksum = 0;
};

/// Returns the picture of a row, or null if a value is invalid, the data are missing, or the
/// checksum does not fit.
LayerPicturePtr picture_of_row(const PictureRow& row);

/// Creates and fills the tables that the document needs.
Result<void> write_layer_looks(Database& database, const Document& document);

/// Reads the table `layer_look` or `picture` of an untrusted database into the layers that an edit
/// adds. Requires that the database has the table. Fails if a value is invalid, or if a layer does
/// not exist or has two rows.
Result<void> read_layer_opacities(const Database& database, Edit& edit);
/// A picture whose bytes are in a missing row is left out, with a notice unless `notices` is null.
Result<void> read_pictures(const Database& database, Edit& edit, std::vector<std::string>* notices);

}  // namespace felt
