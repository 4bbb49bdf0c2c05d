// bench_looks [PICTURE]: draws the same strokes with our media and with presets of libmypaint,
// prints what it measures of them, and writes a chart with all of them side by side to PICTURE
// (docs/images/looks.png; "" for none).
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "artist.h"
#include "felt/io/picture/png.h"
#include "felt/render/plot_canvas.h"
#include "figures.h"

namespace felt::bench {
namespace {

constexpr double kDpi = 144.0;
constexpr int kHeadPx = 22;

struct Row {
  std::string medium;
  std::vector<std::string> presets;  // the first one is on the chart
};

std::vector<Row> rows() {
  return {{"pencil-hard", {"deevad/4H_pencil"}},
          {"pencil", {"deevad/2B_pencil", "ramon/B-pencil", "classic/pencil"}},
          {"pencil-soft", {"ramon/2B_pencil", "tanda/pencil-8b"}},
          {"charcoal", {"tanda/charcoal-03", "classic/charcoal", "tanda/charcoal-01"}},
          {"chalk", {"deevad/chalk"}},
          {"crayon", {"ramon/Pastel_1"}},
          {"brush-pen", {"ramon/PenBrush", "deevad/brush"}},
          {"ink-pen", {"classic/pen"}}};
}

void print_heading() {
  std::puts(
      "| medium | mid | full | tone at 0.1 0.3 0.5 0.7 0.9 | width mm | times | grain mm | second "
      "peak "
      "| edge mm | uneven | once twice back |");
  std::puts("|---|---|---|---|---|---|---|---|---|---|---|");
}

bool print(const Artist& artist) {
  const Result<LookFigures> made = measure(artist, kDpi);
  if (!made) {
    std::fprintf(stderr, "bench_looks: %s: %s\n", artist.name().c_str(),
                 made.error().message.c_str());
    return false;
  }
  const LookFigures& f = *made;
  std::printf("| %s | %.2f | %.2f |", artist.name().c_str(), f.mid_share, f.full_share);
  for (const double tone : f.tones) std::printf(" %.2f", tone);
  std::printf(" | %.2f to %.2f | %.1f | %.2f | %.2f at %.1f mm | %.2f | %.2f | %.2f %.2f %.2f |\n",
              f.thin_mm, f.broad_mm, f.broad_mm / f.thin_mm, f.grain_mm, f.second_peak, f.second_mm,
              f.edge_mm, f.unevenness, f.once, f.twice, f.back);
  return true;
}

void copy(const Image& from, Pixels to, int x0, int y0) {
  for (int y = 0; y < from.height() && y0 + y < to.height; ++y) {
    for (int x = 0; x < from.width() && x0 + x < to.width; ++x) {
      const Rgba pixel = from.at(x, y);
      std::uint8_t* p = to.data + (y0 + y) * to.stride + std::ptrdiff_t{4} * (x0 + x);
      p[0] = pixel.r;
      p[1] = pixel.g;
      p[2] = pixel.b;
      p[3] = pixel.a;
    }
  }
}

/// The part of the cell that the chart also shows at 400 %: where the hatching crosses.
constexpr double kDetailX = 7.0, kDetailY = 23.0, kDetailWide = 10.0, kDetailHigh = 8.0;
constexpr int kGapPx = 8;

/// Draws what one artist makes of the cell, and beside it the detail. Returns the width used.
Result<int> draw_cell(const Artist& artist, Pixels chart, int x, int y) {
  const TestPage cell = chart_cell();
  const Result<Image> usual = artist.draw(cell, kDpi);
  if (!usual) return tl::unexpected(usual.error());
  TestPage detail = cell;
  for (PenStroke& stroke : detail.strokes) {
    for (InkSample& s : stroke) s.position = s.position - Vec{kDetailX, kDetailY};
  }
  detail.width_mm = kDetailWide;
  detail.height_mm = kDetailHigh;
  const Result<Image> large = artist.draw(detail, 4.0 * kDpi);
  if (!large) return tl::unexpected(large.error());
  copy(*usual, chart, x, y + kHeadPx);
  copy(*large, chart, x + usual->width() + kGapPx, y + kHeadPx);
  PlotCanvas(chart, 1.0)
      .text({x + 20.0, y + 16.0}, artist.name(), {.size = 10.0, .color = {70, 74, 82, 255}});
  return usual->width() + large->width() + 3 * kGapPx;
}

/// Draws the chart: a row for each medium, ours on the left.
Result<Image> chart_of(const std::vector<std::vector<std::unique_ptr<Artist>>>& table) {
  const TestPage cell = chart_cell();
  const auto px = [](double mm) { return static_cast<int>(std::ceil(mm * kDpi / 25.4)); };
  const int wide = px(cell.width_mm) + px(4.0 * kDetailWide) + 3 * kGapPx;
  const int high = px(cell.height_mm) + kHeadPx;
  auto chart = Image::create(2 * wide, high * static_cast<int>(table.size()));
  if (!chart) return chart;
  fill(chart->pixels(), chart->pixels().rect(), {255, 255, 255, 255});
  int y = 0;
  for (const auto& row : table) {
    int x = 0;
    for (std::size_t i = 0; i < row.size() && i < 2; ++i) {
      const Result<int> used = draw_cell(*row[i], chart->pixels(), x, y);
      if (!used) return tl::unexpected(used.error());
      x += *used;
    }
    y += high;
  }
  return chart;
}

int run(const std::string& path) {
  std::vector<std::vector<std::unique_ptr<Artist>>> table;
  bool has_peers = false;
  for (const Row& row : rows()) {
    auto& artists = table.emplace_back();
    artists.push_back(our_medium(row.medium));
    for (const std::string& preset : row.presets) {
      if (auto peer = mypaint_preset(preset)) artists.push_back(std::move(peer));
    }
    has_peers = has_peers || artists.size() > 1;
  }
  if (!has_peers) {
    std::fputs("without libmypaint (packages libmypaint-dev, mypaint-brushes)\n", stderr);
  }
  print_heading();
  for (const auto& row : table) {
    for (const auto& artist : row) {
      if (!print(*artist)) return 1;
    }
  }
  if (path.empty()) return 0;
  const Result<Image> chart = chart_of(table);
  const Result<void> written =
      chart ? write_png(path, *chart, kDpi) : Result<void>(tl::unexpected(chart.error()));
  if (!written) std::fprintf(stderr, "bench_looks: %s\n", written.error().message.c_str());
  return written ? 0 : 1;
}

}  // namespace
}  // namespace felt::bench

int main(int argc, char** argv) {
  if (argc > 2 || (argc > 1 && argv[1][0] == '-')) {
    std::fputs("usage: bench_looks [PICTURE]\n", stderr);
    return 2;
  }
  return felt::bench::run(argc > 1 ? argv[1] : "docs/images/looks.png");
}
