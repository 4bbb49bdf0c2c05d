// bench_materials [FILE [PICTURE]]: writes to FILE (docs/materials.md) what the surfaces feel like,
// which takes about a minute. Writes to PICTURE (docs/images/surfaces.png) how the media look on
// them. Crayon and wet ink go to a second picture with "-wet" in its name. "" as FILE or PICTURE
// skips it.
// Uses virtual time, so the figures are the same on a busy machine.
#include <cstdio>
#include <fstream>
#include <span>
#include <string>
#include <string_view>

#include "chart.h"
#include "felt/io/picture/png.h"
#include "tests/drawing/materials/materials_report.h"

namespace {

bool draw(const std::string& path, std::span<const std::string_view> media) {
  const auto chart = felt::bench::draw_chart(media);
  const auto written = chart ? felt::write_png(path, *chart, 0.0)
                             : felt::Result<void>(tl::unexpected(chart.error()));
  if (!written) std::fprintf(stderr, "bench_materials: %s\n", written.error().message.c_str());
  if (written) std::printf("%s\n", path.c_str());
  return written.has_value();
}

}  // namespace

int main(int argc, char** argv) {
  constexpr std::string_view kDry[] = {"pencil-hard", "pencil", "pencil-soft", "charcoal", "chalk"};
  constexpr std::string_view kWet[] = {"crayon", "felt-tip", "ink-pen", "brush-pen"};
  if (argc > 3 || (argc > 1 && argv[1][0] == '-')) {
    std::fputs("usage: bench_materials [FILE [PICTURE]]\n", stderr);
    return 2;
  }
  const std::string path = argc > 1 ? argv[1] : "docs/materials.md";
  const std::string picture = argc > 2 ? argv[2] : "docs/images/surfaces.png";
  if (!picture.empty()) {
    const std::string second = picture.substr(0, picture.rfind('.')) + "-wet.png";
    if (!draw(picture, kDry) || !draw(second, kWet)) return 1;
  }
  if (path.empty()) return 0;
  std::ofstream out(path, std::ios::binary);
  out << felt::materials_report();
  out.close();
  if (!out) {
    std::fprintf(stderr, "bench_materials: cannot write %s\n", path.c_str());
    return 1;
  }
  std::printf("%s\n", path.c_str());
  return 0;
}
