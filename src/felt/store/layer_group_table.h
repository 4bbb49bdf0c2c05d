#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/document/edit.h"
#include "felt/store/database.h"

namespace felt {

class Document;

/// Blend modes of layers, and the groups of layers. Each table exists only if a layer needs it. An
/// older program that saves the file keeps the rows of the layers that still exist. The columns are
/// in an order that salvage cannot mistake for another table.
inline constexpr std::string_view kLayerBlendTable =
    "CREATE TABLE layer_blend(id INTEGER PRIMARY KEY, mode TEXT NOT NULL, layer INTEGER NOT NULL)";
inline constexpr std::string_view kLayerGroupTable =
    "CREATE TABLE layer_group(id INTEGER PRIMARY KEY, layer INTEGER NOT NULL, "
    "number INTEGER NOT NULL, name TEXT NOT NULL, visible INTEGER NOT NULL, "
    "locked INTEGER NOT NULL, opacity REAL NOT NULL, mode TEXT NOT NULL)";

/// Returns the group of a row of the table `layer_group`, or null if a value is invalid.
LayerGroupPtr group_of_row(std::int64_t number, std::string name, std::int64_t visible,
                           std::int64_t locked, double opacity, std::string_view mode);

/// Create and fill these tables if the document needs them.
Result<void> write_layer_blends(Database& database, const Document& document);
Result<void> write_layer_groups(Database& database, const Document& document);

/// Read the tables of an untrusted database into the layers that an edit adds. Require that the
/// database has the table. Fail if a value is invalid, if a blend mode is unknown, or if a layer
/// does not exist or has two rows. If an older program has moved layers, a group becomes several
/// ones.
Result<void> read_layer_blends(const Database& database, Edit& edit);
Result<void> read_layer_groups(const Database& database, Edit& edit);

/// Makes the groups of the layers that an edit adds valid (separate_groups).
void separate_groups_of(Edit& edit);

}  // namespace felt
