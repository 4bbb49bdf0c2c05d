#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "felt/base/id.h"
#include "felt/base/result.h"
#include "felt/document/document.h"
#include "felt/document/sheet_page.h"
#include "felt/io/gpl_palette.h"
#include "felt/store/felt_extras.h"

namespace felt {

/// Bytes 68 to 71 of every .felt file, big-endian: "Felt".
inline constexpr std::uint32_t kFeltApplicationId = 0x46656c74;
/// Version of the format, bytes 60 to 63. Another one is for what this program would get wrong;
/// what it can leave alone comes without (docs/formats/felt.md, "Newer and older").
inline constexpr std::uint32_t kFeltVersion = 1;
/// Largest file that is read or written.
inline constexpr std::size_t kMaxFeltBytes = std::size_t{2} << 30;

/// What the window showed. No part of the drawing: changing it is nothing to save.
struct StoredView {
  static constexpr double kMostMm = 1e6;  ///< of the sheet's origin, in x and in y
  static constexpr double kLeastPxPerMm = 1e-4;
  static constexpr double kMostPxPerMm = 1e5;

  Point center;            ///< mm, in the middle of the window
  double px_per_mm = 4.0;  ///< device-independent pixels
  double angle_deg = 0.0;  ///< clockwise as seen, -180..180; the sheet is mirrored first
  bool mirrored = false;
  friend bool operator==(const StoredView&, const StoredView&) = default;
};

/// All that a .felt file holds: the drawing as it is now. Undo and selection are not part of it.
struct StoredDrawing {
  Document document;
  SheetPage page;
  Rgba color{};                      ///< of new ink
  LayerId layer{};                   ///< in use; none where none was chosen
  GplPalette palette{};              ///< the drawing's own colours; within GplLimits
  std::optional<StoredView> view{};  ///< none where it was never seen
  /// Texts of the materials that it uses and that Feltline does not bring, at most
  /// limits::kMaxMaterialTexts of is_material_text().
  std::vector<std::string> materials{};
  FeltExtras extras{};

  friend bool operator==(const StoredDrawing&, const StoredDrawing&) = default;
};

/// Reads a drawing (docs/formats/felt.md), exactly as it was written, ids that were ever taken
/// included. "-" is stdin. The file itself is read once and left alone: no lock, no side file.
/// Recordings, and what a newer Feltline keeps there, are carried and not looked at.
///
/// The bytes are not trusted. Error: it cannot be read, it is no .felt file or one of a newer
/// Feltline, it is cut off or damaged anywhere that matters, a limit is exceeded; the message
/// begins with the path and says what to make of it.
Result<StoredDrawing> read_felt(const std::string& path);

/// Writes a drawing whole or not at all, durably and verified (save_file): a process that is killed
/// at any moment leaves the old file or the new one. Equal drawings give equal bytes. Error: names
/// the path and the reason, and the old file is as it was.
Result<void> write_felt(const std::string& path, const StoredDrawing& drawing);

/// The same, of bytes in memory. Messages do not begin with a path.
Result<StoredDrawing> parse_felt(std::string_view bytes);
Result<std::string> felt_bytes(const StoredDrawing& drawing);

}  // namespace felt
