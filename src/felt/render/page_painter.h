#pragma once

#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "felt/base/result.h"
#include "felt/document/document.h"
#include "felt/render/grain.h"
#include "felt/render/image.h"
#include "felt/render/picture_pixels.h"
#include "felt/render/raster.h"
#include "felt/render/view.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// How a picture of a sketch looks.
struct PageOptions {
  double dpi = 300.0;
  /// The part of the page to show. If not set, the picture shows all ink and a margin around it.
  std::optional<Rect> area{};
  double margin_mm = 5.0;
  Rgba paper{255, 255, 255, 255};  ///< alpha 0 gives a transparent picture
  Grain grain{};                   ///< the look of media on the surface; by default, solid ink
};

/// Returns the bounds of all ink; empty if `strokes` is empty.
Rect ink_bounds(std::span<const StrokePtr> strokes) noexcept;

/// Returns the area that the options show: `area` if it is set, or the ink and its margin. If there
/// is no ink, returns a square that reaches one margin from the origin in each direction.
Rect page_area(const Rect& ink, const PageOptions& options) noexcept;

/// Draws strokes one by one on a page.
class PagePainter {
 public:
  /// Prepares a page that shows page_area(ink, options). Fails if an option is out of range (0 <
  /// dpi <= 100000, 0 <= margin_mm <= 10000), if the area is empty or not finite, or if the picture
  /// is larger than Image::kMaxPixels.
  static Result<PagePainter> create(const Rect& ink, const PageOptions& options);

  /// Draws a stroke on top of the others.
  void draw(const Stroke& stroke);
  /// Draws the visible layers of a document with their opacities, blend modes and groups, and these
  /// pictures. Fails if a picture is damaged, or if the memory limit of Image does not allow a
  /// layer or group that is drawn as a whole.
  Result<void> draw(const Document& document, PictureChoice pictures);
  [[nodiscard]] const View& view() const noexcept { return view_; }
  [[nodiscard]] Image& image() noexcept { return image_; }

 private:
  Result<void> draw_layers(const Document& document, std::span<const Layer> layers,
                           PictureChoice pictures, Pixels target);
  Result<void> draw_layer(const Document& document, const Layer& layer, const LayerPicture* picture,
                          Pixels target);
  PagePainter(Image image, const View& view, Grain grain)
      : image_(std::move(image)), view_(view), grain_(std::move(grain)) {}

  Image image_;
  View view_;
  Grain grain_;
  Rasterizer rasterizer_;
  // The picture that was drawn last, because many layers may show the same one.
  std::shared_ptr<const PictureData> decoded_of_;
  std::shared_ptr<const PicturePixels> decoded_;
};

/// Returns a picture of the visible layers of a document, with these pictures in them. Fails like
/// PagePainter::create and PagePainter::draw.
Result<Image> render_page(const Document& document, const PageOptions& options,
                          PictureChoice pictures);

/// Returns a picture of the strokes in their order. Fails like PagePainter::create.
Result<Image> render_page(std::span<const StrokePtr> strokes, const PageOptions& options);

}  // namespace felt
