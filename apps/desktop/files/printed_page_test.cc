#include "desktop/files/printed_page.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QImageReader>
#include <QPainter>
#include <QPrinter>
#include <cstdlib>
#include <functional>
#include <utility>

#include "desktop/files/output_actions.h"
#include "desktop/files/page_picture.h"
#include "desktop/files/testing/studio_fixture.h"
#include "felt/document/edit_builder.h"
#include "felt/document/testing/small_picture.h"
#include "felt/formats/drawing_grain.h"
#include "felt/io/picture/png.h"
#include "felt/render/view.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::desktop::printed_page_test {
namespace {

void paint_page(QPainter& painter, const Drawing& drawing, double dpi,
                const std::optional<Grain>& grain = {}) {
  const Result<PrintedPage> page = PrintedPage::create(drawing, dpi, grain);
  ASSERT_TRUE(page) << page.error().message;
  page->paint(painter, dpi);
}

/// Returns the page on white paper with one pixel per mm.
QImage printed(const Drawing& drawing) {
  QImage image(static_cast<int>(drawing.page.width_mm), static_cast<int>(drawing.page.height_mm),
               QImage::Format_RGBA8888_Premultiplied);
  image.fill(Qt::white);
  QPainter painter(&image);
  paint_page(painter, drawing, kMmPerInch);
  painter.end();
  return image;
}

/// Changes the state of the first layer of a drawing.
void set_layer(Drawing& drawing, const std::function<void(LayerState&)>& change) {
  const Layer& layer = drawing.document.layers()[0];
  LayerState state = layer.state();
  change(state);
  const Edit edit{"Layer", {}, {{layer.id, layer.state(), state, 0, 0}}};
  ASSERT_TRUE(drawing.document.apply(edit));
}

/// Returns a drawing of two lines that cross at (30, 20), in a layer with this opacity.
Drawing crossed_lines(double opacity) {
  Drawing drawing;
  drawing.page = {60.0, 40.0, {255, 255, 255, 255}};
  EditBuilder builder(drawing.document);
  for (const auto& [from, to] :
       {std::pair{Point{5, 20}, Point{55, 20}}, std::pair{Point{30, 5}, Point{30, 35}}}) {
    StrokeData data = testing::straight_stroke(from, to, 6.0, 6.0).data();
    data.medium = "ink-pen";
    builder.add(drawing.document.layers()[0].id,
                std::make_shared<const Stroke>(Stroke::create(std::move(data)).value()));
  }
  EXPECT_TRUE(drawing.document.apply(std::move(builder).build("Cross")));
  set_layer(drawing, [opacity](LayerState& state) { state.opacity = opacity; });
  return drawing;
}

/// Returns a page with a thin slanted line of a soft pencil, painted for `dpi` and shown with this
/// number of pixels per mm, as a preview shows it.
QImage preview_of_line(double dpi, double px_per_mm) {
  Drawing drawing;
  drawing.page = {60.0, 40.0, {255, 255, 255, 255}};
  StrokeData data = testing::straight_stroke({2, 5}, {58, 35}, 0.3, 0.3).data();
  data.medium = "pencil-soft";
  EditBuilder builder(drawing.document);
  builder.add(drawing.document.layers()[0].id,
              std::make_shared<const Stroke>(Stroke::create(std::move(data)).value()));
  EXPECT_TRUE(drawing.document.apply(std::move(builder).build("Draw")));
  QImage shown(static_cast<int>(60 * px_per_mm), static_cast<int>(40 * px_per_mm),
               QImage::Format_RGBA8888_Premultiplied);
  shown.fill(Qt::white);
  QPainter painter(&shown);
  painter.scale(px_per_mm * kMmPerInch / dpi, px_per_mm * kMmPerInch / dpi);
  paint_page(painter, drawing, dpi, grain_of(drawing).value());
  return shown;
}

/// Returns by which share of the ink a preview differs from a sharp picture that is made smaller.
double wrong_share_of_preview(double dpi) {
  const QImage shown = preview_of_line(dpi, 2.5);
  const QImage sharp = preview_of_line(dpi, 20.0).scaled(shown.size(), Qt::IgnoreAspectRatio,
                                                         Qt::SmoothTransformation);
  double wrong = 0.0, ink = 0.0;
  for (int y = 0; y < shown.height(); ++y) {
    for (int x = 0; x < shown.width(); ++x) {
      const int is = shown.pixelColor(x, y).lightness(), ought = sharp.pixelColor(x, y).lightness();
      wrong += std::abs(is - ought);
      ink += 255 - ought;
    }
  }
  return wrong / ink;
}

TEST(Print, APreviewShowsThinLinesWithoutSteps) {
  const double coarse = wrong_share_of_preview(100.0), fine = wrong_share_of_preview(300.0);
  EXPECT_LT(coarse, 0.7 * fine) << "pixels of a fine picture are left out: " << fine;
}

TEST(Print, ThePageIsPaintedAtItsTrueSize) {
  StudioFixture fixture;
  fixture.draw(3, 6);
  fixture.studio.set_page({60.0, 40.0, {255, 255, 255, 255}});
  const Drawing drawing = fixture.files->drawing();
  constexpr double kDpi = 254.0;  // ten pixels per mm
  QImage painted(600, 400, QImage::Format_RGBA8888_Premultiplied);
  painted.fill(Qt::white);
  QPainter painter(&painted);
  paint_page(painter, drawing, kDpi);
  painter.end();
  const QImage ours =
      page_picture(drawing.document, drawing.page.area(), 10.0, {255, 255, 255, 255});
  ASSERT_EQ(ours.size(), painted.size());
  double sum = 0.0;
  for (int y = 0; y < ours.height(); ++y) {
    for (int x = 0; x < ours.width(); ++x) {
      sum += std::abs(ours.pixelColor(x, y).green() - painted.pixelColor(x, y).green());
    }
  }
  EXPECT_LT(sum / (600 * 400), 1.0);
}

TEST(Print, FillsLieBelowTheLinesOfTheirLayer) {
  StudioFixture fixture;
  fixture.studio.set_page({60.0, 40.0, {255, 255, 255, 255}});
  Drawing drawing = fixture.files->drawing();
  FillLoop loop{{{10, 10}}, {}};
  for (const Point to : {Point{50, 10}, Point{50, 30}, Point{10, 30}, Point{10, 10}}) {
    loop.points.insert(loop.points.end(), {loop.points.back(), to, to});
  }
  EditBuilder builder(drawing.document);
  const LayerId layer = drawing.document.layers()[0].id;
  builder.add_fill(layer, std::make_shared<const Fill>(Fill{{loop}, {200, 40, 0, 255}, 0.0}));
  Stroke line = testing::straight_stroke({5, 20}, {55, 20}, 2.0, 2.0);
  builder.add(layer, std::make_shared<const Stroke>(std::move(line)));
  ASSERT_TRUE(drawing.document.apply(std::move(builder).build("Fill")));
  QImage painted(60, 40, QImage::Format_RGBA8888_Premultiplied);
  painted.fill(Qt::white);
  QPainter painter(&painted);
  paint_page(painter, drawing, 25.4);
  painter.end();
  EXPECT_EQ(painted.pixelColor(30, 15), QColor(200, 40, 0));
  EXPECT_NE(painted.pixelColor(30, 20), QColor(200, 40, 0)) << "the line is above";
  EXPECT_EQ(painted.pixelColor(5, 5), QColor(Qt::white));
}

TEST(Print, ShowsThePicturesThatAreMarkedForExport) {
  StudioFixture fixture;
  fixture.studio.set_page({60.0, 40.0, {255, 255, 255, 255}});
  Drawing drawing = fixture.files->drawing();
  const Layer& layer = drawing.document.layers()[0];
  const auto printed_at_12_5 = [&](bool exported) {
    LayerState state = layer.state();
    state.picture = std::make_shared<const LayerPicture>(
        LayerPicture{testing::picture_data(), {10, 0, 0, 10, 10, 0}, exported});
    Edit edit{"Picture", {}, {{layer.id, layer.state(), state, 0, 0}}};
    Document document = drawing.document;
    EXPECT_TRUE(document.apply(edit));
    Drawing with_picture = drawing;
    with_picture.document = document;
    QImage painted(60, 40, QImage::Format_RGBA8888_Premultiplied);
    painted.fill(Qt::white);
    QPainter painter(&painted);
    paint_page(painter, with_picture, 25.4);
    painter.end();
    EXPECT_EQ(painted.pixelColor(5, 5), QColor(Qt::white));
    return painted.pixelColor(12, 5);
  };
  EXPECT_EQ(printed_at_12_5(true), QColor(255, 0, 0));
  EXPECT_EQ(printed_at_12_5(false), QColor(Qt::white));
}

/// As on the screen, the strokes of a translucent layer do not show through each other.
TEST(Print, ATranslucentLayerIsPaintedAsAWhole) {
  const Drawing drawing = crossed_lines(0.5);
  const QImage page = printed(drawing);
  const QImage screen =
      page_picture(drawing.document, drawing.page.area(), 1.0, {255, 255, 255, 255});
  EXPECT_NEAR(page.pixelColor(10, 20).green(), 128, 2);
  for (const QPoint at : {QPoint(10, 20), QPoint(30, 10), QPoint(30, 20), QPoint(2, 2)}) {
    EXPECT_NEAR(page.pixelColor(at).green(), screen.pixelColor(at).green(), 2) << at.x();
  }
}

/// If the pictures of translucent layers would need too much memory, the page becomes one picture.
TEST(Print, ManyTranslucentLayersAreOnePicture) {
  Drawing drawing = crossed_lines(0.5);
  const Layer first = drawing.document.layers()[0];
  Edit edit{"Layers", {}, {}};
  for (std::uint64_t i = 0; i < 140; ++i) {
    const LayerId layer{100 + i};
    edit.layers.push_back({layer, std::nullopt, first.state(), 0, 1 + i});
    for (std::size_t k = 0; k < 2; ++k) {
      edit.changes.push_back({drawing.document.new_id(2 * i + k),
                              nullptr,
                              drawing.document.find(first.strokes[k]),
                              {},
                              {layer, k}});
    }
  }
  ASSERT_TRUE(drawing.document.apply(edit));
  const Result<PrintedPage> page = PrintedPage::create(drawing, 400.0);
  ASSERT_TRUE(page) << page.error().message;
  QImage image(60, 40, QImage::Format_RGBA8888_Premultiplied);
  image.fill(Qt::white);
  QPainter painter(&image);
  page->paint(painter, kMmPerInch);
  painter.end();
  EXPECT_LT(image.pixelColor(10, 20).green(), 4);
  EXPECT_EQ(image.pixelColor(2, 2), QColor(Qt::white));
}

/// Translucent paper is not painted twice.
TEST(Print, PaperIsPaintedOnce) {
  Drawing drawing = crossed_lines(1.0);
  drawing.page.paper = {200, 0, 0, 128};
  const QColor lines = printed(drawing).pixelColor(2, 2);
  set_layer(drawing, [](LayerState& state) { state.blend = BlendMode::kMultiply; });
  const QColor picture = printed(drawing).pixelColor(2, 2);
  EXPECT_NEAR(picture.red(), lines.red(), 2);
  EXPECT_NEAR(picture.green(), lines.green(), 2);
}

/// A picture of 1,000 x 1,000 pixels, damaged or not.
LayerPicturePtr large_picture(bool is_damaged) {
  Image pixels = Image::create(1000, 1000).value();
  fill(pixels.pixels(), pixels.pixels().rect(), {200, 40, 0, 255});
  std::string png = encode_png(pixels, 96.0).value();
  if (is_damaged) png.resize(png.size() / 2);
  return std::make_shared<const LayerPicture>(
      LayerPicture{make_picture_data(std::move(png)).value(), {0.03, 0, 0, 0.03, 5, 5}, true});
}

TEST(Print, ALargePictureIsPrinted) {
  Drawing drawing = crossed_lines(1.0);
  set_layer(drawing, [](LayerState& state) { state.picture = large_picture(false); });
  const int limit_mb = QImageReader::allocationLimit();
  QImageReader::setAllocationLimit(1);
  EXPECT_EQ(printed(drawing).pixelColor(8, 8), QColor(200, 40, 0));
  QImageReader::setAllocationLimit(limit_mb);
}

TEST(Print, ADamagedPictureIsReportedAndNothingIsPrinted) {
  StudioFixture fixture;
  OutputActions& output = *fixture.window.findChild<OutputActions*>();
  const auto print = [&](const Drawing& drawing) {
    QPrinter printer(QPrinter::ScreenResolution);
    printer.setOutputFormat(QPrinter::PdfFormat);
    printer.setOutputFileName(fixture.at("print.pdf"));
    return output.print_to(printer, drawing);
  };
  const auto none = [](LayerState&) {};
  const auto translucent = [](LayerState& state) { state.opacity = 0.5; };
  const auto blended = [](LayerState& state) { state.blend = BlendMode::kMultiply; };
  for (const std::function<void(LayerState&)>& change :
       {std::function<void(LayerState&)>(none), std::function<void(LayerState&)>(translucent),
        std::function<void(LayerState&)>(blended)}) {
    Drawing drawing = crossed_lines(1.0);
    set_layer(drawing, change);
    ASSERT_TRUE(print(drawing));
    EXPECT_TRUE(QFile::remove(fixture.at("print.pdf")));
    set_layer(drawing, [](LayerState& state) { state.picture = large_picture(true); });
    fixture.person->errors.clear();
    EXPECT_FALSE(print(drawing));
    EXPECT_FALSE(QFile::exists(fixture.at("print.pdf")));
    ASSERT_EQ(fixture.person->errors.size(), 1);
    EXPECT_TRUE(fixture.person->errors[0].contains(QStringLiteral("was not printed")));
    EXPECT_TRUE(fixture.person->errors[0].contains(QStringLiteral("layer \"Ink\"")));
  }
}

}  // namespace
}  // namespace felt::desktop::printed_page_test
