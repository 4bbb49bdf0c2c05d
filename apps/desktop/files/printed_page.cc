#include "desktop/files/printed_page.h"

#include <QPainter>
#include <QPainterPath>
#include <QPrinter>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "desktop/engine/grain_setting.h"
#include "desktop/engine/settings.h"
#include "desktop/files/page_picture.h"
#include "felt/document/visible_strokes.h"
#include "felt/formats/drawing_grain.h"
#include "felt/formats/drawing_materials.h"
#include "felt/io/drawing_styles.h"
#include "felt/io/picture/grain_mask.h"
#include "felt/io/picture/png.h"
#include "felt/render/page_painter.h"
#include "felt/render/picture_pixels.h"
#include "felt/render/raster.h"
#include "felt/render/styled_outline.h"
#include "felt/render/view.h"

namespace felt::desktop {
namespace {

constexpr double kPrintToleranceMm = 0.005;
constexpr double kPrintGrainDpi = 300.0;
constexpr double kPrintBlendDpi = 400.0;         // of content that is printed as a picture (chosen)
constexpr double kMaxPrintPx = double(1 << 26);  // of all such pictures together: 256 MiB

QColor color_of(Rgba c) {
  return {c.r, c.g, c.b, c.a};
}

QPainterPath path_of(const Stroke& stroke, const StrokeStyle* style) {
  const OutlinePath outline = styled_path(stroke, style, kPrintToleranceMm);
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
/// mask. Returns false and paints nothing if there is not enough memory for it.
bool paint_grained(QPainter& painter, const Stroke& stroke, const Grain& grain,
                   const GrainMask& mask, Rasterizer& rasterizer) {
  QImage image(mask.width, mask.height, QImage::Format_RGBA8888_Premultiplied);
  if (image.isNull()) return false;
  image.fill(Qt::transparent);
  const Pixels pixels{image.bits(), image.width(), image.height(), image.bytesPerLine(),
                      PixelOrder::kRgba};
  const View view{{mask.area.x0, mask.area.y0}, mask.width / mask.area.width()};
  rasterizer.draw(stroke, view, pixels.rect(), grain, pixels);
  painter.drawImage(QRectF(mask.area.x0, mask.area.y0, mask.area.width(), mask.area.height()),
                    image);
  return true;
}

/// Paints the picture of a layer. PrintedPage::create() has checked that it can be decoded.
void paint_picture(QPainter& painter, const LayerPicture& picture) {
  Result<PngPicture> decoded = decode_png(picture.data->png);
  if (!decoded) return;
  const Affine& m = picture.place;
  painter.save();
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.setTransform(QTransform(m.a, m.b, m.c, m.d, m.e, m.f), true);
  painter.drawImage(QPointF(0.0, 0.0), to_qimage(std::move(decoded->image)));
  painter.restore();
}

/// Paints layers as vector shapes.
class VectorPainter {
 public:
  VectorPainter(QPainter& painter, const Drawing& drawing, const std::optional<Grain>& grain,
                double grain_dpi)
      : painter_(painter), document_(drawing.document), styles_(styles_of(drawing)), grain_(grain) {
    painter.setPen(Qt::NoPen);
    // If the drawing has too much ink, the grain of all strokes is coarser, or all strokes are
    // painted without grain, so that all strokes look alike.
    const Rect area = drawing.page.area();
    const auto dpi = GrainMasks::dpi_for_all(visible_strokes(document_), area, grain_dpi);
    if (grain && dpi) masks_.emplace(GrainPrint{*grain, *dpi}, area);
  }

  void paint(const Layer& layer) {
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
    if (mask && paint_grained(painter_, stroke, *grain_, *mask, rasterizer_)) return;
    painter_.setBrush(color_of(stroke.color()));
    painter_.drawPath(path_of(stroke, styles_.find(stroke.medium())));
  }

  QPainter& painter_;
  const Document& document_;
  StrokeStyles styles_;
  const std::optional<Grain>& grain_;
  std::optional<GrainMasks> masks_;
  Rasterizer rasterizer_;
};

/// Returns true if the drawing has what printers cannot paint layer by layer: a blend mode, or a
/// group of layers that is translucent as a whole.
bool needs_one_picture(const Document& document) {
  const auto layers = document.layers();
  return std::any_of(layers.begin(), layers.end(), [](const Layer& l) {
    return l.visible && (l.blend != BlendMode::kNormal || (l.group && l.group->is_whole()));
  });
}

/// Returns true if the layer is translucent as a whole, and its parts may overlap. Painted one by
/// one, they would show through each other.
bool is_see_through(const Layer& layer) {
  const std::size_t parts = layer.strokes.size() + layer.fills.size() +
                            (exported_picture(layer, PictureChoice::kMarked) ? 1 : 0);
  return layer.visible && layer.opacity < 1.0 && parts > 1;
}

/// Returns the part of the page that the content of a layer may touch.
Rect area_of(const Document& document, const Layer& layer, const Rect& page) {
  Rect area;
  if (const LayerPicture* picture = exported_picture(layer, PictureChoice::kMarked)) {
    area.extend(bounds_of(*picture));
  }
  for (const FillId id : layer.fills) area.extend(fill_bounds(*document.find_fill(id)));
  for (const StrokeId id : layer.strokes) area.extend(document.find(id)->bounds());
  return {std::max(area.x0, page.x0), std::max(area.y0, page.y0), std::min(area.x1, page.x1),
          std::min(area.y1, page.y1)};
}

tl::unexpected<Error> error_of(const Layer& layer, const Error& error) {
  return tl::unexpected(with_context(error, "layer \"" + layer.name + '"'));
}

}  // namespace

Result<PrintedPage> PrintedPage::create(Drawing drawing, double dpi,
                                        const std::optional<Grain>& grain) {
  PrintedPage page(std::move(drawing));
  page.grain_ = grain;
  page.grain_dpi_ = std::min(dpi, kPrintGrainDpi);
  if (auto ok = page.make_parts(dpi); !ok) return tl::unexpected(ok.error());
  return page;
}

Result<void> PrintedPage::make_parts(double dpi) {
  const Document& document = drawing_.document;
  const Grain grain = grain_.value_or(Grain::solid(with_texts(drawing_.materials)));
  const double picture_dpi = std::min(dpi, kPrintBlendDpi);
  const double px_per_mm = picture_dpi / kMmPerInch;
  std::map<LayerId, Rect> areas;
  double pixels = 0.0;
  for (const Layer& layer : document.layers()) {
    if (!is_see_through(layer)) continue;
    const Rect area = area_of(document, layer, drawing_.page.area());
    areas.emplace(layer.id, area);
    if (!area.empty()) pixels += (area.width() * px_per_mm + 2) * (area.height() * px_per_mm + 2);
  }
  // Many translucent layers need less memory as one picture of the page.
  if (needs_one_picture(document) || pixels > kMaxPrintPx) {
    return whole_page(drawing_, picture_dpi, grain).map([this](Part part) {
      page_ = std::move(part);
    });
  }
  for (const auto& [id, area] : areas) {
    const Layer& layer = *document.layer(id);
    Result<Part> part = whole_layer(document, layer, area, px_per_mm, grain);
    if (!part) return error_of(layer, part.error());
    parts_.emplace(id, *std::move(part));
  }
  return check_pictures();
}

/// Fails if a picture that paint() decodes is damaged.
Result<void> PrintedPage::check_pictures() const {
  std::set<const PictureData*> checked;
  for (const Layer& layer : drawing_.document.layers()) {
    const LayerPicture* picture = exported_picture(layer, PictureChoice::kMarked);
    if (!picture || parts_.contains(layer.id) || !checked.insert(picture->data.get()).second) {
      continue;
    }
    if (const auto decoded = decode_png(picture->data->png); !decoded) {
      return error_of(layer, decoded.error());
    }
  }
  return {};
}

Result<PrintedPage::Part> PrintedPage::whole_page(const Drawing& drawing, double dpi,
                                                  const Grain& grain) {
  const Rect area = drawing.page.area();
  const double largest = kMmPerInch * std::sqrt(kMaxPrintPx / (area.width() * area.height()));
  const PageOptions options{
      .dpi = std::min(dpi, largest), .area = area, .paper = drawing.page.paper, .grain = grain};
  Result<Image> image = render_page(drawing.document, options, PictureChoice::kMarked);
  if (!image) return tl::unexpected(image.error());
  const double mm_per_px = kMmPerInch / options.dpi;
  const QRectF shown(area.x0, area.y0, image->width() * mm_per_px, image->height() * mm_per_px);
  return Part{to_qimage(*std::move(image)), shown};
}

/// Paints a layer as it is without its opacity, on the grid of pixels that begins at the corner of
/// the page.
Result<PrintedPage::Part> PrintedPage::whole_layer(const Document& document, const Layer& layer,
                                                   const Rect& area, double px_per_mm,
                                                   const Grain& grain) {
  if (area.empty()) return Part{};
  const double x0 = std::floor(area.x0 * px_per_mm), y0 = std::floor(area.y0 * px_per_mm);
  const auto size = [px_per_mm](double from_px, double to_mm) {
    return std::max(1, static_cast<int>(std::ceil(to_mm * px_per_mm) - from_px));
  };
  Result<Image> image = Image::create(size(x0, area.x1), size(y0, area.y1));
  if (!image) return tl::unexpected(image.error());
  const Pixels pixels = image->pixels();
  const View view{{x0 / px_per_mm, y0 / px_per_mm}, px_per_mm};
  if (const LayerPicture* picture = exported_picture(layer, PictureChoice::kMarked)) {
    const auto decoded = PicturePixels::decode(*picture->data);
    if (!decoded) return tl::unexpected(decoded.error());
    (*decoded)->draw(picture->place, view, pixels.rect(), 1.0, pixels);
  }
  Rasterizer rasterizer;
  for (const FillId id : layer.fills) {
    rasterizer.draw_fill(*document.find_fill(id), view, pixels.rect(), pixels);
  }
  for (const StrokeId id : layer.strokes) {
    rasterizer.draw(*document.find(id), view, pixels.rect(), grain, pixels);
  }
  const QRectF shown(view.origin_mm.x, view.origin_mm.y, pixels.width / px_per_mm,
                     pixels.height / px_per_mm);
  return Part{to_qimage(*std::move(image)), shown};
}

void PrintedPage::paint(QPainter& painter, double dpi) const {
  painter.save();
  painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  painter.scale(dpi / kMmPerInch, dpi / kMmPerInch);
  const Page& page = drawing_.page;
  const QRectF area(0.0, 0.0, page.width_mm, page.height_mm);
  painter.setClipRect(area);
  if (page_) {
    painter.drawImage(page_->area_mm, page_->image);
  } else {
    // White paper does not have to be painted.
    if (page.paper.a > 0 && page.paper != Rgba{255, 255, 255, 255}) {
      painter.fillRect(area, color_of(page.paper));
    }
    paint_layers(painter);
  }
  painter.restore();
}

void PrintedPage::paint_layers(QPainter& painter) const {
  VectorPainter vectors(painter, drawing_, grain_, grain_dpi_);
  for (const Layer& layer : drawing_.document.layers()) {
    if (!layer.visible) continue;
    painter.setOpacity(layer.opacity);
    const auto part = parts_.find(layer.id);
    if (part == parts_.end()) {
      vectors.paint(layer);
    } else if (!part->second.image.isNull()) {
      painter.drawImage(part->second.area_mm, part->second.image);
    }
  }
}

Result<void> print_drawing(QPrinter& printer, const Drawing& drawing, double max_dpi) {
  const bool shows = Settings::the().flag(kShowsGrain, kShowsGrainDefault);
  const Result<Grain> grain = grain_of(drawing);
  const Result<PrintedPage> page =
      PrintedPage::create(drawing, std::min<double>(printer.resolution(), max_dpi),
                          shows && grain ? std::optional(*grain) : std::nullopt);
  if (!page) return tl::unexpected(page.error());
  QPainter painter;
  if (!painter.begin(&printer)) return fail(ErrorCode::kIo, "the printer cannot be used");
  page->paint(painter, printer.resolution());
  return {};
}

}  // namespace felt::desktop
