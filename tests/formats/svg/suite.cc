#include "tests/formats/svg/suite.h"

#include <algorithm>
#include <filesystem>

#include "felt/base/read_file.h"
#include "felt/io/picture/png.h"
#include "felt/io/svg/svg_import.h"
#include "felt/render/page_painter.h"
#include "tests/formats/svg/scene_picture.h"

namespace felt::testing {

namespace fs = std::filesystem;

namespace {

/// Returns true if a notice names content that lines and fillings cannot represent.
bool needs_more(const std::vector<std::string>& notices) {
  for (const std::string& notice : notices) {
    for (const char* what : {"is not a stroke", "gradient", "pattern", "clip path", "mask",
                             "filter", "not drawn by this test"}) {
      if (notice.find(what) != std::string::npos) return true;
    }
  }
  return false;
}

/// Imports a file and draws its fills and strokes. The page fills the width of the picture.
Result<Image> drawing_picture(const std::string& svg, int width_px, int height_px) {
  Result<Imported> read = import_svg(svg);
  if (!read) return tl::unexpected(read.error());
  Page page = read->drawing.page;
  if (!read->drawing.has_page) page = {width_px * 25.4 / 96.0, height_px * 25.4 / 96.0};
  const bool has_paper = page.paper != Page{}.paper;
  return render_page(read->drawing.document,
                     {.dpi = width_px * 25.4 / page.width_mm,
                      .area = page.area(),
                      .paper = has_paper ? page.paper : Rgba{0, 0, 0, 0}},
                     PictureChoice::kMarked);
}

}  // namespace

std::vector<std::string> suite_names(const std::string& root) {
  std::vector<std::string> names;
  if (!fs::is_directory(root)) return names;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root)) {
    fs::path path = entry.path();
    if (path.extension() != ".svg") continue;
    path.replace_extension(".png");
    if (!fs::exists(path)) continue;
    names.push_back(fs::relative(path.replace_extension(), root).string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

SuiteResult compare_pictures(const std::string& svg_path, const std::string& png_path,
                             const std::string& out, SuitePicture what) {
  constexpr std::size_t kMax = std::size_t{64} << 20;
  const Result<std::string> svg = read_file(svg_path, kMax), png = read_file(png_path, kMax);
  if (!svg) return {false, svg.error().message, false};
  if (!png) return {false, png.error().message, false};
  const Result<PngPicture> theirs = decode_png(*png);
  if (!theirs) return {false, theirs.error().message, false};
  const Result<PaintedScene> scene = paint_scene(*svg);
  if (!scene) return {false, scene.error().message, false};
  const Result<Image> ours =
      what == SuitePicture::kDrawing
          ? drawing_picture(*svg, theirs->image.width(), theirs->image.height())
          : scene_picture(*scene, theirs->image.width(), theirs->image.height());
  if (!ours) return {false, ours.error().message, false};
  const std::int64_t apart = pixels_apart(*ours, theirs->image);
  if (apart >= 0 && apart <= kPixelsAllowed) return {true, {}, needs_more(scene->notices)};
  if (!out.empty()) {
    std::string name = svg_path;
    std::replace(name.begin(), name.end(), '/', '_');
    fs::create_directories(out);
    static_cast<void>(write_png(out + "/" + name + ".ours.png", *ours, 96.0));
    static_cast<void>(write_png(out + "/" + name + ".theirs.png", theirs->image, 96.0));
  }
  std::string why = std::to_string(apart) + " pixels apart";
  for (const std::string& notice : scene->notices) why += "; " + notice;
  return {false, why, needs_more(scene->notices)};
}

SuiteResult compare_with_suite(const std::string& root, const std::string& name,
                               const std::string& out, SuitePicture what) {
  return compare_pictures(root + "/" + name + ".svg", root + "/" + name + ".png", out, what);
}

}  // namespace felt::testing
