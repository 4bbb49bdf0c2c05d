#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/document/drawing.h"

namespace felt {

/// Bytes 68 to 71 of every .felt file, big-endian: "Felt".
inline constexpr std::uint32_t kFeltApplicationId = 0x46656c74;
/// Version of the format, bytes 60 to 63. Another one is for what this program would get wrong;
/// what it can leave alone comes without (docs/formats/felt.md, "Newer and older").
inline constexpr std::uint32_t kFeltVersion = 1;
/// Largest file that is read or written.
inline constexpr std::size_t kMaxFeltBytes = std::size_t{2} << 30;

/// Reads a drawing (docs/formats/felt.md), exactly as it was written, ids that were ever taken
/// included. "-" is stdin. The file itself is read once and left alone: no lock, no side file.
/// Recordings, and what a newer Feltline keeps there, are carried and not looked at.
///
/// The bytes are not trusted. Error: it cannot be read, it is no .felt file or one of a newer
/// Feltline, it is cut off or damaged anywhere that matters, a limit is exceeded; the message
/// begins with the path and says what to make of it.
Result<Drawing> read_felt(const std::string& path);

/// Writes a drawing whole or not at all, durably and verified (save_file): a process that is killed
/// at any moment leaves the old file or the new one. Equal drawings give equal bytes. Error: names
/// the path and the reason, and the old file is as it was.
Result<void> write_felt(const std::string& path, const Drawing& drawing);

/// The same, of bytes in memory. Messages do not begin with a path.
Result<Drawing> parse_felt(std::string_view bytes);
Result<std::string> felt_bytes(const Drawing& drawing);

}  // namespace felt
