#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/store/felt_file.h"

namespace felt {

/// Maximum size in bytes of a file that is salvaged although its first bytes are damaged, too. It
/// is in memory as a whole.
inline constexpr std::size_t kMaxSalvageBytes = std::size_t{512} << 20;

/// Checks the first bytes of a file (HeadCheck). Returns kMaxFeltBytes if they are intact, and
/// otherwise kMaxSalvageBytes.
inline Result<std::size_t> check_salvage_head(std::string_view head, std::uint64_t size) {
  return check_felt_head(head, size).value_or(kMaxSalvageBytes);
}

/// The result of the recovery of a damaged file.
struct Salvaged {
  Drawing drawing;
  /// One sentence for each part that is missing or uncertain, shown to the user. Empty if the file
  /// was intact.
  std::vector<std::string> problems;
};

/// Reads a .felt file that read_felt() refuses, page by page and without SQLite. Recovers every
/// stroke whose pages are intact; a correct checksum shows that a stroke is intact. A stroke keeps
/// its layer and order if these are known. Otherwise it is put into a separate layer. Layers keep
/// their opacities, blend modes, groups and pictures. Recordings, and content of a newer Feltline,
/// are not recovered. The file is only read. If the file is intact, the result is the same as that
/// of read_felt().
///
/// Fails if the file cannot be read or is larger than check_salvage_head() allows, or if no part of
/// a drawing is found; the message begins with the path.
Result<Salvaged> salvage_felt(const std::string& path);
/// Does the same with bytes in memory.
Result<Salvaged> salvage_felt_bytes(std::string_view bytes);

}  // namespace felt
