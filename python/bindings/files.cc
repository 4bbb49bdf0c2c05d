#include <pybind11/stl.h>

#include "bindings.h"
#include "felt/base/atomic_file.h"
#include "felt/base/read_file.h"
#include "felt/document/visible_strokes.h"
#include "felt/formats/drawing_reader.h"
#include "felt/formats/drawing_writer.h"
#include "felt/formats/format_traits.h"
#include "felt/formats/lost_objects.h"
#include "felt/io/drawing_parts.h"
#include "felt/io/ndjson/ndjson_lines.h"
#include "felt/io/ndjson/ndjson_parser.h"
#include "felt/io/ndjson/ndjson_writer.h"
#include "felt/io/quickdraw/quickdraw_line.h"
#include "felt/store/felt_file.h"

namespace felt::python {
namespace {

constexpr double kMarginMm = 5.0;  // around the ink of a drawing without a page, as in the program

ReadDrawing read_result(Result<Imported> result) {
  Imported imported = value_of(std::move(result));
  const auto notices = imported.report.notices();
  return {std::move(imported.drawing),
          {notices.begin(), notices.end()},
          std::string(traits_of(imported.format).name),
          imported.is_exact};
}

ReadOptions read_options(const FitArguments& fit, bool salvage) {
  return {.import = {.fit = options_of(fit)}, .files_only = true, .salvage = salvage};
}

ReadDrawing read(const std::string& path, const FitArguments& fit, bool salvage) {
  const ReadOptions options = read_options(fit, salvage);
  const py::gil_scoped_release release;
  return read_result(read_drawing(path, options));
}

ReadDrawing parse(const std::string& bytes, const std::string& name, const FitArguments& fit,
                  bool salvage) {
  const ReadOptions options = read_options(fit, salvage);
  const py::gil_scoped_release release;
  Result<Imported> result = parse_drawing(bytes, name, options);
  if (!result && !name.empty()) throw FeltError{with_context(result.error(), name)};
  return read_result(std::move(result));
}

/// How a drawing is written; the same choices as `feltline convert`.
struct WriteArguments {
  std::string format;
  double dpi = 300.0;
  bool compact = false;
  bool pictures = false;
};

Result<std::string> file_bytes(const Drawing& drawing, FileFormat format,
                               const WriteArguments& arguments, bool compressed) {
  WriteOptions options;
  options.dpi = arguments.dpi;
  options.compact = arguments.compact;
  options.pictures = arguments.pictures ? PictureChoice::kAll : PictureChoice::kMarked;
  if (traits_of(format).picture && !drawing.has_page) {
    const Rect ink = ink_bounds(drawing.document);
    options.area = format == FileFormat::kSvg
                       ? picture_area(ink, std::nullopt, kMarginMm)
                       : (ink.empty() ? Rect{0.0, 0.0, 0.0, 0.0} : ink).inflated(kMarginMm);
  }
  if (!drawing.has_page && format != FileFormat::kPng) options.paper = Rgba{255, 255, 255, 0};
  if (!compressed) return drawing_bytes(drawing, format, options);
  return drawing_parts(drawing, format, options).and_then([](auto parts) {
    return bytes_of(*gzip_parts(std::move(parts)));
  });
}

FileFormat format_of(const std::string& name) {
  const FileFormat format = value_of(format_of_name(name));
  if (traits_of(format).writes) return format;
  throw py::value_error("format: '" + name + "' cannot be written");
}

void check_options(FileFormat format, const WriteArguments& arguments) {
  if (!(arguments.dpi >= 1.0 && arguments.dpi <= 10'000.0)) {
    throw py::value_error("dpi: must be a number from 1 to 10000");
  }
  if (arguments.compact && format != FileFormat::kSvg) {
    throw py::value_error("compact: is only for svg");
  }
}

py::bytes to_bytes(const ReadDrawing& drawing, const WriteArguments& arguments) {
  const FileFormat format = format_of(arguments.format);
  check_options(format, arguments);
  std::string bytes;
  {
    const py::gil_scoped_release release;
    bytes = value_of(file_bytes(drawing.drawing, format, arguments, false));
  }
  return {bytes};
}

/// Reads the .felt bytes of a pickled drawing, which say nothing about a missing page.
ReadDrawing unpickle(const std::string& bytes, bool has_page) {
  ReadDrawing result{value_of(parse_felt(bytes))};
  result.drawing.has_page = has_page;
  return result;
}

void write(const std::string& path, const ReadDrawing& drawing, const WriteArguments& arguments) {
  const FileFormat format =
      arguments.format.empty() ? value_of(format_of_path(path)) : format_of(arguments.format);
  check_options(format, arguments);
  const py::gil_scoped_release release;
  const bool compressed = format == FileFormat::kSvg && is_compressed_name(path);
  const Result<std::string> bytes = file_bytes(drawing.drawing, format, arguments, compressed);
  if (!bytes) throw FeltError{with_context(bytes.error(), path)};
  check(format == FileFormat::kFelt ? save_file(path, *bytes) : write_file(path, *bytes));
}

/// Returns what a file of this format does not keep of a drawing, as sentences without a subject.
std::vector<std::string> losses(const ReadDrawing& drawing, const std::string& path,
                                const WriteArguments& arguments) {
  const FileFormat format =
      arguments.format.empty() ? value_of(format_of_path(path)) : format_of(arguments.format);
  return loss_texts(lost_objects(drawing.drawing, format, arguments.compact));
}

/// Raw strokes of a file, and a report of the lines that were skipped.
struct RawFile {
  std::vector<RawStroke> strokes;
  ImportReport report;
};

Result<void> add_line(const NdjsonLine& line, NdjsonParser& parser, QuickdrawParser& quickdraw,
                      RawFile& file) {
  const auto name = [&file] { return "s" + std::to_string(file.strokes.size() + 1); };
  if (!looks_like_quickdraw(line.text())) {
    RawStroke stroke;
    const Result<NdjsonKind> kind = parser.raw_stroke(line, stroke);
    if (!kind) return tl::unexpected(kind.error());
    if (*kind == NdjsonKind::kHeader) return {};
    if (stroke.id.empty()) stroke.id = name();
    file.strokes.push_back(std::move(stroke));
    return {};
  }
  QuickdrawRecord record;
  if (Result<void> parsed = quickdraw.parse(line, record); !parsed) return parsed;
  const std::string key = record.key_id.empty() ? name() : record.key_id;
  for (std::size_t i = 0; i < record.strokes.size(); ++i) {
    file.strokes.push_back({key + "." + std::to_string(i + 1), std::move(record.strokes[i])});
  }
  return {};
}

Result<RawFile> raw_strokes(const std::string& path) {
  const Result<std::string> bytes =
      read_regular_file(path, [](std::string_view head, std::uint64_t) {
        return format_of_bytes(head) ? kMaxDrawingBytes : kMaxUnrecognisedBytes;
      });
  if (!bytes) return tl::unexpected(bytes.error());
  constexpr std::size_t kBatchBytes = std::size_t{64} << 10;
  LineReader reader(read_text(*bytes));
  LineBatch batch;
  NdjsonParser parser;
  QuickdrawParser quickdraw;
  RawFile file;
  for (;;) {
    const Result<bool> more = reader.fill(batch, kBatchBytes);
    if (!more) return tl::unexpected(with_context(more.error(), path));
    if (!*more) break;
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const NdjsonLine line = batch.line(i);
      const Result<void> added = add_line(line, parser, quickdraw, file);
      if (!added) file.report.add(line.number(), {}, "was skipped: " + added.error().message);
    }
  }
  if (!file.strokes.empty()) return file;
  const auto notices = file.report.notices();
  const std::string reason = notices.empty() ? "contains no strokes" : notice_text(notices.front());
  return fail(ErrorCode::kInvalidData, path + ": " + reason);
}

py::tuple read_raw(const std::string& path) {
  RawFile file;
  {
    const py::gil_scoped_release release;
    file = value_of(raw_strokes(path));
  }
  const py::object type = py::module_::import("feltline._types").attr("RawStroke");
  py::list strokes, notices;
  for (const RawStroke& stroke : file.strokes) {
    strokes.append(type(stroke.id, array_of(stroke.samples)));
  }
  for (const ImportNotice& notice : file.report.notices()) notices.append(notice_text(notice));
  return py::make_tuple(strokes, notices);
}

void write_raw(const std::string& path, const py::iterable& strokes) {
  std::string text;
  std::size_t number = 0;
  for (const py::handle& stroke : strokes) {
    ++number;
    const bool is_named = py::hasattr(stroke, "points") && py::hasattr(stroke, "id");
    const std::string id =
        is_named ? stroke.attr("id").cast<std::string>() : "s" + std::to_string(number);
    check_name("strokes[" + std::to_string(number - 1) + "].id", id);
    const py::object points =
        is_named ? stroke.attr("points") : py::reinterpret_borrow<py::object>(stroke);
    append_raw_line(text, id,
                    samples_of(points, ("strokes[" + std::to_string(number - 1) + "]").c_str()));
  }
  const py::gil_scoped_release release;
  check(write_file(path, text));
}

py::list formats() {
  const py::object type = py::module_::import("feltline._types").attr("Format");
  py::list rows;
  for (const FormatTraits& traits : format_table()) {
    py::list endings;
    for (const std::string_view ending : traits.endings) endings.append(std::string(ending));
    rows.append(type(std::string(traits.name), std::string(traits.title), py::tuple(endings),
                     traits.reads, traits.writes, traits.layers, traits.lossless));
  }
  return rows;
}

/// Calls a function with the arguments of a fit, which the functions in files.py pass as a tuple.
FitArguments fit_arguments(
    const std::tuple<double, bool, std::string, int, std::optional<std::string>,
                     std::optional<double>, std::optional<double>>& all) {
  return std::apply([](const auto&... each) { return FitArguments{each...}; }, all);
}

}  // namespace

void bind_files(py::module_& module) {
  using Fit = std::tuple<double, bool, std::string, int, std::optional<std::string>,
                         std::optional<double>, std::optional<double>>;
  module.def("read", [](const std::string& path, const Fit& fit, bool salvage) {
    return read(path, fit_arguments(fit), salvage);
  });
  module.def("parse",
             [](const py::bytes& bytes, const std::string& name, const Fit& fit, bool salvage) {
               return parse(static_cast<std::string>(bytes), name, fit_arguments(fit), salvage);
             });
  py::class_<WriteArguments>(module, "WriteArguments")
      .def(py::init([](std::string format, double dpi, bool compact, bool pictures) {
        return WriteArguments{std::move(format), dpi, compact, pictures};
      }));
  require_constructor<WriteArguments>();
  module.def("to_bytes", &to_bytes);
  module.def("unpickle", [](const py::bytes& bytes, bool has_page) {
    return unpickle(static_cast<std::string>(bytes), has_page);
  });
  module.def("write", &write);
  module.def("losses", &losses);
  module.def("read_raw", &read_raw);
  module.def("write_raw", &write_raw);
  module.def("formats", &formats);
}

}  // namespace felt::python
