#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/store/felt_file.h"

namespace felt {

/// What could be had of a damaged file.
struct Salvaged {
  Drawing drawing;
  /// What is missing or not sure, for people, each a sentence; none where the file was whole.
  std::vector<std::string> problems;
};

/// Reads a .felt file that read_felt() refuses, page by page and without SQLite: every stroke whose
/// pages are there is in it, told by its checksum, in its layer and order where these are known
/// and in a layer of its own else. Recordings, and what a newer Feltline keeps, are left behind.
/// The file itself is left alone. A whole file comes back as it is.
///
/// Error: it cannot be read, or nothing of a drawing is in it; the message begins with the path.
Result<Salvaged> salvage_felt(const std::string& path);
/// The same, of bytes in memory.
Result<Salvaged> salvage_felt_bytes(std::string_view bytes);

}  // namespace felt
