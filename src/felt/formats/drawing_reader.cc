#include "felt/formats/drawing_reader.h"

#include <sys/stat.h>

#include <utility>

#include "felt/base/read_file.h"
#include "felt/formats/drawing_materials.h"
#include "felt/formats/format_traits.h"
#include "felt/formats/line_drawing.h"
#include "felt/io/inkml/inkml_import.h"
#include "felt/io/quickdraw/quickdraw_import.h"
#include "felt/io/svg/svg_import.h"
#include "felt/io/xopp/xopp_import.h"
#include "felt/store/felt_file.h"
#include "felt/store/felt_salvage.h"

namespace felt {
namespace {

std::string shown(const std::string& path) {
  return path == "-" ? "stdin" : path;
}

/// Reports a file name whose ending does not match the content.
void note_wrong_ending(const std::string& path, FileFormat found, ImportReport& report) {
  const Result<FileFormat> named = format_of_path(path);
  if (!named || *named == found) return;
  report.add(0, "the name",
             "says " + std::string(traits_of(*named).title) + ", but the content is a " +
                 std::string(traits_of(found).title) + " and was read as such");
}

Result<Imported> import_foreign(std::string_view bytes, FileFormat format,
                                const ReadOptions& options) {
  switch (format) {
    case FileFormat::kSvg:
      return import_svg(bytes, options.import);
    case FileFormat::kNdjson:
      if (ndjson_content(bytes.substr(0, kFormatHeadBytes)) == NdjsonContent::kQuickdraw) {
        return import_quickdraw(bytes, options.import);
      }
      return import_lines(bytes, options.import);
    case FileFormat::kXopp:
      return import_xopp(bytes, options.import);
    case FileFormat::kInkml:
      return import_inkml(bytes, options.import);
    case FileFormat::kFelt:
    case FileFormat::kPdf:
    case FileFormat::kPng:
      break;
  }
  return fail(ErrorCode::kUnsupported, "cannot be read this way");
}

/// Reads a .felt file. If it is damaged and `salvage` is set, recovers what is intact.
Result<Imported> read_own(std::string_view bytes, bool salvage) {
  Imported result;
  std::vector<std::string> notices;
  Result<Drawing> drawing = parse_felt(bytes, &notices);
  result.is_exact = drawing.has_value() && notices.empty();
  if (drawing) {
    for (std::string& notice : notices) result.report.add(0, {}, std::move(notice));
    result.drawing = *std::move(drawing);
    return result;
  }
  if (!salvage || drawing.error().code != ErrorCode::kInvalidData) {
    return tl::unexpected(drawing.error());
  }
  Result<Salvaged> salvaged = salvage_felt_bytes(bytes);
  if (!salvaged) return tl::unexpected(salvaged.error());
  if (salvaged->problems.empty()) result.report.add(0, "the file", drawing.error().message);
  for (std::string& problem : salvaged->problems) result.report.add(0, {}, std::move(problem));
  result.drawing = std::move(salvaged->drawing);
  return result;
}

/// Returns true if the first bytes have Feltline's own mark of a lossless format.
bool is_ours(std::string_view bytes, FileFormat format) {
  return traits_of(format).lossless &&
         bytes.substr(0, kFormatHeadBytes).find("feltline") != std::string_view::npos;
}

Result<void> check_kind(const std::string& path, bool files_only) {
  struct stat info {};
  if (path == "-" || ::stat(path.c_str(), &info) != 0) return {};  // reading reports the reason
  if (S_ISDIR(info.st_mode)) return fail(ErrorCode::kUnsupported, path + ": is a folder");
  if (S_ISREG(info.st_mode) || !files_only) return {};
  return fail(ErrorCode::kUnsupported, path + ": not a regular file");
}

}  // namespace

std::string folder_of(const std::string& path) {
  if (path.empty() || path == "-") return {};
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "." : path.substr(0, slash + 1);
}

Result<FileFormat> readable_format(std::string_view head, const std::string& path) {
  std::optional<FileFormat> found = format_of_bytes(head.substr(0, kFormatHeadBytes));
  const Result<FileFormat> named = format_of_path(path);
  // Compressed SVG begins with the same bytes as a compressed .xopp.
  if (found == FileFormat::kXopp && named == FileFormat::kSvg && head[0] == '\x1f') found = *named;
  if (!found && !named) {
    if (head.empty()) return fail(ErrorCode::kInvalidData, "is empty");
    return fail(ErrorCode::kUnsupported,
                "is not a drawing that Feltline can read; it reads " + readable_names());
  }
  const FileFormat format = found ? *found : *named;
  const FormatTraits& traits = traits_of(format);
  if (traits.reads) return format;
  return fail(ErrorCode::kUnsupported, "is a " + std::string(traits.title) +
                                           ", which Feltline can write but not read; it reads " +
                                           readable_names());
}

Result<std::size_t> check_drawing_head(std::string_view head, std::uint64_t size,
                                       const std::string& path, bool salvage) {
  const Result<FileFormat> format = readable_format(head, path);
  if (!format) return tl::unexpected(format.error());
  if (*format == FileFormat::kFelt) {
    return salvage ? check_salvage_head(head, size) : check_felt_head(head, size);
  }
  if (!format_of_bytes(head.substr(0, kFormatHeadBytes))) return kMaxUnrecognisedBytes;
  return kMaxDrawingBytes;
}

Result<Imported> parse_drawing(std::string_view bytes, const std::string& path,
                               const ReadOptions& options) {
  const Result<FileFormat> format = readable_format(bytes, path);
  if (!format) return tl::unexpected(format.error());
  const bool is_own = *format == FileFormat::kFelt;
  if (!is_own && bytes.size() > kMaxDrawingBytes) {
    return fail(ErrorCode::kLimitExceeded, "is larger than 1 GiB");
  }
  Result<Imported> result =
      is_own ? read_own(bytes, options.salvage) : import_foreign(bytes, *format, options);
  if (!result) return result;
  result->format = *format;
  if (!is_own) result->is_exact = result->report.empty() && is_ours(bytes, *format);
  drop_bad_texts(result->drawing.materials, result->report);
  note_wrong_ending(path, *format, result->report);
  return result;
}

Result<Imported> read_drawing(const std::string& path, const ReadOptions& options) {
  if (Result<void> fine = check_kind(path, options.files_only); !fine) {
    return tl::unexpected(fine.error());
  }
  const Result<std::string> bytes = read_file(path, [&](std::string_view head, std::uint64_t size) {
    return check_drawing_head(head, size, path, options.salvage);
  });
  if (!bytes) return tl::unexpected(bytes.error());
  ReadOptions with_folder = options;
  with_folder.import.folder = folder_of(path);
  Result<Imported> drawing = parse_drawing(*bytes, path, with_folder);
  if (drawing) return drawing;
  return tl::unexpected(with_context(drawing.error(), shown(path)));
}

}  // namespace felt
