#include "felt/io/picture/pdf_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "felt/base/atomic_file.h"
#include "felt/base/read_file.h"
#include "felt/document/edit_builder.h"
#include "felt/document/testing/random_fills.h"
#include "felt/document/testing/small_picture.h"
#include "felt/io/drawing_builder.h"
#include "felt/io/picture/png.h"
#include "felt/io/testing/test_drawings.h"
#include "felt/render/page_painter.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::pdf_writer_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

Drawing drawing_on_page(std::uint64_t seed, int count) {
  std::vector<Stroke> strokes;
  for (int i = 0; i < count; ++i) {
    StrokeData data =
        felt::testing::random_stroke(1000 * seed + static_cast<std::uint64_t>(i)).data();
    for (Point& p : data.points) p = {20.0 + p.x, 20.0 + p.y};
    strokes.push_back(Stroke::create(std::move(data)).value());
  }
  return testing::drawing_of(strokes);
}

/// Every object begins at the offset in the file's table.
TEST(PdfWriter, TheTableFindsEveryObject) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const std::string pdf = pdf_text(drawing_on_page(seed, static_cast<int>(seed)), {}).value();
    const std::size_t start = std::stoul(pdf.substr(pdf.rfind("startxref") + 10));
    ASSERT_EQ(pdf.substr(start, 5), "xref\n");
    const std::size_t first = pdf.find("65535 f \n", start) + 9;
    for (std::size_t i = 0; i < 5; ++i) {
      const std::size_t at = std::stoul(pdf.substr(first + 20 * i, 10));
      EXPECT_EQ(pdf.substr(at, 7), std::to_string(i + 1) + " 0 obj");
    }
    ASSERT_NE(pdf.find("/Length 5 0 R"), std::string::npos);
    const std::size_t length = std::stoul(pdf.substr(pdf.find("\n5 0 obj\n") + 9));
    const std::size_t stream = pdf.find("stream\n") + 7;
    EXPECT_EQ(pdf.substr(stream + length, 9), "endstream");
    EXPECT_EQ(pdf, pdf_text(drawing_on_page(seed, static_cast<int>(seed)), {}).value());
  }
}

TEST(PdfWriter, ThePageHasItsTrueSize) {
  const std::string pdf = pdf_text({}, {.area = Rect{0.0, 0.0, 210.0, 297.0}}).value();
  EXPECT_THAT(pdf, HasSubstr("/MediaBox [0 0 595.2756 841.8898 ]"));
}

TEST(PdfWriter, WhatCannotBeAPageIsAnError) {
  EXPECT_FALSE(pdf_text({}, {.area = Rect{0.0, 0.0, 6000.0, 10.0}}));
  EXPECT_FALSE(pdf_text({}, {.area = Rect{0.0, 0.0, 0.0, 10.0}}));
  EXPECT_FALSE(pdf_text({}, {.tolerance_mm = 0.0}));
}

/// The picture that another program makes of the file equals ours.
TEST(PdfWriter, AnotherProgramSeesTheSameInk) {
  if (std::system("pdftoppm -v >/dev/null 2>&1") != 0) {
    GTEST_SKIP() << "pdftoppm is not installed (package poppler-utils)";
  }
  std::string folder = (fs::temp_directory_path() / "felt-pdf-XXXXXX").string();
  ASSERT_NE(::mkdtemp(folder.data()), nullptr);
  constexpr double kDpi = 150.0;
  const Rect area{0.0, 0.0, 60.96, 60.96};  // 360 pixels
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    Drawing drawing = drawing_on_page(seed, 8);
    testing::RandomStroke random(seed);
    EditBuilder builder(drawing.document);
    for (int i = 0; i < 3; ++i) {
      builder.add_fill(drawing.document.layers()[0].id,
                       std::make_shared<const Fill>(testing::random_fill(random)));
    }
    ASSERT_TRUE(drawing.document.apply(std::move(builder).build("Fill")));
    const std::string pdf = folder + "/a.pdf";
    const Rgba paper{255, 250, 240, 255};
    ASSERT_TRUE(write_file(pdf, pdf_text(drawing, {.area = area, .paper = paper}).value()));
    ASSERT_EQ(
        std::system(("pdftoppm -r 150 -png -singlefile " + pdf + " " + folder + "/a").c_str()), 0);
    Result<PngPicture> theirs =
        decode_png(read_file(folder + "/a.png", std::size_t{1} << 26).value());
    ASSERT_TRUE(theirs);
    Image ours = render_page(drawing.document, {.dpi = kDpi, .area = area, .paper = paper},
                             PictureChoice::kMarked)
                     .value();
    ASSERT_EQ(theirs->image.width(), ours.width());
    ASSERT_EQ(theirs->image.height(), ours.height());
    double sum = 0.0;
    for (int y = 0; y < ours.height(); ++y) {
      for (int x = 0; x < ours.width(); ++x) {
        sum += std::abs(int{ours.at(x, y).r} - int{theirs->image.at(x, y).r});
      }
    }
    // Programs anti-alias edges differently; a shift by one pixel would be ten times as much.
    EXPECT_LT(sum / (ours.width() * ours.height()), 1.5) << "seed " << seed;
  }
  fs::remove_all(folder);
}

/// A picture lies below the strokes of its layer, where the document has it, with its opacity and
/// transparent pixels.
TEST(PdfWriter, AnotherProgramSeesTheSamePictures) {
  if (std::system("pdftoppm -v >/dev/null 2>&1") != 0) {
    GTEST_SKIP() << "pdftoppm is not installed (package poppler-utils)";
  }
  std::string folder = (fs::temp_directory_path() / "felt-pdf-XXXXXX").string();
  ASSERT_NE(::mkdtemp(folder.data()), nullptr);
  Image pixels = Image::create(40, 30).value();
  fill(pixels.pixels(), {0, 0, 40, 30}, {200, 40, 0, 255});
  fill(pixels.pixels(), {0, 0, 10, 10}, {0, 0, 255, 255});
  fill(pixels.pixels(), {30, 20, 40, 30}, {0, 0, 0, 0});
  auto data = make_picture_data(encode_png(pixels, 96.0).value()).value();
  DrawingBuilder builder;
  for (const Affine place : {Affine{0.5, 0, 0, 0.5, 5, 5}, Affine{0.3, 0.3, -0.3, 0.3, 40, 30}}) {
    LayerState state{"Photo"};
    state.opacity = place.b == 0.0 ? 1.0 : 0.5;
    state.picture = std::make_shared<const LayerPicture>(LayerPicture{data, place, true});
    builder.add_layer(std::move(state));
  }
  const Drawing drawing = std::move(builder).build();
  const Rect area{0.0, 0.0, 60.96, 60.96};
  const Rgba paper{255, 255, 255, 255};
  const std::string pdf = pdf_text(drawing, {.area = area, .paper = paper}).value();
  ASSERT_TRUE(write_file(folder + "/a.pdf", pdf));
  ASSERT_EQ(std::system(
                ("pdftoppm -r 150 -png -singlefile " + folder + "/a.pdf " + folder + "/a").c_str()),
            0);
  const Image theirs =
      decode_png(read_file(folder + "/a.png", std::size_t{1} << 26).value()).value().image;
  const Image ours = render_page(drawing.document, {.dpi = 150.0, .area = area, .paper = paper},
                                 PictureChoice::kMarked)
                         .value();
  ASSERT_EQ(theirs.width(), ours.width());
  double sum = 0.0;
  for (int y = 0; y < ours.height(); ++y) {
    for (int x = 0; x < ours.width(); ++x) {
      const Rgba a = ours.at(x, y), b = theirs.at(x, y);
      sum += std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b);
    }
  }
  // Only pixels at edges differ. Without the second picture, it would be more than 20.
  EXPECT_LT(sum / (ours.width() * ours.height()), 4.0);
  fs::remove_all(folder);
}

TEST(PdfWriter, TheSizeGrowsOnlyLinearlyWithTheNumberOfLayers) {
  const auto size_of = [](int layers) {
    DrawingBuilder builder;
    for (int i = 0; i < layers; ++i) {
      LayerState state{"Layer"};
      state.opacity = 0.5;
      builder.add(builder.add_layer(std::move(state)),
                  testing::straight_stroke({5.0, 5.0 + 0.1 * i}, {50.0, 5.0}, 1.0, 2.0));
    }
    return pdf_text(std::move(builder).build(), {}).value().size();
  };
  const std::size_t few = size_of(100), many = size_of(1000);
  EXPECT_LT(many, 11 * few);
}

TEST(PdfWriter, ADamagedPictureIsAnError) {
  auto data = std::make_shared<PictureData>(*testing::picture_data());
  data->png.resize(40);
  DrawingBuilder builder;
  LayerState state{"Photo"};
  state.picture =
      std::make_shared<const LayerPicture>(LayerPicture{data, {1, 0, 0, 1, 0, 0}, true});
  builder.add_layer(std::move(state));
  const auto pdf = pdf_text(std::move(builder).build(), {.area = Rect{0, 0, 20, 20}});
  ASSERT_FALSE(pdf);
  EXPECT_THAT(pdf.error().message, HasSubstr("layer \"Photo\""));
}

}  // namespace
}  // namespace felt::pdf_writer_test
