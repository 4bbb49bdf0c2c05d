#include "desktop/files/clipboard.h"

#include <QByteArray>
#include <QHash>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QStringList>
#include <QVariant>
#include <algorithm>
#include <cmath>
#include <utility>

#include "desktop/files/page_picture.h"
#include "felt/document/visible_strokes.h"
#include "felt/formats/drawing_materials.h"
#include "felt/formats/drawing_reader.h"
#include "felt/io/limits.h"
#include "felt/io/ndjson/ndjson_writer.h"
#include "felt/io/svg/svg_writer.h"
#include "felt/io/xml/material_texts.h"
#include "felt/render/page_painter.h"
#include "felt/render/view.h"

namespace felt::desktop {
namespace {

constexpr double kDpi = 300.0;
constexpr double kMaxPixels = 16e6;
constexpr double kMarginMm = 1.0;
// JSON needs at most two bytes for each byte of a text.
constexpr std::size_t kMaxMaterialsBytes =
    limits::kMaxMaterialTexts * (2 * limits::kMaxMaterialTextBytes + 3) + 2;
const QString kSvgMime = QStringLiteral("image/svg+xml");
const QString kImageMime = QStringLiteral("application/x-qt-image");  // Qt's name for any picture

QByteArray bytes_of(const std::string& text) {
  return QByteArray(text.data(), qsizetype(text.size()));
}

/// Returns the drawing for Feltline: as lines of JSON or, because these cannot hold fills, as SVG.
QByteArray strokes_of(const Drawing& drawing) {
  std::string text;
  if (drawing.document.fill_count() > 0) {
    const Result<std::string> svg = svg_text(drawing, {.margin_mm = kMarginMm});
    if (svg) return bytes_of(*svg);
  }
  for (const Layer& layer : drawing.document.layers()) {
    for (const StrokeId id : layer.strokes) {
      append_sketch_line(text, name_in_file(drawing, id), drawing.document.find(id)->data());
    }
  }
  return bytes_of(text);
}

QByteArray json_of(std::span<const std::string> texts) {
  QJsonArray all;
  for (const std::string& text : texts) all.append(QString::fromStdString(text));
  return QJsonDocument(all).toJson(QJsonDocument::Compact);
}

/// Returns the texts of a JSON array. Skips entries that are not texts or exceed the limits of a
/// drawing.
std::vector<std::string> texts_in(const QByteArray& json) {
  std::vector<std::string> texts;
  if (static_cast<std::size_t>(json.size()) > kMaxMaterialsBytes) return texts;
  const QJsonArray all = QJsonDocument::fromJson(json).array();
  const auto largest = std::min(all.size(), qsizetype(limits::kMaxMaterialTexts));
  for (qsizetype i = 0; i < largest; ++i) {
    add_material_text(texts, all.at(i).toString().toStdString());
  }
  return texts;
}

/// Returns the strokes as SVG. If the drawing has materials, writes the whole drawing, so that the
/// SVG contains the materials.
QByteArray svg_of(const Drawing& drawing) {
  const SvgOptions options{.margin_mm = kMarginMm};
  const Result<std::string> text =
      drawing.materials.empty() ? svg_ink_text(drawing, options) : svg_text(drawing, options);
  return text ? bytes_of(*text) : QByteArray();
}

QImage picture_of(const Drawing& drawing) {
  const Rect area = ink_area(ink_bounds(drawing.document));
  const double fits = std::sqrt(kMaxPixels / std::max(1.0, area.width() * area.height()));
  return page_picture(drawing.document, area, std::min(kDpi / kMmPerInch, fits), {255, 255, 255, 0},
                      Grain::solid(with_texts(drawing.materials)));
}

/// Reads a drawing of any text format.
Result<Imported> drawing_in(const QByteArray& bytes) {
  return parse_drawing({bytes.constData(), static_cast<std::size_t>(bytes.size())}, {});
}

/// Returns the types under which programs put vector drawings and ink on the clipboard.
const QStringList& drawing_types() {
  static const QStringList types{kSvgMime, QStringLiteral("image/x-inkscape-svg"),
                                 QStringLiteral("application/inkml+xml"),
                                 QStringLiteral("text/inkml+xml")};
  return types;
}

/// Returns true if the text is a drawing, such as an SVG copied from an editor or from the source
/// of a web page.
bool is_drawing_text(const QByteArray& text) {
  const auto format = format_of_bytes(
      {text.constData(), std::min<std::size_t>(std::size_t(text.size()), kFormatHeadBytes)});
  return format == FileFormat::kSvg || format == FileFormat::kInkml ||
         format == FileFormat::kNdjson;
}

/// Clipboard data that makes the SVG and the picture only when a program requests them. Most copies
/// are pasted in Feltline, and making a large picture would delay the copy command too much.
class PromisedStrokes final : public QMimeData {
 public:
  explicit PromisedStrokes(Drawing drawing) : drawing_(std::move(drawing)) {}

  [[nodiscard]] QStringList formats() const override {
    QStringList all{QString::fromLatin1(kStrokesMime), kSvgMime, kImageMime};
    if (!drawing_.materials.empty()) all.push_back(QString::fromLatin1(kMaterialsMime));
    return all;
  }
  [[nodiscard]] bool hasFormat(const QString& mime) const override {
    return formats().contains(mime);
  }

 protected:
  [[nodiscard]] QVariant retrieveData(const QString& mime, QMetaType) const override {
    QVariant& made = made_[mime];
    if (made.isValid()) return made;
    if (mime == QLatin1String(kStrokesMime)) made = strokes_of(drawing_);
    if (mime == QLatin1String(kMaterialsMime)) made = json_of(drawing_.materials);
    if (mime == kSvgMime) made = svg_of(drawing_);
    if (mime == kImageMime) made = picture_of(drawing_);
    return made;
  }

 private:
  Drawing drawing_;
  mutable QHash<QString, QVariant> made_;
};

}  // namespace

Rect ink_area(const Rect& ink) {
  return (ink.empty() ? Rect{0.0, 0.0, 0.0, 0.0} : ink).inflated(kMarginMm);
}

std::unique_ptr<QMimeData> strokes_mime(Drawing drawing) {
  return std::make_unique<PromisedStrokes>(std::move(drawing));
}

std::unique_ptr<QMimeData> svg_mime(const Drawing& drawing) {
  auto data = std::make_unique<QMimeData>();
  const QByteArray svg = svg_of(drawing);
  data->setData(kSvgMime, svg);
  data->setText(QString::fromUtf8(svg));
  return data;
}

std::unique_ptr<QMimeData> png_mime(const Drawing& drawing) {
  auto data = std::make_unique<QMimeData>();
  data->setImageData(picture_of(drawing));
  return data;
}

Result<Imported> drawing_of(const QMimeData& data) {
  const QString own = QString::fromLatin1(kStrokesMime);
  if (data.hasFormat(own)) {
    Result<Imported> pasted = drawing_in(data.data(own));
    const QString materials = QString::fromLatin1(kMaterialsMime);
    if (pasted && data.hasFormat(materials)) {
      pasted->drawing.materials = texts_in(data.data(materials));
    }
    return pasted;
  }
  for (const QString& type : drawing_types()) {
    if (data.hasFormat(type)) return drawing_in(data.data(type));
  }
  const QByteArray text = data.hasText() ? data.text().toUtf8() : QByteArray();
  return is_drawing_text(text) ? drawing_in(text) : Imported();
}

}  // namespace felt::desktop
