#include "desktop/canvas/ink_view.h"

#include <gtest/gtest.h>

#include <QImage>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "felt/document/edit_builder.h"
#include "felt/document/testing/random_document.h"
#include "felt/render/picture_pixels.h"
#include "felt/render/raster.h"

namespace felt::desktop::ink_view_test {
namespace {

constexpr QSize kSize(300, 220);

/// Draws the strokes of a layer one after the other over its picture.
void draw_layer(const Document& document, const Layer& layer, const View& view, double hair_px,
                Pixels to) {
  Rasterizer rasterizer;
  if (layer.picture) {
    const auto picture = PicturePixels::decode(*layer.picture->data).value();
    picture->draw(layer.picture->place, view, to.rect(), 1.0, to);
  }
  for (const FillId id : layer.fills) {
    if (hair_px > 0.0) break;
    rasterizer.draw_fill(*document.find_fill(id), view, to.rect(), to);
  }
  for (const StrokeId id : layer.strokes) {
    if (hair_px > 0.0) {
      rasterizer.draw_center_line(*document.find(id), view, to.rect(), hair_px, to);
    } else {
      rasterizer.draw(*document.find(id), view, to.rect(), to);
    }
  }
}

/// Returns the expected picture, in which all visible layers are drawn directly, one after the
/// other, each layer and each group as a whole.
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
  constexpr Rgba kPaper{255, 255, 255, 255};
  QImage group_image = image;
  const auto layers = document.layers();
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const Layer& layer = layers[i];
    const bool in_group = layer.group && layer.group->is_whole();
    if (i == 0 || !same_group(layers[i - 1].group, layer.group)) group_image.fill(Qt::transparent);
    Pixels under = pixels;
    if (in_group) under.data = group_image.bits();
    if (layer.visible) {
      QImage whole = image;
      whole.fill(Qt::transparent);
      const bool is_whole = layer.opacity < 1.0 || layer.blend != BlendMode::kNormal;
      Pixels to = under;
      if (is_whole) to.data = whole.bits();
      draw_layer(document, layer, view, outline ? std::max(1.0, dpr) : 0.0, to);
      if (is_whole) blend(to, pixels.rect(), layer.opacity, layer.blend, kPaper, under);
    }
    if (in_group && (i + 1 == layers.size() || !same_group(layers[i + 1].group, layer.group))) {
      blend(under, pixels.rect(), layer.group->opacity, layer.group->blend, kPaper, pixels);
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
  int pixels = 0;  // number of pixels that differ by more than 2
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

/// For random documents, edits, previews and views, the incremental picture equals that of a full
/// repaint.
TEST(InkView, IncrementalPictureIsTheFullOne) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
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

StrokePtr line(Point a, Point b, double width, Rgba color = {0, 0, 0, 255}) {
  StrokeData data = testing::straight_stroke(a, b, width, width).data();
  data.color = color;
  return std::make_shared<const Stroke>(Stroke::create(std::move(data)).value());
}

/// Returns parallel lines across the view, some of them transparent, and a line that crosses all of
/// them. Half of the parallel lines are above this line and half below it.
Document lattice(int lines) {
  Document document;
  EditBuilder builder(document);
  for (int i = 0; i < lines; ++i) {
    const double x = 2.0 + 26.0 * i / lines;
    const auto shade = static_cast<std::uint8_t>(20 * (i % 8));
    if (i == lines / 2) {
      builder.add({1}, line({1, 10}, {29, 12}, 2.0, {200, 0, 0, 160}));
    } else {
      builder.add({1}, line({x, 1}, {x, 20}, 0.8,
                            {0, shade, 120, static_cast<std::uint8_t>(i % 3 == 0 ? 255 : 110)}));
    }
  }
  EXPECT_TRUE(document.apply(std::move(builder).build("Draw")));
  return document;
}

CanvasView view_of_lattice() {
  CanvasView view;
  view.set_size(kSize);
  view.set_scale(10.0);
  view.center_on({15, 11});
  return view;
}

TEST(InkView, WhatWasShownStaysWhenItIsCommittedInEveryFrame) {
  Document document = lattice(90);
  InkView ink;
  ink.set_document(document);
  ink.set_view(view_of_lattice(), 1.0);
  ink.finish();
  const StrokeId id = document.layers()[0].strokes[45];
  Edit edit;
  for (int sample = 1; sample <= 20; ++sample) {
    EditBuilder builder(document);
    builder.replace(id, line({1, 10}, {29, 12.0 - 0.4 * sample}, 2.0, {200, 0, 0, 160}));
    edit = std::move(builder).build("Pull");
    ink.show(edit);
    ink.finish();
    EXPECT_LE(difference(painted(ink, 1.0),
                         drawn_straight(seen_by(document, edit), ink.transform(), 1.0, false))
                  .worst,
              4)
        << sample;
  }
  const QImage shown = painted(ink, 1.0);
  ASSERT_TRUE(document.apply(edit));
  ink.apply(edit);
  ink.show(std::nullopt);
  for (int frame = 0; frame < 20; ++frame) {
    EXPECT_LE(difference(painted(ink, 1.0), shown).worst, 4) << "frame " << frame;
  }
  ink.finish();
  const QImage full = drawn_straight(document, ink.transform(), 1.0, false);
  EXPECT_LE(difference(painted(ink, 1.0), full).worst, 2);
}

/// The next frame contains the new stroke, even if the worker is busy.
TEST(InkView, AStrokeIsSeenAsSoonAsItIsThere) {
  Document document = lattice(30);
  InkView ink;
  ink.set_document(document);
  ink.set_view(view_of_lattice(), 1.0);
  ink.finish();
  for (int round = 0; round < 5; ++round) {
    EditBuilder many(document);
    for (int i = 0; i < 400; ++i) {
      many.add({1}, line({1.0 + 0.05 * i, 1}, {28.0 - 0.05 * i, 20}, 0.3, {0, 0, 90, 120}));
    }
    const Edit paste = std::move(many).build("Paste");
    ASSERT_TRUE(document.apply(paste));
    ink.apply(paste);
    EditBuilder one(document);
    const double y = 3.0 + 3.0 * round;
    one.add({1}, line({2, y}, {28, y}, 1.0));
    const Edit draw = std::move(one).build("Draw");
    ASSERT_TRUE(document.apply(draw));
    QRect changed;
    const auto reported = QObject::connect(&ink, &InkView::changed,
                                           [&changed](const QRect& part) { changed |= part; });
    ink.apply(draw);
    QObject::disconnect(reported);
    const QPoint middle = ink.transform().map(QPointF(15, y)).toPoint();
    EXPECT_TRUE(changed.contains(middle));
    EXPECT_EQ(painted(ink, 1.0).pixelColor(middle), QColor(Qt::black)) << "round " << round;
  }
  ink.finish();
  InkView anew;
  anew.set_document(document);
  anew.set_view(view_of_lattice(), 1.0);
  anew.finish();
  EXPECT_LE(difference(painted(ink, 1.0), painted(anew, 1.0)).worst, 2);
}

TEST(InkView, OldTilesStandInUntilTheNewOnesAreThere) {
  Document document;
  EditBuilder builder(document);
  builder.add({1}, line({15, 11}, {15, 12}, 60.0));
  ASSERT_TRUE(document.apply(std::move(builder).build("Draw")));
  InkView ink;
  ink.set_document(document);
  CanvasView view = view_of_lattice();
  ink.set_view(view, 1.0);
  ink.finish();
  for (int step = 0; step < 20; ++step) {
    view.zoom(step % 2 == 0 ? 1.3 : 0.9, {150, 110});
    view.turn(7.0, {150, 110});
    ink.set_view(view, 1.0);
    EXPECT_EQ(painted(ink, 1.0).pixelColor(150, 110), QColor(Qt::black)) << step;
  }
  ink.finish();
  EXPECT_EQ(ink.missing_tiles(), 0);
}

TEST(InkView, AnotherDocumentLeavesNothingOfTheOldOne) {
  InkView ink;
  ink.set_view(view_of_lattice(), 1.0);
  for (int round = 0; round < 6; ++round) {
    const Document document = round % 2 == 0 ? lattice(20 + round) : Document();
    ink.set_document(document);
    if (round % 3 != 0) ink.finish();
    const QImage now = painted(ink, 1.0);
    ink.finish();
    const QImage full = drawn_straight(document, ink.transform(), 1.0, false);
    EXPECT_LE(difference(painted(ink, 1.0), full).worst, 2);
    if (round % 2 == 1) {
      EXPECT_EQ(now, full);
    }
  }
}

TEST(InkView, OutlinesAndGrainAreThoseOfTheRasteriser) {
  const Document document = lattice(20);
  InkView ink;
  ink.set_document(document);
  CanvasView view = view_of_lattice();
  view.set_angle(30);
  ink.set_view(view, 2.0);
  ink.set_outline_mode(true);
  ink.finish();
  EXPECT_LE(
      difference(painted(ink, 2.0), drawn_straight(document, ink.transform(), 2.0, true)).worst, 2);
  ink.set_outline_mode(false);
  ink.finish();
  EXPECT_LE(
      difference(painted(ink, 2.0), drawn_straight(document, ink.transform(), 2.0, false)).worst,
      2);
}

TEST(InkView, TheEndsOfTheWorldAndAnEmptyWidget) {
  for (const double px_per_mm : {CanvasView::kMinPxPerMm, CanvasView::kMaxPxPerMm}) {
    const Document document = lattice(30);
    InkView ink;
    ink.set_document(document);
    CanvasView view = view_of_lattice();
    view.set_scale(px_per_mm);
    for (const Point at : {Point{15, 11}, Point{1e7, -1e7}, Point{-1e13, 1e13}, Point{15, 11}}) {
      view.center_on(at);
      ink.set_view(view, 2.0);
      ink.finish();
      const QImage picture = painted(ink, 2.0);
      if (at.x != 15) {
        EXPECT_EQ(picture.pixelColor(100, 100).alpha(), 0);
      }
    }
    EXPECT_LE(
        difference(painted(ink, 2.0), drawn_straight(document, ink.transform(), 2.0, false)).worst,
        2);
    view.set_size({0, 0});
    ink.set_view(view, 2.0);
    ink.finish();
    static_cast<void>(painted(ink, 2.0));
  }
}

/// The worker can be destroyed at any time, whatever work is in progress.
TEST(InkView, EndsInTheMiddle) {
  const Document document = lattice(200);
  for (int round = 0; round < 60; ++round) {
    InkView ink;
    if (round % 4 == 0) continue;
    ink.set_document(document);
    CanvasView view = view_of_lattice();
    view.set_scale(5.0 + round);
    ink.set_view(view, 1.0);
    if (round % 4 == 2) static_cast<void>(painted(ink, 1.0));
    if (round % 4 == 3) {
      EditBuilder builder(document);
      builder.remove(document.layers()[0].strokes[static_cast<std::size_t>(round)]);
      ink.show(std::move(builder).build("Erase"));
    }
  }
}

}  // namespace
}  // namespace felt::desktop::ink_view_test
