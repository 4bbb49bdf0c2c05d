#include "felt/formats/drawing_writer.h"

#include <functional>
#include <utility>

#include "felt/base/atomic_file.h"
#include "felt/base/check.h"
#include "felt/formats/drawing_materials.h"
#include "felt/formats/line_drawing.h"
#include "felt/formats/plain_edit.h"
#include "felt/io/inkml/inkml_writer.h"
#include "felt/io/picture/pdf_writer.h"
#include "felt/io/picture/png.h"
#include "felt/io/svg/svg_compact.h"
#include "felt/io/svg/svg_writer.h"
#include "felt/io/xopp/xopp_writer.h"
#include "felt/render/page_painter.h"
#include "felt/store/felt_file.h"

namespace felt {
namespace {

Result<std::string> png_bytes(const Drawing& drawing, const WriteOptions& options) {
  PageOptions options_of_page;
  options_of_page.dpi = options.dpi;
  options_of_page.area = options.area.value_or(drawing.page.area());
  options_of_page.paper = options.paper.value_or(drawing.page.paper);
  options_of_page.grain = options.grain.is_plain() && !drawing.materials.empty()
                              ? Grain::solid(with_texts(drawing.materials))
                              : options.grain;
  Result<PagePainter> page = PagePainter::create({}, options_of_page);
  if (!page) return tl::unexpected(page.error());
  if (auto ok = page->draw(drawing.document, options.pictures); !ok) {
    return tl::unexpected(ok.error());
  }
  return encode_png(page->image(), options.dpi);
}

/// A file that is made as a whole.
class WholeFile final : public DrawingParts {
 public:
  using Bytes = std::function<Result<std::string>()>;
  explicit WholeFile(Bytes bytes) : bytes_(std::move(bytes)) {}

  [[nodiscard]] std::size_t count() const override { return 1; }
  Result<void> make(std::size_t, DrawingPart& out) const override {
    out.clear();
    Result<std::string> bytes = bytes_();
    if (!bytes) return tl::unexpected(bytes.error());
    out.bytes = *std::move(bytes);
    return {};
  }

 private:
  Bytes bytes_;
};

std::unique_ptr<DrawingParts> whole(WholeFile::Bytes bytes) {
  return std::make_unique<WholeFile>(std::move(bytes));
}

/// Same as drawing_parts(), for a drawing whose strokes the format can hold.
Result<std::unique_ptr<DrawingParts>> parts_as_they_are(const Drawing& drawing, FileFormat format,
                                                        const WriteOptions& options);

/// Parts of a drawing that it owns.
class PartsOfCopy final : public DrawingParts {
 public:
  explicit PartsOfCopy(Drawing drawing) : drawing_(std::move(drawing)) {}
  Result<void> begin(FileFormat format, const WriteOptions& options) {
    auto parts = parts_as_they_are(drawing_, format, options);
    if (!parts) return tl::unexpected(parts.error());
    parts_ = *std::move(parts);
    return {};
  }

  [[nodiscard]] std::size_t count() const override { return parts_->count(); }
  Result<void> make(std::size_t i, DrawingPart& out) const override { return parts_->make(i, out); }
  [[nodiscard]] bool any_order() const override { return parts_->any_order(); }
  void add(const DrawingPart& part) override { parts_->add(part); }
  std::string tail() override { return parts_->tail(); }

 private:
  Drawing drawing_;
  std::unique_ptr<DrawingParts> parts_;
};

Result<std::unique_ptr<DrawingParts>> parts_as_they_are(const Drawing& drawing, FileFormat format,
                                                        const WriteOptions& options) {
  const Rect area = options.area.value_or(drawing.page.area());
  const Rgba paper = options.paper.value_or(drawing.page.paper);
  switch (format) {
    case FileFormat::kFelt:
      return whole([&drawing] { return felt_bytes(drawing); });
    case FileFormat::kNdjson:
      return line_parts(drawing);
    case FileFormat::kSvg:
      if (options.compact) {
        return whole([&drawing, area = options.area, paper] {
          return svg_compact_text(drawing, {.area = area, .paper = paper});
        });
      }
      return svg_parts(drawing, {.area = options.area,
                                 .paper = paper,
                                 .grain = options.grain_print,
                                 .pictures = options.pictures});
    case FileFormat::kPdf:
      return pdf_parts(drawing, {.area = area,
                                 .paper = paper,
                                 .grain = options.grain_print,
                                 .pictures = options.pictures});
    case FileFormat::kPng:
      return whole([&drawing, options] { return png_bytes(drawing, options); });
    case FileFormat::kInkml:
      return inkml_parts(drawing, options.paper);
    case FileFormat::kXopp:
      return xopp_parts(drawing, options.paper);
  }
  return fail(ErrorCode::kInvalidArgument, "unknown format");
}

}  // namespace

Result<std::unique_ptr<DrawingParts>> drawing_parts(const Drawing& drawing, FileFormat format,
                                                    const WriteOptions& options) {
  const Edit edit = plain_edit(drawing.document, format);
  if (edit.layers.empty() && edit.changes.empty()) {
    return parts_as_they_are(drawing, format, options);
  }
  Drawing plain = drawing;
  FELT_CHECK(plain.document.apply(edit).has_value());
  auto parts = std::make_unique<PartsOfCopy>(std::move(plain));
  return parts->begin(format, options).map([&]() -> std::unique_ptr<DrawingParts> {
    return std::move(parts);
  });
}

Result<std::string> drawing_bytes(const Drawing& drawing, FileFormat format,
                                  const WriteOptions& options) {
  const Result<std::unique_ptr<DrawingParts>> parts = drawing_parts(drawing, format, options);
  if (!parts) return tl::unexpected(parts.error());
  return bytes_of(**parts);
}

Result<void> write_drawing(const std::string& path, const Drawing& drawing, FileFormat format,
                           const WriteOptions& options) {
  if (format == FileFormat::kFelt && path != "-") return write_felt(path, drawing);
  const auto about_path = [&path](const Error& error) {
    return tl::unexpected(with_context(error, path == "-" ? "stdout" : path));
  };
  Result<std::unique_ptr<DrawingParts>> parts = drawing_parts(drawing, format, options);
  if (!parts) return about_path(parts.error());
  if (format == FileFormat::kSvg && is_compressed_name(path)) parts = gzip_parts(*std::move(parts));
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return tl::unexpected(file.error());
  bool is_disk = false;  // errors of the disk already name the file
  const Result<void> done = write_parts(**parts, [&](std::string_view bytes) {
    Result<void> written = file->write(bytes);
    is_disk = !written;
    return written;
  });
  if (!done && !is_disk) return about_path(done.error());
  return done ? file->commit() : done;
}

}  // namespace felt
