#pragma once

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/document/edit.h"
#include "felt/store/database.h"

namespace felt {

/// Reads a table with at most one row for each layer into the layers that an edit adds: calls
/// read(row, state) for each row of `select`, whose first column is the id of a layer. Fails if
/// `read` returns false, or if a layer does not exist or has two rows.
template <class Read>
Result<void> for_each_layer_row(const Database& database, const char* select,
                                std::string_view table, Edit& edit, Read read) {
  const auto row = database.prepare(select);
  if (!row) return tl::unexpected(row.error());
  std::set<std::int64_t> seen;
  const auto state_of = [&edit](std::int64_t layer) -> LayerState* {
    const auto found = std::find_if(edit.layers.begin(), edit.layers.end(), [layer](const auto& c) {
      return c.after && static_cast<std::int64_t>(c.id.value) == layer;
    });
    return found == edit.layers.end() ? nullptr : &*found->after;
  };
  for (;;) {
    const Result<bool> more = row->step();
    if (!more) return tl::unexpected(more.error());
    if (!*more) return {};
    LayerState* state = row->is_integer(0) ? state_of(row->integer(0)) : nullptr;
    if (!state || !seen.insert(row->integer(0)).second || !read(*row, *state)) {
      return fail(ErrorCode::kInvalidData,
                  "the table '" + std::string(table) + "' contains an invalid value");
    }
  }
}

}  // namespace felt
