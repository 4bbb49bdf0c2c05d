#include "desktop/files/clipboard.h"

#include <QByteArray>
#include <QHash>
#include <QImage>
#include <QStringList>
#include <QVariant>
#include <algorithm>
#include <cmath>
#include <utility>

#include "desktop/files/sheet_picture.h"
#include "felt/document/visible_strokes.h"
#include "felt/formats/drawing_reader.h"
#include "felt/io/ndjson_writer.h"
#include "felt/io/svg_writer.h"
#include "felt/render/page.h"
#include "felt/render/view.h"

namespace felt::desktop {
namespace {

constexpr double kDpi = 300.0;
constexpr double kMostPixels = 16e6;
constexpr double kMarginMm = 1.0;
const QString kSvgMime = QStringLiteral("image/svg+xml");
const QString kImageMime = QStringLiteral("application/x-qt-image");  // Qt's name for any picture

QByteArray bytes_of(const std::string& text) {
  return QByteArray(text.data(), qsizetype(text.size()));
}

QByteArray ndjson_of(const Sketch& sketch) {
  std::string text;
  for (const SketchStroke& s : sketch) append_sketch_line(text, s.id, s.stroke.data());
  return bytes_of(text);
}

QByteArray svg_of(const Sketch& sketch) {
  const Result<std::string> text = svg_text(sketch, {.margin_mm = kMarginMm});
  return text ? bytes_of(*text) : QByteArray();
}

QImage picture_of(const Sketch& sketch) {
  const Rect area = ink_area(sketch);
  const double fits = std::sqrt(kMostPixels / std::max(1.0, area.width() * area.height()));
  return sheet_picture(sketch, area, std::min(kDpi / kMmPerInch, fits), {255, 255, 255, 0});
}

/// A drawing of any format that text may hold.
Result<PastedStrokes> strokes_in(const QByteArray& bytes) {
  return parse_drawing({bytes.constData(), static_cast<std::size_t>(bytes.size())}, {})
      .map([](const OpenedDrawing& opened) {
        return PastedStrokes{visible_strokes(opened.drawing.document), opened.report};
      });
}

/// The types that programs put vector drawings and ink on the clipboard with.
const QStringList& drawing_types() {
  static const QStringList types{kSvgMime, QStringLiteral("image/x-inkscape-svg"),
                                 QStringLiteral("application/inkml+xml"),
                                 QStringLiteral("text/inkml+xml")};
  return types;
}

/// Text that is a drawing: an SVG copied from an editor or a page's source.
bool is_drawing_text(const QByteArray& text) {
  const auto format = format_of_bytes(
      {text.constData(), std::min<std::size_t>(std::size_t(text.size()), kFormatHeadBytes)});
  return format == FileFormat::kSvg || format == FileFormat::kInkml ||
         format == FileFormat::kNdjson;
}

/// Strokes that become SVG and pixels when another program asks for them: most copies are pasted
/// here, and a large picture takes longer than a keystroke may.
class PromisedStrokes final : public QMimeData {
 public:
  explicit PromisedStrokes(Sketch sketch) : sketch_(std::move(sketch)) {}

  [[nodiscard]] QStringList formats() const override {
    return {QString::fromLatin1(kStrokesMime), kSvgMime, kImageMime};
  }
  [[nodiscard]] bool hasFormat(const QString& mime) const override {
    return formats().contains(mime);
  }

 protected:
  [[nodiscard]] QVariant retrieveData(const QString& mime, QMetaType) const override {
    QVariant& made = made_[mime];
    if (made.isValid()) return made;
    if (mime == QLatin1String(kStrokesMime)) made = ndjson_of(sketch_);
    if (mime == kSvgMime) made = svg_of(sketch_);
    if (mime == kImageMime) made = picture_of(sketch_);
    return made;
  }

 private:
  Sketch sketch_;
  mutable QHash<QString, QVariant> made_;
};

}  // namespace

Rect ink_area(const Sketch& sketch) {
  Rect ink;
  for (const SketchStroke& s : sketch) ink.extend(s.stroke.bounds());
  return (ink.empty() ? Rect{0.0, 0.0, 0.0, 0.0} : ink).inflated(kMarginMm);
}

std::unique_ptr<QMimeData> strokes_mime(Sketch sketch) {
  return std::make_unique<PromisedStrokes>(std::move(sketch));
}

std::unique_ptr<QMimeData> svg_mime(const Sketch& sketch) {
  auto data = std::make_unique<QMimeData>();
  const QByteArray svg = svg_of(sketch);
  data->setData(kSvgMime, svg);
  data->setText(QString::fromUtf8(svg));
  return data;
}

std::unique_ptr<QMimeData> png_mime(const Sketch& sketch) {
  auto data = std::make_unique<QMimeData>();
  data->setImageData(picture_of(sketch));
  return data;
}

Result<PastedStrokes> strokes_of(const QMimeData& data) {
  const QString own = QString::fromLatin1(kStrokesMime);
  if (data.hasFormat(own)) return strokes_in(data.data(own));
  for (const QString& type : drawing_types()) {
    if (data.hasFormat(type)) return strokes_in(data.data(type));
  }
  const QByteArray text = data.hasText() ? data.text().toUtf8() : QByteArray();
  return is_drawing_text(text) ? strokes_in(text) : PastedStrokes();
}

}  // namespace felt::desktop
