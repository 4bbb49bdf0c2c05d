/// Checks that Xournal++ opens our .xopp files and draws them as we do.

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "felt/base/read_file.h"
#include "felt/document/visible_strokes.h"
#include "felt/io/drawing_builder.h"
#include "felt/io/picture/png.h"
#include "felt/io/xopp/xopp_writer.h"
#include "felt/render/page_painter.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::xournalpp_test {
namespace {

namespace fs = std::filesystem;

constexpr double kDpi = 300.0;  // resolution of Xournal++'s pictures

bool has_xournalpp() {
  return std::system("command -v xournalpp >/dev/null 2>&1") == 0;
}

Drawing drawing() {
  DrawingBuilder builder;
  builder.drawing().has_page = true;
  builder.drawing().page = Page{60.0, 40.0};
  builder.add_layer({"below & <above>"});
  builder.add_layer({});
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    StrokeData data = testing::random_stroke(seed).data();
    for (Point& p : data.points) p += Vec{10.0 * static_cast<double>(seed), 8.0};
    data.color.a = 255;
    builder.add(seed % 2, Stroke::create(std::move(data)).value());
  }
  builder.add(1, testing::straight_stroke({5, 35}, {5.05, 35}, 2.0, 2.0));
  return std::move(builder).build();
}

/// Returns the picture that Xournal++ makes of a file.
Result<Image> xournalpp_picture(const std::string& bytes) {
  const fs::path folder = fs::temp_directory_path() / ("felt_xopp_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  std::ofstream(folder / "a.xopp", std::ios::binary) << bytes;
  const std::string command = "HOME=" + folder.string() +
                              " timeout 60 xournalpp --create-img=" + (folder / "a.png").string() +
                              " " + (folder / "a.xopp").string() + " >/dev/null 2>&1";
  const int code = std::system(command.c_str());
  Result<std::string> png = read_file((folder / "a.png").string(), std::size_t{1} << 28);
  fs::remove_all(folder);
  if (code != 0) return fail(ErrorCode::kIo, "xournalpp failed");
  if (!png) return tl::unexpected(png.error());
  Result<PngPicture> picture = decode_png(*png);
  if (!picture) return tl::unexpected(picture.error());
  return std::move(picture->image);
}

/// Returns the grey value of a pixel on white, 0..255.
int grey(Image& image, int x, int y) {
  const Pixels pixels = image.pixels();
  const std::uint8_t* p = pixels.data + y * pixels.stride + 4 * x;
  return 255 - p[3] + (p[0] + p[1] + p[2]) / 3;
}

TEST(Xournalpp, DrawsWhatWeDraw) {
  if (!has_xournalpp()) GTEST_SKIP() << "xournalpp is not installed";
  const Drawing ink = drawing();
  Result<Image> theirs = xournalpp_picture(xopp_bytes(ink).value());
  ASSERT_TRUE(theirs) << theirs.error().message;
  Image ours = render_page(visible_strokes(ink.document),
                           {.dpi = kDpi, .area = ink.page.area(), .paper = ink.page.paper})
                   .value();
  ASSERT_NEAR(theirs->width(), ours.width(), 1);
  ASSERT_NEAR(theirs->height(), ours.height(), 1);
  double sum = 0.0;
  int count = 0, inked = 0, far = 0;
  for (int y = 0; y < std::min(ours.height(), theirs->height()); ++y) {
    for (int x = 0; x < std::min(ours.width(), theirs->width()); ++x) {
      const int a = grey(ours, x, y), b = grey(*theirs, x, y);
      sum += std::abs(a - b);
      ++count;
      inked += a < 128 ? 1 : 0;
      far += std::abs(a - b) > 128 ? 1 : 0;
    }
  }
  EXPECT_GT(inked, 10'000) << "there is ink to compare";
  EXPECT_LT(sum / count, 1.0) << "mean difference of 255";
  EXPECT_LT(far, inked / 200) << "pixels that differ by more than half";
}

TEST(Xournalpp, OpensAnEmptyDrawing) {
  if (!has_xournalpp()) GTEST_SKIP() << "xournalpp is not installed";
  EXPECT_TRUE(xournalpp_picture(xopp_bytes({}).value()));
}

}  // namespace
}  // namespace felt::xournalpp_test
