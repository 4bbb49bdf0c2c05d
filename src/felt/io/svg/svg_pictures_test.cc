// Pictures in SVG files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "felt/base/atomic_file.h"
#include "felt/base/base64.h"
#include "felt/document/testing/small_picture.h"
#include "felt/io/picture/png.h"
#include "felt/io/svg/svg_import.h"
#include "felt/io/svg/svg_limits.h"
#include "felt/io/svg/svg_writer.h"
#include "felt/io/testing/import_checks.h"
#include "felt/render/page_painter.h"

namespace felt::svg_pictures_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::notice_lines;

/// A picture of 2 x 1 pixels, red and blue.
std::string data_uri() {
  return "data:image/png;base64," + std::string(testing::kRedBluePng);
}

Imported read(const std::string& inside, const ImportOptions& options = {}) {
  return import_svg(
             "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' "
             "width='100mm' height='80mm' viewBox='0 0 100 80'>\n" +
                 inside + "</svg>",
             options)
      .value();
}

std::string image(const std::string& attributes, const std::string& href = data_uri()) {
  return "<image " + attributes + " xlink:href='" + href + "'/>";
}

/// Returns the first picture, or null.
const LayerPicture* picture_in(const Imported& imported) {
  for (const Layer& layer : imported.drawing.document.layers()) {
    if (layer.picture) return layer.picture.get();
  }
  return nullptr;
}

Rect box_of(const std::string& attributes) {
  const Imported imported = read(image(attributes));
  EXPECT_THAT(notice_lines(imported), IsEmpty()) << attributes;
  const LayerPicture* picture = picture_in(imported);
  return picture ? bounds_of(*picture) : Rect{};
}

void expect_box(const Rect& box, const Rect& expected) {
  EXPECT_NEAR(box.x0, expected.x0, 1e-9);
  EXPECT_NEAR(box.y0, expected.y0, 1e-9);
  EXPECT_NEAR(box.x1, expected.x1, 1e-9);
  EXPECT_NEAR(box.y1, expected.y1, 1e-9);
}

TEST(SvgImages, ArePlacedAsInSvg) {
  expect_box(box_of("x='10' y='20' width='40' height='20'"), {10, 20, 50, 40});
  expect_box(box_of("x='10' y='20' width='40' height='60'"), {10, 40, 50, 60});
  expect_box(box_of("width='40' height='60' preserveAspectRatio='xMinYMin'"), {0, 0, 40, 20});
  expect_box(box_of("width='40' height='60' preserveAspectRatio='none'"), {0, 0, 40, 60});
  expect_box(box_of("width='40'"), {0, 0, 40, 20});
  expect_box(box_of("height='40'"), {0, 0, 80, 40});
  expect_box(box_of(""), {0, 0, 2, 1});
  expect_box(box_of("style='width:8px' height='4'"), {0, 0, 8, 4});
  expect_box(box_of("width='4' height='2' transform='translate(30 30) rotate(90)'"),
             {28, 30, 30, 34});
  expect_box(box_of("width='4' height='2' transform='matrix(2 0 1 3 5 5)'"), {5, 5, 15, 11});
}

TEST(SvgImages, HaveTheirPositionInTheStackOfLayers) {
  const std::string rect = "<rect width='50' height='50' fill='#0f0'/>";
  const Imported imported = read(rect + image("id='photo' width='60' height='30' opacity='.5'") +
                                 "<path d='M0 5h20' stroke='#000' stroke-width='4'/>");
  const auto layers = imported.drawing.document.layers();
  ASSERT_EQ(layers.size(), 3U);
  EXPECT_EQ(layers[0].fills.size(), 1U);
  EXPECT_EQ(layers[1].name, "photo");
  EXPECT_EQ(layers[1].opacity, 0.5);
  EXPECT_TRUE(layers[1].picture && layers[1].picture->exported);
  EXPECT_EQ(layers[2].strokes.size(), 1U);
  const Image page = render_page(imported.drawing.document,
                                 {.dpi = 25.4, .area = Rect{0, 0, 100, 80}}, PictureChoice::kMarked)
                         .value();
  EXPECT_EQ(page.at(10, 20), (Rgba{128, 128, 0, 255})) << "the picture covers the area";
  EXPECT_EQ(page.at(10, 5), (Rgba{0, 0, 0, 255})) << "the line covers the picture";
}

TEST(SvgImages, OurOwnFilesReadBackWithThem) {
  DrawingBuilder builder;
  builder.drawing().has_page = true;
  LayerState state{"Ink", true, false, 0.5};
  state.picture = testing::red_blue_picture(10.0, 20.0);
  builder.add_layer(std::move(state));
  const Drawing drawing = std::move(builder).build();
  const std::string svg = svg_text(drawing, {.pictures = PictureChoice::kAll}).value();
  const Drawing back = import_svg(svg).value().drawing;
  ASSERT_EQ(back.document.layers().size(), 1U);
  const Layer& layer = back.document.layers()[0];
  EXPECT_EQ(layer.opacity, 0.5);
  ASSERT_TRUE(layer.picture);
  EXPECT_EQ(layer.picture->place, drawing.document.layers()[0].picture->place);
  EXPECT_EQ(layer.picture->data->png, testing::picture_data()->png);
}

// A hidden layer keeps its lines in a file, so it keeps its picture, too.
TEST(SvgImages, APictureOfAHiddenLayerReadsBack) {
  DrawingBuilder builder;
  LayerState state{"Ink", false, false, 1.0};
  state.picture = testing::red_blue_picture(10.0, 20.0);
  builder.add_layer(std::move(state));
  const Drawing drawing = std::move(builder).build();
  const std::string svg = svg_text(drawing, {.pictures = PictureChoice::kAll}).value();
  const Drawing back = import_svg(svg).value().drawing;
  ASSERT_EQ(back.document.layers().size(), 1U);
  EXPECT_FALSE(back.document.layers()[0].visible);
  EXPECT_TRUE(back.document.layers()[0].picture);
}

std::string notice_of(const std::string& inside, const ImportOptions& options = {}) {
  const Imported imported = read(inside, options);
  EXPECT_EQ(picture_in(imported), nullptr) << inside.substr(0, 100);
  return notice_lines(imported);
}

TEST(SvgImages, BadOnesAreSkippedWithTheReason) {
  const std::string size = "width='9' height='9'";
  EXPECT_THAT(notice_of(image(size, "")), HasSubstr("names no picture"));
  EXPECT_THAT(notice_of(image(size, "data:image/png;base64")), HasSubstr("URI is damaged"));
  EXPECT_THAT(notice_of(image(size, "data:image/png;base64,%%%%")), HasSubstr("base64 data"));
  EXPECT_THAT(notice_of(image(size, "data:,hello")), HasSubstr("unknown format"));
  EXPECT_THAT(notice_of(image(size, data_uri().substr(0, 60))), HasSubstr("was skipped"));
  EXPECT_THAT(notice_of(image(size, "data:image/jpeg;base64,/9j/4AAQSkZJRg==")),
              HasSubstr("a JPEG picture, which only the window can read"));
  EXPECT_THAT(notice_of(image(size, "https://example.org/a.png")), HasSubstr("another address"));
  EXPECT_THAT(notice_of(image(size, "file:///etc/a.png")), HasSubstr("another address"));
  EXPECT_THAT(notice_of(image(size, "a.png")), HasSubstr("'a.png', which is not opened"));
  EXPECT_THAT(notice_of(image("width='0' height='9'")), HasSubstr("width or height of 0"));
  EXPECT_THAT(notice_of(image("width='9' height='-9'")), HasSubstr("width or height of 0"));
  EXPECT_THAT(notice_of(image("width='1e9' height='1e9'")), HasSubstr("too large"));
  EXPECT_THAT(notice_of(image(size + " transform='scale(0)'")), HasSubstr("too small"));
  EXPECT_THAT(notice_of(image(size + " transform='translate(1e9)'")), HasSubstr("too far"));
  EXPECT_THAT(notice_of(image(size + " visibility='hidden'")), HasSubstr("hidden"));
  EXPECT_THAT(notice_of("<svg width='9' height='9'>" + image(size + " x='20'") + "</svg>"),
              HasSubstr("outside the frame"));
}

TEST(SvgImages, AnInvalidTransformIsIgnored) {
  const Imported imported = read(image("width='4' height='2' transform='scale(NaN)'"));
  EXPECT_THAT(notice_lines(imported), HasSubstr("invalid transform"));
  ASSERT_NE(picture_in(imported), nullptr);
  expect_box(bounds_of(*picture_in(imported)), {0, 0, 4, 2});
}

TEST(SvgImages, HugePicturesDoNotTakeMemoryOrTime) {
  // A PNG file that says it has 60000 x 60000 pixels, and one that has more than the whole budget.
  std::string png = testing::picture_data()->png;
  png.replace(16, 8, std::string("\0\0\xea\x60\0\0\xea\x60", 8));
  EXPECT_THAT(notice_of(image("width='9' height='9'", "data:;base64," + base64_text(png))),
              HasSubstr("1 to 8192 pixels"));
  std::string many;
  for (int i = 0; i < 300; ++i) many += image("width='9' height='9'");
  const Imported imported = read(many);
  EXPECT_THAT(notice_lines(imported), HasSubstr("200 pictures"));
  EXPECT_LE(imported.drawing.document.layers().size(), 201U);
}

TEST(SvgImages, LoosePaddingAndPercentsAreRead) {
  std::string loose = data_uri();
  while (loose.back() == '=') loose.pop_back();
  for (std::size_t at; (at = loose.find('+')) != std::string::npos;) loose.replace(at, 1, "%2B");
  EXPECT_NE(picture_in(read(image("width='9' height='9'", loose))), nullptr);
  EXPECT_NE(picture_in(read(image("width='9' height='9'", "\n " + data_uri() + "\n"))), nullptr);
}

/// Only files below the folder of the drawing are opened.
TEST(SvgImages, OtherFilesAreBelowTheFolder) {
  std::string folder = (fs::temp_directory_path() / "felt-svg-XXXXXX").string();
  ASSERT_NE(::mkdtemp(folder.data()), nullptr);
  const std::string inside = folder + "/in/", png = testing::picture_data()->png;
  fs::create_directories(inside + "sub");
  ASSERT_TRUE(write_file(folder + "/out.png", png));
  ASSERT_TRUE(write_file(inside + "a b.png", png));
  ASSERT_TRUE(write_file(inside + "sub/b.png", png));
  ASSERT_TRUE(write_file(inside + ".hidden.png", png));
  fs::create_symlink(folder + "/out.png", inside + "link.png");
  const ImportOptions options{.folder = inside};
  const auto is_read = [&](const std::string& href) {
    return picture_in(read(image("width='9' height='9'", href), options)) != nullptr;
  };
  EXPECT_TRUE(is_read("a%20b.png"));
  EXPECT_TRUE(is_read("sub/b.png"));
  EXPECT_TRUE(is_read("./sub/b.png"));
  // A query and a fragment are not a part of the name.
  EXPECT_TRUE(is_read("sub/b.png?x=1"));
  EXPECT_TRUE(is_read("sub/b.png#x"));
  EXPECT_TRUE(is_read("a%20b.png?x=1#y/../z"));
  ASSERT_TRUE(write_file(inside + "c?d#e.png", png));
  EXPECT_TRUE(is_read("c%3Fd%23e.png"));
  for (const std::string bad :
       {"../out.png", "sub/../../out.png", "link.png", ".hidden.png", "none.png", "sub", "?x=1",
        "sub/b.png%3Fx=1", "%2e%2e/out.png", "//host/a.png"}) {
    EXPECT_FALSE(is_read(bad)) << bad;
  }
  EXPECT_FALSE(is_read(folder + "/out.png"));
  EXPECT_FALSE(is_read(inside + "sub/b.png"));
  fs::remove_all(folder);
}

TEST(SvgImages, AProgramMayConvertOtherFormats) {
  ImportOptions options;
  options.to_png = [](std::string_view bytes, std::int64_t) -> Result<std::string> {
    EXPECT_TRUE(bytes.starts_with("\xff\xd8\xff"));
    return testing::picture_data()->png;
  };
  const std::string jpeg = image("width='4' height='2'", "data:image/jpeg;base64,/9j/4AAQSkZJRg==");
  EXPECT_NE(picture_in(read(jpeg, options)), nullptr);
  options.to_png = [](std::string_view, std::int64_t) -> Result<std::string> {
    return fail(ErrorCode::kInvalidData, "no");
  };
  EXPECT_THAT(notice_of(jpeg, options), HasSubstr("a JPEG picture that cannot be read"));
}

/// The converter must know the limit, because a small file may have very many pixels.
TEST(SvgImages, AConverterIsToldHowManyPixelsAreLeft) {
  ImportOptions options;
  std::vector<std::int64_t> left;
  options.to_png = [&left](std::string_view, std::int64_t max_pixels) -> Result<std::string> {
    left.push_back(max_pixels);
    if (left.size() > 1) return fail(ErrorCode::kLimitExceeded, "too large");
    return testing::picture_data()->png;
  };
  const std::string size = "width='4' height='2'";
  const Imported imported = read(image(size, "data:image/jpeg;base64,/9j/4AAQSkZJRg==") +
                                     image(size, "data:image/jpeg;base64,/9j/4AAQSkZJRgA="),
                                 options);
  EXPECT_THAT(
      left, ::testing::ElementsAre(limits::kMaxSvgPicturePixels, limits::kMaxSvgPicturePixels - 2));
  EXPECT_NE(picture_in(imported), nullptr);
  EXPECT_THAT(notice_lines(imported), HasSubstr("too many pixels"));
}

/// A folder for the pictures of a drawing. It is removed with all files.
struct PictureFolder {
  PictureFolder() { EXPECT_NE(::mkdtemp(path.data()), nullptr); }
  ~PictureFolder() { fs::remove_all(path); }
  PictureFolder(const PictureFolder&) = delete;
  PictureFolder& operator=(const PictureFolder&) = delete;

  std::string path = (fs::temp_directory_path() / "felt-svg-XXXXXX").string();
};

TEST(SvgImages, AFileWithSeveralNamesIsReadOnce) {
  const PictureFolder folder;
  ASSERT_TRUE(write_file(folder.path + "/a.jpg", "\xff\xd8\xff"));
  fs::create_symlink("a.jpg", folder.path + "/link.jpg");
  int conversions = 0;
  ImportOptions options{.folder = folder.path};
  options.to_png = [&conversions](std::string_view, std::int64_t) -> Result<std::string> {
    ++conversions;
    return testing::picture_data()->png;
  };
  std::string images;
  for (const char* name : {"a.jpg", "./a.jpg", "%61.jpg", ".//a.jpg", "link.jpg"}) {
    images += image("width='4' height='2'", name);
  }
  const Imported imported = read(images, options);
  EXPECT_EQ(conversions, 1);
  const std::span<const Layer> layers = imported.drawing.document.layers();
  ASSERT_EQ(layers.size(), 5U) << notice_lines(imported);
  for (const Layer& layer : layers) {
    ASSERT_TRUE(layer.picture);
    EXPECT_EQ(layer.picture->data, layers[0].picture->data);
  }
}

TEST(SvgImages, OtherFilesHaveABudgetOfBytes) {
  const PictureFolder folder;
  std::string images;
  for (int i = 0; i < 6; ++i) {
    const std::string name = "big" + std::to_string(i) + ".png";
    ASSERT_TRUE(write_file(folder.path + '/' + name, "\x89PNG\r\n\x1a\n"));
    fs::resize_file(folder.path + '/' + name, PictureData::kMaxBytes);
    images += image("width='4' height='2'", name);
  }
  EXPECT_THAT(notice_of(images, {.folder = folder.path}),
              HasSubstr("pictures in other files are larger than 256 MiB together"));
}

}  // namespace
}  // namespace felt::svg_pictures_test
