#include "felt/render/page_painter.h"

#include <cmath>

#include "felt/document/visible_strokes.h"

namespace felt {
namespace {

constexpr double kFinestDpi = 100'000.0;
constexpr double kWidestMarginMm = 10'000.0;

/// Returns the number of pixels that cover a length. The last one may extend beyond it, but not
/// because of rounding alone.
int pixels_for(double mm, double px_per_mm) noexcept {
  const double px = std::ceil(mm * px_per_mm - 1e-6);
  return px < 1.0 ? 1 : px < 1e9 ? static_cast<int>(px) : 1'000'000'000;
}

}  // namespace

Rect ink_bounds(std::span<const StrokePtr> strokes) noexcept {
  Rect area;
  for (const StrokePtr& stroke : strokes) area.extend(stroke->bounds());
  return area;
}

Rect page_area(const Rect& ink, const PageOptions& options) noexcept {
  if (options.area) return *options.area;
  return (ink.empty() ? Rect{0.0, 0.0, 0.0, 0.0} : ink).inflated(options.margin_mm);
}

Result<PagePainter> PagePainter::create(const Rect& ink, const PageOptions& options) {
  if (!(options.dpi > 0.0 && options.dpi <= kFinestDpi)) {
    return fail(ErrorCode::kInvalidArgument,
                "the resolution must be above 0 and at most 100000 dpi");
  }
  if (!(options.margin_mm >= 0.0 && options.margin_mm <= kWidestMarginMm)) {
    return fail(ErrorCode::kInvalidArgument, "the margin must be between 0 and 10000 mm");
  }
  const Rect area = page_area(ink, options);
  if (area.empty() || !std::isfinite(area.width()) || !std::isfinite(area.height())) {
    return fail(ErrorCode::kInvalidArgument, "the area to draw is empty or not finite");
  }
  const View view = View::at_dpi({area.x0, area.y0}, options.dpi);
  auto image = Image::create(pixels_for(area.width(), view.px_per_mm),
                             pixels_for(area.height(), view.px_per_mm));
  if (!image) return tl::unexpected(image.error());
  const Pixels pixels = image->pixels();
  fill(pixels, pixels.rect(), options.paper);
  return PagePainter(*std::move(image), view, options.grain);
}

void PagePainter::draw(const Stroke& stroke) {
  const Pixels pixels = image_.pixels();
  rasterizer_.draw(stroke, view_, pixels.rect(), grain_, pixels);
}

void PagePainter::draw(const Document& document) {
  const Pixels pixels = image_.pixels();
  for (const Layer& layer : document.layers()) {
    if (!layer.visible) continue;
    for (const FillId id : layer.fills) {
      rasterizer_.draw_fill(*document.find_fill(id), view_, pixels.rect(), pixels);
    }
    for (const StrokeId id : layer.strokes) draw(*document.find(id));
  }
}

Result<Image> render_document(const Document& document, const PageOptions& options) {
  Result<PagePainter> page = PagePainter::create(ink_bounds(document), options);
  if (!page) return tl::unexpected(page.error());
  page->draw(document);
  return std::move(page->image());
}

Result<Image> render_page(std::span<const StrokePtr> strokes, const PageOptions& options) {
  Result<PagePainter> page = PagePainter::create(ink_bounds(strokes), options);
  if (!page) return tl::unexpected(page.error());
  for (const StrokePtr& stroke : strokes) page->draw(*stroke);
  return std::move(page->image());
}

}  // namespace felt
