#include "felt/render/page_painter.h"

#include <cmath>
#include <optional>

#include "felt/document/visible_strokes.h"
#include "felt/render/picture_pixels.h"

#include "felt/document/visible_strokes.h"

namespace felt {
namespace {

constexpr double kFinestDpi = 100'000.0;
constexpr double kWidestMarginMm = 10'000.0;
constexpr Rgba kWhite{255, 255, 255,
                      255};  // the page has its paper: where it has none, CSS applies

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

Result<void> PagePainter::draw(const Document& document, PictureChoice pictures) {
  const std::span<const Layer> layers = document.layers();
  for (std::size_t i = 0; i < layers.size();) {
    const LayerGroupPtr& group = layers[i].group;
    std::size_t end = i + 1;
    while (end < layers.size() && same_group(group, layers[end].group)) ++end;
    const std::span<const Layer> part = layers.subspan(i, end - i);
    i = end;
    if (!group || !group->is_whole() || !group->visible) {
      if (auto ok = draw_layers(document, part, pictures, image_.pixels()); !ok) return ok;
      continue;
    }
    Result<Image> whole = Image::create(image_.width(), image_.height());
    if (!whole) return tl::unexpected(whole.error());
    const Pixels pixels = whole->pixels();
    if (auto ok = draw_layers(document, part, pictures, pixels); !ok) return ok;
    blend(pixels, pixels.rect(), group->opacity, group->blend, kWhite, image_.pixels());
  }
  return {};
}

Result<void> PagePainter::draw_layers(const Document& document, std::span<const Layer> layers,
                                      PictureChoice pictures, Pixels target) {
  for (const Layer& layer : layers) {
    if (!layer.visible) continue;
    const LayerPicture* picture = exported_picture(layer, pictures);
    if (layer.strokes.empty() && layer.fills.empty() && !picture) continue;
    if (auto ok = draw_layer(document, layer, picture, target); !ok) {
      return tl::unexpected(with_context(ok.error(), "layer \"" + layer.name + '"'));
    }
  }
  return {};
}

Result<void> PagePainter::draw_layer(const Document& document, const Layer& layer,
                                     const LayerPicture* picture, Pixels target) {
  const bool has_ink = !layer.strokes.empty() || !layer.fills.empty();
  const bool is_whole = layer.blend != BlendMode::kNormal || (layer.opacity < 1.0 && has_ink);
  std::optional<Image> whole;
  if (is_whole) {
    Result<Image> made = Image::create(image_.width(), image_.height());
    if (!made) return tl::unexpected(made.error());
    whole = *std::move(made);
  }
  const Pixels pixels = whole ? whole->pixels() : target;
  if (picture) {
    if (!decoded_of_ || (decoded_of_ != picture->data && *decoded_of_ != *picture->data)) {
      decoded_ = nullptr;
      decoded_of_ = nullptr;
      const auto decoded = PicturePixels::decode(*picture->data);
      if (!decoded) return tl::unexpected(decoded.error());
      decoded_of_ = picture->data;
      decoded_ = *decoded;
    }
    decoded_->draw(picture->place, view_, pixels.rect(), is_whole ? 1.0 : layer.opacity, pixels);
  }
  for (const FillId id : layer.fills) {
    rasterizer_.draw_fill(*document.find_fill(id), view_, pixels.rect(), pixels);
  }
  for (const StrokeId id : layer.strokes) {
    rasterizer_.draw(*document.find(id), view_, pixels.rect(), grain_, pixels);
  }
  if (whole) blend(pixels, pixels.rect(), layer.opacity, layer.blend, kWhite, target);
  return {};
}

Result<Image> render_page(const Document& document, const PageOptions& options,
                          PictureChoice pictures) {
  return PagePainter::create(ink_bounds(document), options)
      .and_then([&](PagePainter page) -> Result<Image> {
        if (auto ok = page.draw(document, pictures); !ok) return tl::unexpected(ok.error());
        return std::move(page.image());
      });
}

Result<Image> render_page(std::span<const StrokePtr> strokes, const PageOptions& options) {
  Result<PagePainter> page = PagePainter::create(ink_bounds(strokes), options);
  if (!page) return tl::unexpected(page.error());
  for (const StrokePtr& stroke : strokes) page->draw(*stroke);
  return std::move(page->image());
}

}  // namespace felt
