#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "felt/stroke/fit/ink_fit.h"
#include "felt/stroke/fit/sample_faults.h"

namespace felt {

/// A kind of content that a reader skipped or changed, as a notice for the user (notice_text).
struct ImportNotice {
  std::int64_t line = 0;   ///< line of the first occurrence, from 1; 0 if the format has no lines
  std::string element;     ///< element of the first occurrence: "path 'leaf'", "trace 7"
  std::string what;        ///< how the content was handled; a clause that follows the element
  std::int64_t count = 1;  ///< number of occurrences in this file

  friend bool operator==(const ImportNotice&, const ImportNotice&) = default;
};

/// Notices of one file, in the order in which they first occurred. Notices with the same `what` are
/// counted together. If notices differ only in numbers and quoted names, the first three are kept,
/// and the others are counted in the third. The size is bounded for any file: after kMaxKinds
/// notices, all further ones are counted in one last notice.
class ImportReport {
 public:
  static constexpr std::size_t kMaxKinds = 100;
  static constexpr int kMaxOfAKind = 3;
  static constexpr std::size_t kMaxElementBytes = 200;  ///< longer names are shortened

  void add(std::int64_t line, std::string element, std::string what);
  /// Adds a notice for each fault of the samples of the stroke `id` (fault_clauses()).
  void add_faults(std::int64_t line, const std::string& id, const SampleFaults& faults);
  [[nodiscard]] std::span<const ImportNotice> notices() const noexcept { return notices_; }
  [[nodiscard]] bool empty() const noexcept { return notices_.empty(); }

 private:
  std::vector<ImportNotice> notices_;
  std::vector<std::string> kinds_;  // kind of each notice
};

/// Returns `text` without numbers and without names in single quotes, so that messages of the same
/// kind are equal.
std::string notice_kind(std::string_view text);

/// Returns "line 12: text 'title' is not a stroke and was left out (and 3 more like it)".
std::string notice_text(const ImportNotice& notice);

enum class FileFormat;

/// The result of a reader: the drawing and a report of what was skipped or changed.
struct Imported {
  Drawing drawing;
  ImportReport report;
  FileFormat format{};  ///< detected from the content
  /// True if the drawing is exactly the content of the file, number for number: Feltline wrote it
  /// in a lossless format, and nothing was skipped.
  bool is_exact = false;
};

/// The medium for lines from programs that have no media. Feltline draws it solid, in exactly the
/// colour of the line.
inline constexpr const char* kSolidMedium = "ink-pen";

/// Returns `fit` with kSolidMedium as its medium, unless the caller has chosen a medium other than
/// the default one.
inline InkFitOptions solid_fit(InkFitOptions fit) {
  if (fit.medium == InkFitOptions{}.medium) fit.medium = kSolidMedium;
  return fit;
}

/// Converts the bytes of a picture, for example a JPEG file, to a PNG file. Fails with
/// ErrorCode::kLimitExceeded, before it decodes the picture, if the picture has more than
/// `max_pixels`.
using PictureConverter =
    std::function<Result<std::string>(std::string_view bytes, std::int64_t max_pixels)>;

/// Settings for readers of foreign formats.
struct ImportOptions {
  /// Options for converting pen samples to ink, for formats that hold samples instead of curves.
  InkFitOptions fit{};
  /// The folder of the file. Readers may open pictures below it that the file names. If empty, no
  /// other file is opened.
  std::string folder{};
  /// Converts pictures that are not PNG files. If not set, they are skipped. Called on the thread
  /// of the reader.
  PictureConverter to_png{};
};

}  // namespace felt
