#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "felt/base/id.h"
#include "felt/base/result.h"
#include "felt/document/document.h"
#include "felt/document/sheet_page.h"

namespace felt {

/// Bytes 68 to 71 of every .felt file, big-endian: "Felt".
inline constexpr std::uint32_t kFeltApplicationId = 0x46656c74;
/// Version of the format, bytes 60 to 63.
inline constexpr std::uint32_t kFeltVersion = 1;
/// Largest file that is read.
inline constexpr std::size_t kMaxFeltBytes = std::size_t{2} << 30;

/// All that a .felt file holds: the drawing as it is now. Undo and selection are not part of it.
struct StoredDrawing {
  Document document;
  SheetPage page;
  std::string material;  ///< of the sheet, by id; "" where none was chosen
  Rgba color{};          ///< of new ink
  LayerId layer{};       ///< in use; none where none was chosen

  friend bool operator==(const StoredDrawing&, const StoredDrawing&) = default;
};

/// Reads a drawing (docs/formats/felt.md), exactly as it was written, ids that were ever taken
/// included. "-" is stdin. The file itself is read once and left alone: no lock, no side file.
///
/// The bytes are not trusted. Error: it cannot be read, it is no .felt file or one of a newer
/// Feltline, it is cut off or damaged anywhere that matters, a limit is exceeded; the message
/// begins with the path and says what to make of it.
Result<StoredDrawing> read_felt(const std::string& path);

/// Writes a drawing whole or not at all, and durably (AtomicFile): a process that is killed at any
/// moment leaves the old file or the new one. Equal drawings give equal bytes. Error: names the
/// path and the reason, and the old file is as it was.
Result<void> write_felt(const std::string& path, const StoredDrawing& drawing);

/// The same, of bytes in memory. Messages do not begin with a path.
Result<StoredDrawing> parse_felt(std::string_view bytes);
Result<std::string> felt_bytes(const StoredDrawing& drawing);

}  // namespace felt
