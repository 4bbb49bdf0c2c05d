#pragma once

#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/store/database.h"
#include "felt/store/felt_file.h"
#include "felt/store/felt_schema.h"

namespace felt {

inline constexpr std::int64_t kMaxId = std::int64_t{1} << 53;

/// Returns true if `value` may be the id of a layer or stroke.
constexpr bool is_id(std::int64_t value) noexcept {
  return value > 0 && value <= kMaxId;
}

/// Creates our tables in an empty database, with the additional columns of `like` if it is not
/// null, and fills our columns. Fails if the drawing has something that the format does not allow,
/// for example a page size out of range, a name that is not UTF-8, or a stroke that is too large.
/// The message names the problem.
Result<void> write_tables(Database& database, const Drawing& drawing, const FeltSchema* like);

/// Reads a drawing from an untrusted database whose schema was checked by read_schema(). Does not
/// read extras. Fails if a row is not valid or not consistent with other rows; the message names
/// the row and the reason.
Result<Drawing> read_tables(const Database& database, const FeltSchema& schema,
                            std::vector<std::string>* notices);

}  // namespace felt
