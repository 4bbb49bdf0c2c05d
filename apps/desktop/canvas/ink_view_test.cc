#include "desktop/canvas/ink_view.h"

#include <gtest/gtest.h>

#include <QImage>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "felt/document/edit_builder.h"
#include "felt/document/random_document.h"
#include "felt/render/raster.h"

namespace felt::desktop {
namespace {

constexpr QSize kSize(300, 220);

/// What `ink` is to look like: every stroke that is seen, drawn straight, one after another.
QImage drawn_straight(const Document& document, const QTransform& to_px, double dpr, bool outline,
                      QSize size = kSize) {
  QImage image(size * dpr, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  const Pixels pixels{image.bits(), image.width(), image.height(), image.bytesPerLine(),
                      PixelOrder::kBgra};
  const QPointF origin = to_px.inverted().map(QPointF(0, 0));
  const double scale = std::sqrt(std::fabs(to_px.determinant()));
  const bool mirrored = to_px.determinant() < 0.0;
  const double x = (mirrored ? -1.0 : 1.0) * to_px.m11() / scale;
  const View view{{origin.x(), origin.y()}, scale * dpr, {x, to_px.m12() / scale}, mirrored};
  Rasterizer rasterizer;
  for (const Layer& layer : document.layers()) {
    if (!layer.visible) continue;
    for (const StrokeId id : layer.strokes) {
      if (outline) {
        rasterizer.draw_center_line(*document.find(id), view, pixels.rect(), std::max(1.0, dpr),
                                    pixels);
      } else {
        rasterizer.draw(*document.find(id), view, pixels.rect(), pixels);
      }
    }
  }
  image.setDevicePixelRatio(dpr);
  return image;
}

QImage painted(InkView& ink, double dpr, QSize size = kSize) {
  QImage image(size * dpr, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  image.setDevicePixelRatio(dpr);
  QPainter painter(&image);
  ink.paint(painter, QRect({0, 0}, size));
  return image;
}

struct Difference {
  int worst = 0;
  int pixels = 0;  // that differ by more than 2
};

Difference difference(const QImage& a, const QImage& b) {
  Difference result;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      int here = 0;
      const uchar* p = a.constScanLine(y) + 4 * x;
      const uchar* q = b.constScanLine(y) + 4 * x;
      for (int k = 0; k < 4; ++k) here = std::max(here, std::abs(p[k] - q[k]));
      result.worst = std::max(result.worst, here);
      if (here > 2) ++result.pixels;
    }
  }
  return result;
}

Document seen_by(const Document& document, const std::optional<Edit>& preview) {
  Document seen = document;
  if (preview) {
    EXPECT_TRUE(seen.apply(*preview));
  }
  return seen;
}

CanvasView random_view(testing::RandomStroke& random) {
  CanvasView view;
  view.set_size(kSize);
  view.set_scale(random.chance(0.1) ? random.uniform(0.02, 400.0) : random.uniform(2.0, 25.0));
  view.center_on({random.uniform(0, 20), random.uniform(0, 20)});
  if (random.chance(0.5)) view.set_angle(random.uniform(-180, 180));
  if (random.chance(0.3)) view.mirror();
  return view;
}

/// Random documents, edits and previews in random views: what is kept up to date piece by piece
/// looks like what is drawn anew.
TEST(InkView, IncrementalPictureIsTheFullOne) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    testing::RandomEdits edits(seed);
    testing::RandomStroke random(seed);
    const double dpr = std::array{1.0, 1.5, 2.0}[seed % 3];
    Document document;
    InkView ink;
    ink.set_document(document);
    CanvasView view = random_view(random);
    ink.set_view(view, dpr);
    for (int step = 0; step < 25; ++step) {
      SCOPED_TRACE("step " + std::to_string(step));
      std::optional<Edit> preview;
      if (random.chance(0.8)) {
        const Edit edit = edits.next(document);
        ASSERT_TRUE(document.apply(edit));
        ink.apply(edit);
      }
      for (int n = random.pick(0, 3); n > 0; --n) {
        preview = edits.next(document);
        ink.show(preview);
        if (random.chance(0.5)) ink.finish();
      }
      if (!preview) ink.show(preview);
      if (random.chance(0.3)) {
        view = random_view(random);
        ink.set_view(view, dpr);
      } else if (random.chance(0.4)) {
        view.pan({random.uniform(-200, 200), random.uniform(-200, 200)});
        ink.set_view(view, dpr);
      }
      ink.finish();
      const Difference found =
          difference(painted(ink, dpr),
                     drawn_straight(seen_by(document, preview), ink.transform(), dpr, false));
      EXPECT_LE(found.worst, 2) << found.pixels << " pixels, " << view.px_per_mm() << " px/mm, dpr "
                                << dpr << (preview ? ", previewed" : "");
    }
  }
}

}  // namespace
}  // namespace felt::desktop
