#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/io/ndjson/ndjson_lines.h"
#include "felt/stroke/fit/ink_fit.h"

namespace felt {

/// One drawing of the Quick, Draw! data set: a line of its files.
struct QuickdrawRecord {
  std::string word;    ///< the word to be drawn; may be empty
  std::string key_id;  ///< may be empty
  /// Samples of each stroke, in the unit of the file; only the raw variant has times. Never empty.
  std::vector<std::vector<InkSample>> strokes;

  friend bool operator==(const QuickdrawRecord&, const QuickdrawRecord&) = default;
};

/// Returns true if a line of JSON looks like such a drawing: it has a key "drawing" and neither
/// "points" nor "segments". This is a quick test; QuickdrawParser decides.
bool looks_like_quickdraw(std::string_view line) noexcept;

/// The error message for such a line in a file that was not recognised as a Quick, Draw! file by
/// its first bytes.
inline constexpr const char* kUnknownQuickdraw =
    "is a drawing of Quick, Draw!, but this could not be detected from the first 4096 bytes of the "
    "file";

/// Adds points to a stroke of a simplified drawing, in which only the ends of straight lines are
/// stored. The points lie on these lines and are dense near their ends, so that the fitted curve
/// follows the lines. Without the added points, the curve would only have to pass near a few points
/// that are far apart. Strokes that have times, values outside 0..255 or more than
/// kMaxSimplifiedPoints points are not from simplified drawings and are not changed.
void restore_simplified(std::vector<InkSample>& stroke);
inline constexpr std::size_t kMaxSimplifiedPoints = 1000;

/// Converts a line to a drawing. It is as strict as NdjsonParser and has the same bounds. Not
/// thread-safe.
class QuickdrawParser {
 public:
  QuickdrawParser();
  ~QuickdrawParser();
  QuickdrawParser(QuickdrawParser&&) noexcept;
  QuickdrawParser& operator=(QuickdrawParser&&) noexcept;

  /// Reads {"word":..,"key_id":..,"drawing":[[[x,..],[y,..],[t,..]?],..]}; other keys must be JSON
  /// and are ignored. Replaces the content of `out`, which is unspecified after an error. The error
  /// names the key and the element.
  Result<void> parse(const NdjsonLine& line, QuickdrawRecord& out);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace felt
