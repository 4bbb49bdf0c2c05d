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
  std::string word;    ///< what was to be drawn; may be empty
  std::string key_id;  ///< may be empty
  /// Samples of each stroke, in the unit of the file; times in the raw variant only. Never empty.
  std::vector<std::vector<InkSample>> strokes;

  friend bool operator==(const QuickdrawRecord&, const QuickdrawRecord&) = default;
};

/// True when a line of JSON looks like such a drawing: it has a key "drawing" and neither "points"
/// nor "segments". Cheap; QuickdrawParser decides.
bool looks_like_quickdraw(std::string_view line) noexcept;

/// The error for such a line in a file whose start did not show that it holds them.
inline constexpr const char* kUnknownQuickdraw =
    "is a drawing of Quick, Draw!, but the first 4096 bytes of the file do not show it";

/// Puts back what the simplified variant left out of a stroke: only the points that its lines need
/// were kept. Points on these lines, dense near their ends, show the fit the lines instead of a few
/// points far apart. Strokes with times, outside of 0..255 or of more than kMaxSimplifiedPoints are
/// no such strokes and stay as they are.
void restore_simplified(std::vector<InkSample>& stroke);
inline constexpr std::size_t kMaxSimplifiedPoints = 1000;

/// Turns a line into a drawing. As strict and as bounded as NdjsonParser. One thread at a time.
class QuickdrawParser {
 public:
  QuickdrawParser();
  ~QuickdrawParser();
  QuickdrawParser(QuickdrawParser&&) noexcept;
  QuickdrawParser& operator=(QuickdrawParser&&) noexcept;

  /// {"word":..,"key_id":..,"drawing":[[[x,..],[y,..],[t,..]?],..]}; other keys are checked to be
  /// JSON and ignored. Replaces the content of `out`, which is undefined after an error. The error
  /// names the key and the element.
  Result<void> parse(const NdjsonLine& line, QuickdrawRecord& out);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace felt
