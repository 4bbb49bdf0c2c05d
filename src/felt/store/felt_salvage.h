#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/store/felt_file.h"

namespace felt {

/// What was recovered from a damaged file.
struct Salvaged {
  Drawing drawing;
  /// What is missing or uncertain: one sentence each, shown to the user. Empty if the file was
  /// intact.
  std::vector<std::string> problems;
};

/// Reads a .felt file that read_felt() refuses, page by page and without SQLite. Recovers every
/// stroke whose pages are intact, recognised by its checksum. A stroke is in its layer and order if
/// these are known, else in a separate layer. Recordings, and content of a newer Feltline, are not
/// recovered. The file is only read. An intact file is read as read_felt() does.
///
/// Fails if the file cannot be read or contains nothing of a drawing; the message begins with the
/// path.
Result<Salvaged> salvage_felt(const std::string& path);
/// The same, for bytes in memory.
Result<Salvaged> salvage_felt_bytes(std::string_view bytes);

}  // namespace felt
