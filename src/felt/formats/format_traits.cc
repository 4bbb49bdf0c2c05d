#include "felt/formats/format_traits.h"

#include <algorithm>
#include <array>

#include "felt/base/ascii.h"
#include "felt/base/check.h"

namespace felt {
namespace {

using Texts = std::string_view;

constexpr Texts kFeltEndings[] = {".felt"};
constexpr Texts kFeltTypes[] = {"application/x-feltline"};
constexpr Texts kSvgEndings[] = {".svg", ".svgz"};
constexpr Texts kSvgTypes[] = {"image/svg+xml", "image/svg+xml-compressed"};
constexpr Texts kInkmlEndings[] = {".inkml"};
constexpr Texts kInkmlTypes[] = {"application/inkml+xml"};
constexpr Texts kXoppEndings[] = {".xopp"};
constexpr Texts kXoppTypes[] = {"application/x-xopp"};
constexpr Texts kNdjsonEndings[] = {".ndjson", ".jsonl"};
constexpr Texts kNdjsonTypes[] = {"application/x-ndjson"};
constexpr Texts kPdfEndings[] = {".pdf"};
constexpr Texts kPdfTypes[] = {"application/pdf"};
constexpr Texts kPngEndings[] = {".png"};
constexpr Texts kPngTypes[] = {"image/png"};

constexpr std::array kTable = {
    FormatTraits{.format = FileFormat::kFelt,
                 .name = "felt",
                 .title = "Feltline drawing",
                 .endings = kFeltEndings,
                 .media_types = kFeltTypes,
                 .reads = true,
                 .writes = true,
                 .layers = true,
                 .page = true,
                 .lossless = true,
                 .widths = "exact",
                 .kept = "Everything, exactly."},
    FormatTraits{.format = FileFormat::kSvg,
                 .name = "svg",
                 .title = "SVG drawing",
                 .endings = kSvgEndings,
                 .media_types = kSvgTypes,
                 .reads = true,
                 .writes = true,
                 .layers = true,
                 .page = true,
                 .lossless = true,
                 .picture = true,
                 .widths = "exact",
                 .taken = "centre lines of shapes and paths, PowerStroke widths, fills",
                 .kept = "The picture, for browsers, Inkscape and all that show SVG; Feltline "
                         "reads lines, layers and page back exactly."},
    FormatTraits{.format = FileFormat::kInkml,
                 .name = "inkml",
                 .title = "InkML ink",
                 .endings = kInkmlEndings,
                 .media_types = kInkmlTypes,
                 .reads = true,
                 .writes = true,
                 .layers = true,
                 .page = true,
                 .lossless = true,
                 .widths = "exact",
                 .taken = "ink of any device and of Office: X, Y, F, T, OTx, OTy, W",
                 .kept = "Lines with their widths, for programs that read InkML; Feltline reads "
                         "lines, layers and page back exactly."},
    FormatTraits{.format = FileFormat::kXopp,
                 .name = "xopp",
                 .title = "Xournal++ notes",
                 .endings = kXoppEndings,
                 .media_types = kXoppTypes,
                 .reads = true,
                 .writes = true,
                 .layers = true,
                 .page = true,
                 .widths = "sampled along the line",
                 .taken = "strokes of pen and highlighter, of all pages below each other",
                 .kept = "Lines with their widths, in layers, for notes in Xournal++; curves "
                         "become many short lines."},
    FormatTraits{
        .format = FileFormat::kNdjson,
        .name = "ndjson",
        .title = "Strokes as lines of JSON",
        .endings = kNdjsonEndings,
        .media_types = kNdjsonTypes,
        .reads = true,
        .writes = true,
        .widths = "exact",
        .taken = "raw pen samples, which become ink; drawings of Quick, Draw!",
        .kept =
            "Every visible line, exactly, for programs and scripts; no layers, page or surface."},
    FormatTraits{.format = FileFormat::kPdf,
                 .name = "pdf",
                 .title = "PDF page",
                 .endings = kPdfEndings,
                 .media_types = kPdfTypes,
                 .writes = true,
                 .page = true,
                 .picture = true,
                 .widths = "drawn",
                 .kept = "A page to read and print, sharp at any size; it cannot be opened again."},
    FormatTraits{.format = FileFormat::kPng,
                 .name = "png",
                 .title = "PNG picture",
                 .endings = kPngEndings,
                 .media_types = kPngTypes,
                 .writes = true,
                 .picture = true,
                 .widths = "drawn",
                 .kept = "A picture of pixels at the resolution you choose; it cannot be opened "
                         "again."}};

bool same_word(std::string_view a, std::string_view b) noexcept {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return ascii_lower(x) == ascii_lower(y); });
}

/// Returns the names of the formats for which `does` is true: "a, b or c".
std::string names(bool FormatTraits::*does) {
  std::string text;
  const auto wanted = std::count_if(kTable.begin(), kTable.end(),
                                    [does](const FormatTraits& t) { return t.*does; });
  std::ptrdiff_t number = 0;
  for (const FormatTraits& row : kTable) {
    if (!(row.*does)) continue;
    if (number > 0)
      text += ++number == wanted ? " or " : ", ";
    else
      ++number;
    text += row.name;
  }
  return text;
}

}  // namespace

std::span<const FormatTraits> format_table() noexcept {
  return kTable;
}

const FormatTraits& traits_of(FileFormat format) noexcept {
  const auto* row = std::find_if(kTable.begin(), kTable.end(),
                                 [format](const FormatTraits& t) { return t.format == format; });
  FELT_CHECK(row != kTable.end());
  return *row;
}

Result<FileFormat> format_of_name(std::string_view name) {
  const std::string_view bare = !name.empty() && name[0] == '.' ? name.substr(1) : name;
  for (const FormatTraits& row : kTable) {
    for (const std::string_view ending : row.endings) {
      if (same_word(bare, ending.substr(1))) return row.format;
    }
  }
  return fail(ErrorCode::kUnsupported,
              "'" + std::string(name) + "' is not a format; the formats are " + writable_names());
}

std::string readable_names() {
  return names(&FormatTraits::reads);
}

std::string writable_names() {
  return names(&FormatTraits::writes);
}

std::string format_table_markdown() {
  const auto yes = [](bool is) { return is ? "yes" : "no"; };
  std::string text =
      "| format | endings | read | written | layers | page | widths | comes back exactly |\n"
      "|---|---|---|---|---|---|---|---|\n";
  for (const FormatTraits& row : kTable) {
    text += "| " + std::string(row.title) + " |";
    for (const std::string_view ending : row.endings) text += " `" + std::string(ending) + "`";
    text += std::string(" | ") + yes(row.reads) + " | " + yes(row.writes) + " | " +
            yes(row.layers) + " | " + yes(row.page) + " | " + std::string(row.widths) + " | " +
            yes(row.lossless) + " |\n";
  }
  return text;
}

}  // namespace felt
