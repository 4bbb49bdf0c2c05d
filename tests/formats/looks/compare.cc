/// looks_compare A.png B.png [DIFF.png] measures how much two pictures of one drawing differ.
///
/// Prints "mean M worst W size WxH" on stdout. M and W are differences of a colour channel, 0..255,
/// blended over white. M is the mean of all pixels, without tolerance. W is the worst value with a
/// tolerance of one pixel: the largest distance of a pixel from the range of the 3x3 pixels around
/// it in the other picture, computed for both pictures. So edges may be rounded differently, but no
/// part may be missing, added or moved by more than a pixel. The sizes may differ by a row or
/// column, because programs round them differently; the extra row or column is ignored.

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "felt/base/atomic_file.h"
#include "felt/base/read_file.h"
#include "felt/io/picture/png.h"

namespace {

constexpr int kChannels = 3;
constexpr int kMaxRowsApart = 2;

/// A picture with its colours blended over white.
struct Picture {
  int width = 0, height = 0;
  std::vector<int> values;

  [[nodiscard]] int at(int x, int y, int channel) const {
    return values[static_cast<std::size_t>((y * width + x) * kChannels + channel)];
  }
};

Picture picture_of(felt::Image& image) {
  const felt::Pixels pixels = image.pixels();
  Picture picture{image.width(), image.height(), {}};
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const std::uint8_t* p = pixels.data + y * pixels.stride + std::ptrdiff_t{4} * x;
      const std::array<int, kChannels> over{p[0] + 255 - p[3], p[1] + 255 - p[3],
                                            p[2] + 255 - p[3]};
      for (const int v : over) picture.values.push_back(std::min(v, 255));
    }
  }
  return picture;
}

Picture load(const char* path) {
  const auto bytes = felt::read_file(path, std::size_t{1} << 30);
  auto png = bytes.and_then([](const std::string& b) { return felt::decode_png(b); });
  if (png) return picture_of(png->image);
  std::fprintf(stderr, "%s: %s\n", path, png.error().message.c_str());
  std::exit(2);
}

/// Returns the distance of a pixel's value from the range of the 3x3 pixels around it in `other`.
int beyond(const Picture& one, const Picture& other, int x, int y, int channel) {
  int low = 255, high = 0;
  for (int v = std::max(0, y - 1); v <= std::min(other.height - 1, y + 1); ++v) {
    for (int u = std::max(0, x - 1); u <= std::min(other.width - 1, x + 1); ++u) {
      low = std::min(low, other.at(u, v, channel));
      high = std::max(high, other.at(u, v, channel));
    }
  }
  const int value = one.at(x, y, channel);
  return std::max({0, low - value, value - high});
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  const Picture a = load(argv[1]), b = load(argv[2]);
  if (std::abs(a.width - b.width) > kMaxRowsApart ||
      std::abs(a.height - b.height) > kMaxRowsApart) {
    std::fprintf(stderr, "sizes differ: %dx%d and %dx%d\n", a.width, a.height, b.width, b.height);
    return 1;
  }
  const int width = std::min(a.width, b.width), height = std::min(a.height, b.height);
  double sum = 0.0;
  int worst = 0, worst_x = 0, worst_y = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < kChannels; ++c) {
        sum += std::abs(a.at(x, y, c) - b.at(x, y, c));
        const int here = std::max(beyond(a, b, x, y, c), beyond(b, a, x, y, c));
        if (here <= worst) continue;
        worst = here;
        worst_x = x;
        worst_y = y;
      }
    }
  }
  std::printf("mean %.4f worst %d at %d,%d size %dx%d\n", sum / (kChannels * width * height), worst,
              worst_x, worst_y, width, height);
  return 0;
}
