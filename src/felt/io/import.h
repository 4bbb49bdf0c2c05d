#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "felt/document/drawing.h"
#include "felt/stroke/fit/ink_fit.h"

namespace felt {

/// One kind of thing that a reader could not take as it was, for people: "line 12: text 'title': is
/// no ink and was left out (and 3 more)".
struct ImportNotice {
  std::int64_t line = 0;   ///< where it was met first, from 1; 0 where the format has no lines
  std::string element;     ///< "path 'leaf'", "trace 7": the first of them
  std::string what;        ///< what became of it, a clause that follows the element
  std::int64_t count = 1;  ///< how often in this file

  friend bool operator==(const ImportNotice&, const ImportNotice&) = default;
};

/// Notices of one file in the order in which they first came. The same `what` is counted together;
/// of those that differ in numbers and quoted names only, the first three are kept.
/// Bounded, whatever the file: beyond kMostKinds all others become one.
class ImportReport {
 public:
  static constexpr std::size_t kMostKinds = 100;
  static constexpr int kMostOfAKind = 3;
  static constexpr std::size_t kMaxElementBytes = 200;  ///< longer names are shortened

  void add(std::int64_t line, std::string element, std::string what);
  [[nodiscard]] std::span<const ImportNotice> notices() const noexcept { return notices_; }
  [[nodiscard]] bool empty() const noexcept { return notices_.empty(); }

 private:
  std::vector<ImportNotice> notices_;
  std::vector<std::string> kinds_;  // of each
};

/// Returns `text` without numbers and names in single quotes: messages of the same kind are equal.
std::string notice_kind(std::string_view text);

/// "line 12: text 'title' is no ink and was left out (and 3 more like it)".
std::string notice_text(const ImportNotice& notice);

enum class FileFormat;

/// What a reader returns: the drawing and a report of what was skipped or changed.
struct Imported {
  Drawing drawing;
  ImportReport report;
  FileFormat format{};  ///< by its content
  /// The drawing is all that the file holds, number for number: Feltline wrote it in a lossless
  /// format, and nothing was skipped.
  bool is_exact = false;
};

/// The medium of lines that come from a program without media: it is shown solid and in exactly the
/// colour of the line.
inline constexpr const char* kSolidMedium = "ink-pen";

/// `fit` with the solid medium, unless the caller chose another than the default.
inline InkFitOptions solid_fit(InkFitOptions fit) {
  if (fit.material == InkFitOptions{}.material) fit.material = kSolidMedium;
  return fit;
}

/// What readers of foreign formats need to know.
struct ImportOptions {
  /// How samples of a pen become ink, where a format holds samples and no curves.
  InkFitOptions fit{};
};

}  // namespace felt
