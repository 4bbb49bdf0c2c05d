#pragma once

#include "felt/base/result.h"
#include "felt/store/database.h"
#include "felt/store/felt_file.h"
#include "felt/store/felt_schema.h"

namespace felt {

inline constexpr std::size_t kMaxLayers = 10'000;
/// Of a layer or material, in bytes of UTF-8.
inline constexpr std::size_t kMaxLayerNameBytes = 4096;
inline constexpr std::int64_t kMaxId = std::int64_t{1} << 53;

/// True for what may be the number of a layer or stroke.
constexpr bool is_id(std::int64_t value) noexcept {
  return value > 0 && value <= kMaxId;
}

/// Makes our tables in an empty database, with the columns of `like` if any, and fills ours. Error:
/// something that no file may hold (a page out of its range, a name that is not UTF-8, a stroke
/// that is too large), by its name.
Result<void> write_tables(Database& database, const Drawing& drawing, const FeltSchema* like);

/// The other way round, from a database that is not trusted, whose schema (read_schema) is ours:
/// every row must make sense with the others. Extras are not read. Error: names the row and the
/// reason.
Result<Drawing> read_tables(const Database& database, const FeltSchema& schema);

}  // namespace felt
