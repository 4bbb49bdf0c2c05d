#include "desktop/files/output_actions.h"

#include <QDir>
#include <QFileInfo>
#include <QGraphicsView>
#include <QPainter>
#include <QPainterPath>
#include <QPrintDialog>
#include <QPrintPreviewDialog>
#include <QPrinter>
#include <algorithm>
#include <cmath>
#include <memory>

#include "desktop/engine/grain_setting.h"
#include "desktop/engine/settings.h"
#include "desktop/files/error_words.h"
#include "desktop/files/export_dialog.h"
#include "desktop/files/file_actions.h"
#include "desktop/files/format_texts.h"
#include "desktop/files/page_dialog.h"
#include "desktop/files/swell_words.h"
#include "felt/document/visible_strokes.h"
#include "felt/formats/drawing_grain.h"
#include "felt/io/picture/grain_mask.h"
#include "felt/render/page_painter.h"
#include "felt/render/raster.h"
#include "felt/render/view.h"
#include "felt/stroke/outline/outline_path.h"

namespace felt::desktop {
namespace {

constexpr double kPrintToleranceMm = 0.005;
constexpr double kPrintGrainDpi = 300.0;
constexpr double kPrintBlendDpi = 400.0;         // of a page that is printed as a picture (chosen)
constexpr double kMaxPrintPx = double(1 << 26);  // of such a page: 256 MiB

QColor color_of(Rgba c) {
  return {c.r, c.g, c.b, c.a};
}

QPainterPath path_of(const Stroke& stroke) {
  const OutlinePath outline = outline_path(stroke, kPrintToleranceMm);
  QPainterPath path;
  path.setFillRule(Qt::WindingFill);
  const Point* p = outline.points.data();
  const auto point = [](const Point& q) { return QPointF(q.x, q.y); };
  for (const OutlinePath::Verb verb : outline.verbs) {
    switch (verb) {
      case OutlinePath::Verb::kMove:
        path.moveTo(point(*p++));
        break;
      case OutlinePath::Verb::kLine:
        path.lineTo(point(*p++));
        break;
      case OutlinePath::Verb::kCubic:
        path.cubicTo(point(p[0]), point(p[1]), point(p[2]));
        p += 3;
        break;
      case OutlinePath::Verb::kClose:
        path.closeSubpath();
        break;
    }
  }
  return path;
}

QPainterPath path_of(const Fill& fill) {
  QPainterPath path;
  path.setFillRule(Qt::OddEvenFill);
  const auto point = [](const Point& q) { return QPointF(q.x, q.y); };
  for (const FillLoop& loop : fill.loops) {
    path.moveTo(point(loop.points.front()));
    for (std::size_t i = 1; i + 2 < loop.points.size(); i += 3) {
      path.cubicTo(point(loop.points[i]), point(loop.points[i + 1]), point(loop.points[i + 2]));
    }
    path.closeSubpath();
  }
  return path;
}

/// Paints a stroke as a picture of its ink. The picture has the resolution of the stroke's grain
/// mask.
void paint_grained(QPainter& painter, const Stroke& stroke, const Grain& grain,
                   const GrainMask& mask, Rasterizer& rasterizer) {
  QImage image(mask.width, mask.height, QImage::Format_RGBA8888_Premultiplied);
  image.fill(Qt::transparent);
  const Pixels pixels{image.bits(), image.width(), image.height(), image.bytesPerLine(),
                      PixelOrder::kRgba};
  const View view{{mask.area.x0, mask.area.y0}, mask.width / mask.area.width()};
  rasterizer.draw(stroke, view, pixels.rect(), grain, pixels);
  painter.drawImage(QRectF(mask.area.x0, mask.area.y0, mask.area.width(), mask.area.height()),
                    image);
}

void paint_picture(QPainter& painter, const LayerPicture& picture) {
  const std::string& png = picture.data->png;
  QImage image;
  image.loadFromData(reinterpret_cast<const uchar*>(png.data()), static_cast<int>(png.size()),
                     "PNG");
  if (image.isNull()) return;
  const Affine& m = picture.place;
  painter.save();
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.setTransform(QTransform(m.a, m.b, m.c, m.d, m.e, m.f), true);
  painter.drawImage(QPointF(0.0, 0.0), image);
  painter.restore();
}

/// Returns a printer whose paper has the size of the page.
std::unique_ptr<QPrinter> printer_for(const Drawing& drawing, const QString& name) {
  auto printer = std::make_unique<QPrinter>(QPrinter::HighResolution);
  const Page& page = drawing.page;
  const bool lies = page.width_mm > page.height_mm;
  const QSizeF upright(lies ? page.height_mm : page.width_mm,
                       lies ? page.width_mm : page.height_mm);
  printer->setPageSize(QPageSize(upright, QPageSize::Millimeter, {}, QPageSize::FuzzyMatch));
  printer->setPageOrientation(lies ? QPageLayout::Landscape : QPageLayout::Portrait);
  printer->setFullPage(true);  // the page's corner is the paper's corner
  printer->setDocName(name);
  return printer;
}

/// Returns true if the drawing has what printers cannot paint as lines: a blend mode, or a group of
/// layers that is translucent as a whole.
bool needs_pixels(const Document& document) {
  const auto layers = document.layers();
  return std::any_of(layers.begin(), layers.end(), [](const Layer& l) {
    return l.visible && (l.blend != BlendMode::kNormal || (l.group && l.group->is_whole()));
  });
}

/// Paints the page as one picture. Returns false if it could not be made.
bool paint_pixels(QPainter& painter, const Drawing& drawing, double dpi,
                  const std::optional<Grain>& grain) {
  PageOptions options{.dpi = dpi, .area = drawing.page.area(), .paper = drawing.page.paper};
  if (grain) options.grain = *grain;
  Result<Image> image = render_page(drawing.document, options, PictureChoice::kMarked);
  if (!image) return false;
  const Pixels pixels = image->pixels();
  const double mm_per_px = kMmPerInch / dpi;
  painter.drawImage(
      QRectF(0.0, 0.0, pixels.width * mm_per_px, pixels.height * mm_per_px),
      QImage(pixels.data, pixels.width, pixels.height, static_cast<qsizetype>(pixels.stride),
             QImage::Format_RGBA8888_Premultiplied));
  return true;
}

/// Paints the layers of a page, the strokes with the grain of the surface if it is given.
class StrokePrint {
 public:
  StrokePrint(QPainter& painter, const Drawing& drawing, const std::optional<Grain>& grain)
      : painter_(painter), document_(drawing.document), grain_(grain) {
    if (!grain) return;
    // If the drawing has too much ink, the grain of all strokes is coarser, or all strokes are
    // painted without grain, so that all strokes look alike.
    const std::vector<StrokePtr> strokes = visible_strokes(document_);
    const Rect area = drawing.page.area();
    const auto grain_dpi = GrainMasks::dpi_for_all(strokes, area, kPrintGrainDpi);
    if (grain_dpi) masks_.emplace(GrainPrint{*grain, *grain_dpi}, area);
  }

  void paint(const Layer& layer) {
    painter_.setOpacity(layer.opacity);
    if (const LayerPicture* picture = exported_picture(layer, PictureChoice::kMarked)) {
      paint_picture(painter_, *picture);
    }
    for (const FillId id : layer.fills) {
      const FillPtr fill = document_.find_fill(id);
      painter_.setBrush(color_of(fill->color));
      painter_.drawPath(path_of(*fill));
    }
    for (const StrokeId id : layer.strokes) paint(*document_.find(id));
  }

 private:
  void paint(const Stroke& stroke) {
    const auto mask = masks_ ? masks_->of(stroke).value_or(std::nullopt) : std::nullopt;
    if (mask) return paint_grained(painter_, stroke, *grain_, *mask, rasterizer_);
    painter_.setBrush(color_of(stroke.color()));
    painter_.drawPath(path_of(stroke));
  }

  QPainter& painter_;
  const Document& document_;
  const std::optional<Grain>& grain_;
  std::optional<GrainMasks> masks_;
  Rasterizer rasterizer_;
};

}  // namespace

void paint_page(QPainter& painter, const Drawing& drawing, double dpi,
                const std::optional<Grain>& grain) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(dpi / kMmPerInch, dpi / kMmPerInch);
  const Page& page = drawing.page;
  const QRectF area(0.0, 0.0, page.width_mm, page.height_mm);
  painter.setClipRect(area);
  // White paper does not have to be painted.
  if (page.paper.a > 0 && page.paper != Rgba{255, 255, 255, 255}) {
    painter.fillRect(area, color_of(page.paper));
  }
  if (needs_pixels(drawing.document)) {
    const double largest = kMmPerInch * std::sqrt(kMaxPrintPx / (area.width() * area.height()));
    // Without memory for the picture, the lines are printed without blending.
    if (paint_pixels(painter, drawing, std::min({dpi, kPrintBlendDpi, largest}), grain)) {
      painter.restore();
      return;
    }
  }
  painter.setPen(Qt::NoPen);
  StrokePrint print(painter, drawing, grain);
  for (const Layer& layer : drawing.document.layers()) {
    if (layer.visible) print.paint(layer);
  }
  painter.restore();
}

void print_drawing(QPrinter& printer, const Drawing& drawing) {
  QPainter painter(&printer);
  const bool shows = Settings::the().flag(kShowsGrain, kShowsGrainDefault);
  const Result<Grain> grain = grain_of(drawing);
  paint_page(painter, drawing, printer.resolution(),
             shows && grain ? std::optional(*grain) : std::nullopt);
}

OutputActions::OutputActions(FileActions& files, Studio& studio, Actions& actions, QWidget* window)
    : QObject(window), files_(files), studio_(studio), window_(window) {
  actions.add(QStringLiteral("file.export"), tr("&Export…"),
              {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_E)},
              tr("Export the drawing as SVG, PDF, PNG or ink for other programs"),
              [this] { ask_export(); });
  actions.add(QStringLiteral("file.page_setup"), tr("Pa&ge setup…"), {},
              tr("Size, orientation and colour of the page"), [this] { ask_page(); });
  actions.add(QStringLiteral("file.print_preview"), tr("Print pre&view…"), {},
              tr("Shows what will be printed"), [this] { preview(); });
  actions.add(QStringLiteral("file.print"), tr("&Print…"), {QKeySequence::Print},
              tr("Prints the page at its true size"), [this] { print(); });
}

void OutputActions::ask_export() {
  ExportDialog dialog(files_.drawing(), studio_.session().selection(), window_);
  if (dialog.exec() != QDialog::Accepted) return;
  const ExportOptions options = dialog.options();
  const QString suffix = suffix_of(options.format);
  const QString base = QFileInfo(files_.display_name()).completeBaseName();
  const QString chosen = files_.dialogs().name_to_write(
      window_, tr("Export"), QDir(files_.folder()).filePath(base + suffix), options.format);
  if (!chosen.isEmpty()) export_to(chosen, options);
}

void OutputActions::export_to(const QString& path, const ExportOptions& options) {
  Drawing drawing = files_.drawing();
  if (options.part == ExportPart::kSelection) {
    drawing = selected_only(std::move(drawing), studio_.session().selection());
  }
  files_.worker().start([this, path, options,
                         drawing = std::move(drawing)]() -> FileWorker::Answer {
    SwellReport swell;
    const Result<void> done = export_drawing(path, drawing, options, &swell);
    const LostObjects lost = options.swell
                                 ? LostObjects()
                                 : lost_objects(drawing.document, options.format, options.compact);
    return
        [this, path, done, lost, swell] { report_exported(path, done, lost, swell_words(swell)); };
  });
}

void OutputActions::report_exported(const QString& path, const Result<void>& done,
                                    const LostObjects& lost, const QString& changed) {
  const QString name = QFileInfo(path).fileName();
  if (!done) {
    files_.dialogs().show_error(window_, tr("“%1” was not exported").arg(name),
                                error_words(done.error()),
                                QString::fromStdString(done.error().message));
  }
  Q_EMIT exported(path, done.has_value(), lost, changed);
}

void OutputActions::ask_page() {
  PageDialog dialog(studio_.page(), window_);
  if (dialog.exec() == QDialog::Accepted) studio_.set_page(dialog.page());
}

void OutputActions::print() {
  const Drawing drawing = files_.drawing();
  const auto printer = printer_for(drawing, files_.display_name());
  QPrintDialog dialog(printer.get(), window_);
  dialog.setWindowTitle(tr("Print"));
  if (dialog.exec() == QDialog::Accepted) print_drawing(*printer, drawing);
}

void OutputActions::preview() {
  const Drawing drawing = files_.drawing();
  const auto printer = printer_for(drawing, files_.display_name());
  QPrintPreviewDialog dialog(printer.get(), window_);
  dialog.setWindowTitle(tr("Print preview"));
  for (auto* view : dialog.findChildren<QGraphicsView*>()) {
    view->setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  }
  connect(&dialog, &QPrintPreviewDialog::paintRequested, this,
          [&drawing](QPrinter* target) { print_drawing(*target, drawing); });
  dialog.exec();
}

}  // namespace felt::desktop
