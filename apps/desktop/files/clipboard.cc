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

#include "desktop/files/sheet_picture.h"
#include "felt/document/visible_strokes.h"
#include "felt/formats/drawing_reader.h"
#include "felt/io/limits.h"
#include "felt/io/ndjson/ndjson_writer.h"
#include "felt/io/svg/svg_writer.h"
#include "felt/io/xml/material_texts.h"
#include "felt/render/page.h"
#include "felt/render/view.h"

namespace felt::desktop {
namespace {

constexpr double kDpi = 300.0;
constexpr double kMostPixels = 16e6;
constexpr double kMarginMm = 1.0;
// Of texts within their limits: in JSON a byte of them takes two at most.
constexpr std::size_t kMostMaterialsBytes =
    limits::kMaxMaterialTexts * (2 * limits::kMaxMaterialTextBytes + 3) + 2;
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

QByteArray json_of(std::span<const std::string> texts) {
  QJsonArray all;
  for (const std::string& text : texts) all.append(QString::fromStdString(text));
  return QJsonDocument(all).toJson(QJsonDocument::Compact);
}

/// What is none, or beyond the limits of a drawing, is left out.
std::vector<std::string> texts_in(const QByteArray& json) {
  std::vector<std::string> texts;
  if (static_cast<std::size_t>(json.size()) > kMostMaterialsBytes) return texts;
  const QJsonArray all = QJsonDocument::fromJson(json).array();
  const auto most = std::min(all.size(), qsizetype(limits::kMaxMaterialTexts));
  for (qsizetype i = 0; i < most; ++i) {
    add_material_text(texts, all.at(i).toString().toStdString());
  }
  return texts;
}

/// With the materials, where there are any, as a whole drawing has them.
Result<std::string> svg_text_of(const Sketch& sketch, std::span<const std::string> materials) {
  const SvgOptions options{.margin_mm = kMarginMm};
  if (materials.empty()) return svg_text(sketch, options);
  LayeredSketch drawing;
  drawing.layers.push_back({"Ink", true, false, sketch});
  drawing.materials.assign(materials.begin(), materials.end());
  return svg_text(drawing, options);
}

QByteArray svg_of(const Sketch& sketch, std::span<const std::string> materials) {
  const Result<std::string> text = svg_text_of(sketch, materials);
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
        return PastedStrokes{visible_strokes(opened.drawing.document), opened.report,
                             opened.drawing.materials};
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
  PromisedStrokes(Sketch sketch, std::vector<std::string> materials)
      : sketch_(std::move(sketch)), materials_(std::move(materials)) {}

  [[nodiscard]] QStringList formats() const override {
    QStringList all{QString::fromLatin1(kStrokesMime), kSvgMime, kImageMime};
    if (!materials_.empty()) all.push_back(QString::fromLatin1(kMaterialsMime));
    return all;
  }
  [[nodiscard]] bool hasFormat(const QString& mime) const override {
    return formats().contains(mime);
  }

 protected:
  [[nodiscard]] QVariant retrieveData(const QString& mime, QMetaType) const override {
    QVariant& made = made_[mime];
    if (made.isValid()) return made;
    if (mime == QLatin1String(kStrokesMime)) made = ndjson_of(sketch_);
    if (mime == QLatin1String(kMaterialsMime)) made = json_of(materials_);
    if (mime == kSvgMime) made = svg_of(sketch_, materials_);
    if (mime == kImageMime) made = picture_of(sketch_);
    return made;
  }

 private:
  Sketch sketch_;
  std::vector<std::string> materials_;
  mutable QHash<QString, QVariant> made_;
};

}  // namespace

Rect ink_area(const Sketch& sketch) {
  Rect ink;
  for (const SketchStroke& s : sketch) ink.extend(s.stroke.bounds());
  return (ink.empty() ? Rect{0.0, 0.0, 0.0, 0.0} : ink).inflated(kMarginMm);
}

std::unique_ptr<QMimeData> strokes_mime(Sketch sketch, std::vector<std::string> materials) {
  return std::make_unique<PromisedStrokes>(std::move(sketch), std::move(materials));
}

std::unique_ptr<QMimeData> svg_mime(const Sketch& sketch, std::span<const std::string> materials) {
  auto data = std::make_unique<QMimeData>();
  const QByteArray svg = svg_of(sketch, materials);
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
  if (data.hasFormat(own)) {
    Result<PastedStrokes> pasted = strokes_in(data.data(own));
    const QString materials = QString::fromLatin1(kMaterialsMime);
    if (pasted && data.hasFormat(materials)) pasted->materials = texts_in(data.data(materials));
    return pasted;
  }
  for (const QString& type : drawing_types()) {
    if (data.hasFormat(type)) return strokes_in(data.data(type));
  }
  const QByteArray text = data.hasText() ? data.text().toUtf8() : QByteArray();
  return is_drawing_text(text) ? strokes_in(text) : PastedStrokes();
}

}  // namespace felt::desktop
