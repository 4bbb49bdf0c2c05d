#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/drawing.h"

namespace felt {

/// Bytes 68 to 71 of every .felt file, big-endian: "Felt".
inline constexpr std::uint32_t kFeltApplicationId = 0x46656c74;
/// Version of the format, bytes 60 to 63. It changes only if older programs would read a file
/// wrongly. Content that older programs can ignore is added without a new version
/// (docs/formats/felt.md, "Newer and older").
inline constexpr std::uint32_t kFeltVersion = 1;
/// Maximum size in bytes of a file that is read or written.
inline constexpr std::size_t kMaxFeltBytes = std::size_t{2} << 30;

/// Checks the first bytes of a file (HeadCheck), so that other files are refused before they are
/// read. Returns kMaxFeltBytes.
Result<std::size_t> check_felt_head(std::string_view head, std::uint64_t size);

/// Reads a drawing (docs/formats/felt.md) exactly as it was written, including the highest ids that
/// were ever used. The path "-" is stdin. Reads the file once, takes no lock, and creates no file
/// beside it. Recordings and content of a newer Feltline are kept as extras and not parsed.
///
/// The bytes are not trusted. Fails if the file cannot be read, is not a .felt file, has a newer
/// version of the format, is truncated or damaged in a part that the drawing needs, or exceeds a
/// limit; so does a path of a pipe or a device. The message begins with the path and says what to
/// do.
Result<Drawing> read_felt(const std::string& path);

/// Writes a drawing completely or not at all, durably and verified (save_file): if the process is
/// killed, either the old file or the new file remains. Equal drawings give equal bytes. If it
/// fails, the old file is unchanged, and the message names the path and the reason.
Result<void> write_felt(const std::string& path, const Drawing& drawing);

/// Do the same with bytes in memory. Messages do not begin with a path. If `notices` is not null, a
/// notice for the user is added for content that a drawing cannot have, and was left out.
Result<Drawing> parse_felt(std::string_view bytes, std::vector<std::string>* notices = nullptr);
Result<std::string> felt_bytes(const Drawing& drawing);

}  // namespace felt
