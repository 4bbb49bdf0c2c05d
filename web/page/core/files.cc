#include "web/page/core/files.h"

#include <cstdio>
#include <utility>

#include "felt/formats/drawing_materials.h"
#include "felt/formats/file_format.h"
#include "felt/io/svg/svg_writer.h"
#include "felt/session/session_medium.h"
#include "felt/stroke/color_text.h"

namespace felt::page {
namespace {

/// Begins the text for an empty drawing, which the first module writes, too.
constexpr std::string_view kEmptyMark = "feltline-empty-page ";

/// Returns a drawing without ink as text: the width and height of its page, its paper and its
/// surface.
std::string empty_text(const Page& page) {
  return std::string(kEmptyMark) + std::to_string(page.width_mm) + ' ' +
         std::to_string(page.height_mm) + ' ' + color_to_text(page.paper) + ' ' + page.surface;
}

std::string next_word(std::string_view& rest) {
  const std::size_t end = std::min(rest.find(' '), rest.size());
  std::string word(rest.substr(0, end));
  rest.remove_prefix(std::min(end + 1, rest.size()));
  return word;
}

Drawing empty_drawing(std::string_view text) {
  text.remove_prefix(kEmptyMark.size());
  Drawing drawing;
  const double width = std::strtod(next_word(text).c_str(), nullptr);
  const double height = std::strtod(next_word(text).c_str(), nullptr);
  if (width >= Page::kMinMm && width <= Page::kMaxMm) drawing.page.width_mm = width;
  if (height >= Page::kMinMm && height <= Page::kMaxMm) drawing.page.height_mm = height;
  drawing.page.paper = color_from_text(next_word(text)).value_or(drawing.page.paper);
  drawing.page.surface = text;
  return drawing;
}

bool is_empty(const Drawing& drawing) {
  return drawing.document == Document() && drawing.materials.empty() &&
         drawing.palette == Palette{} && !drawing.extras;
}

Page page_of(const Studio& studio) {
  Page page = studio.page();
  page.surface = studio.session().surface().id;
  return page;
}

}  // namespace

Result<Imported> read_drawing(std::string_view bytes, const std::string& name) {
  std::optional<FileFormat> format = format_of_bytes(bytes.substr(0, kFormatHeadBytes));
  if (!format) {
    const Result<FileFormat> named = format_of_path(name);
    if (named) format = *named;
  }
  if (!format) return fail(ErrorCode::kUnsupported, "is not a drawing that the page can read");
  Result<Imported> read = import_as(*format, bytes);
  if (read) drop_bad_texts(read->drawing.materials, read->report);
  return read;
}

Drawing drawing_of(const Studio& studio) {
  const Session& session = studio.session();
  Drawing drawing;
  drawing.document = session.document();
  drawing.page = page_of(studio);
  drawing.color = session.ink_color();
  drawing.layer = session.layer();
  const Studio::Carried& carried = studio.carried();
  drawing.palette = carried.palette;
  drawing.view = carried.view;
  drawing.extras = carried.extras;
  drawing.names = carried.names;
  drawing.materials = texts_of_used(drawing.document, drawing.page.surface, session.materials(),
                                    std::vector<std::string>{drawing_medium(session)});
  return drawing;
}

Result<std::string> write_drawing(const Drawing& drawing, std::string_view format) {
  if (format == "svg") return svg_text(drawing, {.paper = drawing.page.paper});
  if (format == "inkml") return inkml_of(drawing);
  if (format == "felt") return felt_of(drawing);
  if (format == "ndjson") return lines_of(drawing);
  return fail(ErrorCode::kUnsupported, "the page cannot write this format");
}

std::string base_of(const Studio& studio) {
  if (!is_full_module()) return empty_text(page_of(studio));
  const Drawing drawing = drawing_of(studio);
  if (is_empty(drawing)) return empty_text(drawing.page);
  Result<std::string> felt = felt_of(drawing);
  if (felt) return *std::move(felt);
  const SvgOptions options{.paper = drawing.page.paper, .pictures = PictureChoice::kAll};
  return svg_text(drawing, options).value_or(std::string());
}

Result<Drawing> drawing_of_base(std::string_view base) {
  if (base.starts_with(kEmptyMark)) return empty_drawing(base);
  Result<Imported> read = read_drawing(base, "base");
  if (!read) return tl::unexpected(read.error());
  return std::move(read->drawing);
}

}  // namespace felt::page
