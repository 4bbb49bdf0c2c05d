// bench_sound [PICTURE]: prints the loudness and the pitch of pairs of medium and surface, and the
// cost of a sample of sound. Draws the spectrograms of the sounds to PICTURE
// (docs/images/sound.png). The figures of the sounds are the same on every run.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <string>

#include "felt/io/picture/png.h"
#include "felt/render/plot_canvas.h"
#include "felt/sound/testing/rubbed.h"
#include "spectrogram.h"

namespace felt::bench {
namespace {

constexpr double kSeconds = 1.0;  // duration of a spectrogram
constexpr double kPushN = 0.8, kHardPushN = 1.5;

struct Shown {
  const char* medium;
  const char* surface;
  double push_n;
};
constexpr Shown kShown[] = {{"pencil", "paper", kPushN},          {"pencil", "rough-paper", kPushN},
                            {"pencil", "watercolour", kPushN},    {"pencil", "canvas", kPushN},
                            {"pencil", "blackboard", kPushN},     {"pencil", "felt", kPushN},
                            {"pencil", "wood", kPushN},           {"pencil", "glass", kPushN},
                            {"charcoal", "rough-paper", kPushN},  {"chalk", "blackboard", kPushN},
                            {"chalk", "blackboard", kHardPushN},  {"felt-tip", "glass", kHardPushN},
                            {"crayon", "paper", kPushN},          {"ink-pen", "paper", kPushN},
                            {"brush-pen", "watercolour", kPushN}, {"eraser", "paper", kPushN}};

RubbingPair pair_of(const Shown& shown) {
  return rubbing_pair(*find_surface(shown.surface), *find_medium(shown.medium));
}

/// Returns the sound of a stroke: the pen touches the surface, accelerates to 240 mm/s (120 mm/s if
/// it presses hard), slows down, and is lifted.
std::vector<float> swelling_stroke(const Shown& shown) {
  RubbingPlayer sound;
  sound.set_pair(pair_of(shown));
  std::vector<float> all;
  const double fastest = shown.push_n > kPushN ? 120.0 : 240.0;
  double way_mm = 0.0;
  for (int i = 0; i < static_cast<int>(1000.0 * kSeconds); ++i) {
    const double part = i / (1000.0 * kSeconds);
    const bool is_down = part > 0.05 && part < 0.95;
    const double swell = std::sin(3.14159265358979324 * (part - 0.05) / 0.9);
    if (is_down) way_mm += 0.001 * fastest * swell * swell;
    sound.push({std::int64_t{1'000'000} * i, Point{10.0 + way_mm, 20.0 + 0.1 * way_mm},
                is_down ? shown.push_n : 0.0, 0.0});
    const std::size_t had = all.size();
    all.resize(had + sound.ready());
    sound.render(std::span(all).subspan(had));
  }
  return all;
}

constexpr int kColumns = 4, kPanelPx = 230, kHighPx = 150, kGapPx = 26, kLeftPx = 52, kTopPx = 24;

void draw_labels(PlotCanvas& canvas, const Shown& shown, PixelRect where, bool is_first) {
  const Rgba ink{40, 44, 52, 255};
  const std::string name = std::string(shown.medium) + " on " + shown.surface +
                           (shown.push_n > kPushN ? ", pushed hard" : "");
  canvas.text({where.x0 + 0.0, where.y0 - 7.0}, name, {.size = 8.5, .color = ink, .weight = 1.1});
  if (!is_first) return;
  for (const auto& [hz, label] :
       {std::pair{100.0, "100 Hz"}, {1000.0, "1 kHz"}, {10000.0, "10 kHz"}}) {
    const double y = spectrogram_y(hz, where);
    canvas.line({where.x0 - 5.0, y}, {where.x0 + 0.0, y}, {.width = 1.0, .color = ink});
    canvas.text({where.x0 - 7.0, y + 3.5}, label,
                {.size = 7.0, .color = ink, .align = PlotAlign::kRight});
  }
}

Result<Image> draw_picture() {
  constexpr int kRows = static_cast<int>(std::size(kShown)) / kColumns;
  auto picture = Image::create(kLeftPx + kColumns * (kPanelPx + kGapPx / 2),
                               kTopPx + kRows * (kHighPx + kGapPx));
  if (!picture) return picture;
  fill(picture->pixels(), picture->pixels().rect(), {255, 255, 255, 255});
  int number = 0;
  for (const Shown& shown : kShown) {
    const int x = kLeftPx + number % kColumns * (kPanelPx + kGapPx / 2);
    const int y = kTopPx + number / kColumns * (kHighPx + kGapPx);
    const PixelRect where{x, y, x + kPanelPx, y + kHighPx};
    draw_spectrogram(swelling_stroke(shown), picture->pixels(), where);
    PlotCanvas canvas(picture->pixels(), 1.0);
    draw_labels(canvas, shown, where, number % kColumns == 0);
    ++number;
  }
  return picture;
}

void print_sounds() {
  std::printf("| pair | dB at 50 mm/s | at 150 | at 0.2 N | kHz at 50 mm/s | at 150 |\n");
  std::printf("|---|---|---|---|---|---|\n");
  for (const Shown& shown : kShown) {
    const RubbingPair pair = pair_of(shown);
    const auto at = [&](double mm_per_s, double push_n) {
      return after(sound_of(pair, {.mm_per_s = mm_per_s, .push_n = push_n}), 0.1);
    };
    const auto slow = at(50.0, shown.push_n), quick = at(150.0, shown.push_n);
    const auto db = [](const std::vector<float>& sound) {
      return 20.0 * std::log10(rms_of(sound));
    };
    std::printf("| %s on %s, %.1f N | %.0f | %.0f | %.0f | %.1f | %.1f |\n", shown.medium,
                shown.surface, shown.push_n, db(slow), db(quick), db(at(150.0, 0.2)),
                1e-3 * centroid_of(slow), 1e-3 * centroid_of(quick));
  }
}

double cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Prints the CPU time per sample: the minimum of some runs, because other programs use the
/// machine.
void print_cost() {
  std::printf("\n| what | ns a sample | of a core |\n|---|---|---|\n");
  const auto row = [](const char* what, const RubbingPair& pair, const RubbedStroke& stroke) {
    double smallest = 1e9;
    for (int i = 0; i < 5; ++i) {
      const double start = cpu_s();
      const auto sound = sound_of(pair, stroke);
      smallest = std::min(smallest, (cpu_s() - start) / static_cast<double>(sound.size()));
    }
    std::printf("| %s | %.0f | %.1f %% |\n", what, 1e9 * smallest, 100.0 * smallest * 48000.0);
  };
  const RubbingPair canvas = pair_of({"pencil", "canvas", 0.0});
  row("pencil on canvas, 20 mm/s", canvas, {.mm_per_s = 20.0});
  row("pencil on canvas, 150 mm/s", canvas, {.mm_per_s = 150.0});
  row("pencil on canvas, 500 mm/s", canvas, {.mm_per_s = 500.0});
  row("chalk that squeaks on a blackboard", pair_of({"chalk", "blackboard", 0.0}),
      {.mm_per_s = 80.0, .push_n = kHardPushN});
  row("in the air", canvas, {.push_n = 0.0});
}

}  // namespace
}  // namespace felt::bench

int main(int argc, char** argv) {
  const std::string path = argc > 1 ? argv[1] : "docs/images/sound.png";
  felt::bench::print_sounds();
  felt::bench::print_cost();
  if (path.empty()) return 0;
  const auto picture = felt::bench::draw_picture();
  const auto written = picture ? felt::write_png(path, *picture, 0.0)
                               : felt::Result<void>(tl::unexpected(picture.error()));
  if (!written) {
    std::fprintf(stderr, "bench_sound: %s\n", written.error().message.c_str());
    return 1;
  }
  std::printf("\n%s\n", path.c_str());
  return 0;
}
