#include "figures.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace felt::bench {
namespace {

/// The resolution of a window at 100 %.
constexpr double kScreenDpi = 96.0;

/// The darkness of the pixels of a picture.
class Darkness {
 public:
  Darkness(const Image& image, Rgba ink, double dpi)
      : px_per_mm_(dpi / 25.4), width_(image.width()), height_(image.height()) {
    const double full = 255.0 - ink.g;
    values_.reserve(image.bytes().size() / 4);
    for (std::size_t i = 0; i < image.bytes().size(); i += 4) {
      values_.push_back((255.0 - image.bytes()[i + 1]) / full);
    }
  }
  [[nodiscard]] double at(int x, int y) const {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return 0.0;
    return values_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(x)];
  }
  [[nodiscard]] int px(double mm) const { return static_cast<int>(mm * px_per_mm_); }
  [[nodiscard]] double px_per_mm() const { return px_per_mm_; }

  /// Returns the mean darkness of columns x0..x1, by distance from `y_mm`: up to 8 mm to each side.
  [[nodiscard]] std::vector<double> profile(int x0, int x1, double y_mm) const {
    const int reach = px(8.0), middle = px(y_mm);
    std::vector<double> means;
    for (int y = middle - reach; y <= middle + reach; ++y) {
      double sum = 0.0;
      for (int x = x0; x < x1; ++x) sum += at(x, y);
      means.push_back(sum / (x1 - x0));
    }
    return means;
  }

 private:
  double px_per_mm_;
  int width_, height_;
  std::vector<double> values_;
};

/// Where a profile is above a share of its top; the top is its second largest value, so that one
/// row does not decide. Positions are interpolated.
struct Band {
  double from = 0.0, to = 0.0;
};

Band band_of(const std::vector<double>& profile, double share) {
  std::vector<double> sorted = profile;
  std::sort(sorted.begin(), sorted.end());
  const double level = share * sorted[sorted.size() - 2];
  const auto first =
      std::find_if(profile.begin() + 1, profile.end(), [&](double v) { return v >= level; });
  const auto last =
      std::find_if(profile.rbegin() + 1, profile.rend(), [&](double v) { return v >= level; });
  if (first == profile.end() || last == profile.rend() || level <= 0.0) return {};
  const auto between = [&](double out, double in) {
    return in > out ? (level - out) / (in - out) : 0.0;
  };
  const auto i = first - profile.begin(), j = profile.rend() - last - 1;
  const auto value = [&](std::ptrdiff_t k) { return profile[static_cast<std::size_t>(k)]; };
  return {static_cast<double>(i) - 1.0 + between(value(i - 1), value(i)),
          static_cast<double>(j) + 1.0 - between(value(j + 1), value(j))};
}

/// Calls `use` with the darkness of each pixel in the core of the line at `y_mm`, columns x0..x1.
template <class Use>
void for_core(const Darkness& picture, int x0, int x1, double y_mm, const Use& use) {
  const Band half = band_of(picture.profile(x0, x1, y_mm), 0.5);
  const int top = picture.px(y_mm) - picture.px(8.0);
  const double middle = 0.5 * (half.from + half.to), reach = 0.25 * (half.to - half.from);
  const int y0 = top + static_cast<int>(std::lround(middle - reach));
  const int y1 = std::max(y0, top + static_cast<int>(std::lround(middle + reach)));
  for (int x = x0; x < x1; ++x) {
    for (int y = y0; y <= y1; ++y) use(picture.at(x, y));
  }
}

double mean_of_core(const Darkness& picture, int x0, int x1, double y_mm) {
  double sum = 0.0;
  int count = 0;
  for_core(picture, x0, x1, y_mm, [&](double v) { sum += v, ++count; });
  return count > 0 ? sum / count : 0.0;
}

void measure_ramp(const Darkness& picture, LookFigures& figures) {
  const double length = kRampX1 - kRampX0;
  const auto x_of = [&](double pressure) {
    return picture.px(kRampX0 + length * (pressure - kRampFrom) / (kRampTo - kRampFrom));
  };
  int all = 0, mid = 0, full = 0;
  const int step = picture.px(2.5);
  for (int x = picture.px(kRampX0); x + step <= picture.px(kRampX1); x += step) {
    for_core(picture, x, x + step, kRampY, [&](double v) {
      ++all;
      mid += v > 0.1 && v < 0.9 ? 1 : 0;
      full += v > 0.9 ? 1 : 0;
    });
  }
  figures.mid_share = static_cast<double>(mid) / std::max(all, 1);
  figures.full_share = static_cast<double>(full) / std::max(all, 1);
  for (std::size_t i = 0; i < figures.tones.size(); ++i) {
    const int x = x_of(LookFigures::kPressures[i]);
    figures.tones[i] = mean_of_core(picture, x - 2 * step, x + 2 * step, kRampY);
  }
  const auto width = [&](double pressure) {
    const int x = x_of(pressure);
    const Band half = band_of(picture.profile(x - 2 * step, x + 2 * step, kRampY), 0.5);
    return (half.to - half.from) / picture.px_per_mm();
  };
  figures.thin_mm = width(0.1);
  figures.broad_mm = width(0.9);
}

/// Measures the grain along the middle of the lines.
void measure_grain(const Darkness& picture, LookFigures& figures) {
  const int x0 = picture.px(kRampX0 + 5), x1 = picture.px(kRampX1 - 5), lags = picture.px(12.0);
  std::vector<double> products(static_cast<std::size_t>(lags) + 1), counts(products.size());
  for (int line = 0; line < kEvenLines; ++line) {
    const int middle = picture.px(kEvenApart * (line + 0.5));
    const int beside = picture.px(0.1);
    for (int y = middle - beside; y <= middle + beside; ++y) {
      double mean = 0.0;
      for (int x = x0; x < x1; ++x) mean += picture.at(x, y) / (x1 - x0);
      for (int lag = 0; lag <= lags; ++lag) {
        for (int x = x0; x + lag < x1; ++x) {
          const auto k = static_cast<std::size_t>(lag);
          products[k] += (picture.at(x, y) - mean) * (picture.at(x + lag, y) - mean);
          counts[k] += 1.0;
        }
      }
    }
  }
  const double variance = products[0] / counts[0];
  if (!(variance > 1e-6)) return;
  const auto correlation = [&](int lag) {
    const auto k = static_cast<std::size_t>(lag);
    return products[k] / counts[k] / variance;
  };
  int lag = 1;
  while (lag < lags && correlation(lag) > std::exp(-1.0)) ++lag;
  const double before = correlation(lag - 1), after = correlation(lag);
  figures.grain_mm = (lag - 1 + (before - std::exp(-1.0)) / (before - after)) / picture.px_per_mm();
  for (int k = std::max(lag, picture.px(1.0)); k <= lags; ++k) {
    if (correlation(k) <= figures.second_peak) continue;
    figures.second_peak = correlation(k);
    figures.second_mm = k / picture.px_per_mm();
  }
}

void measure_edge(const Darkness& picture, LookFigures& figures) {
  double sum = 0.0;
  const int x0 = picture.px(kRampX0 + 5), x1 = picture.px(kRampX1 - 5);
  for (int line = 0; line < kEvenLines; ++line) {
    const double y_mm = kEvenApart * (line + 0.5);
    const std::vector<double> profile = picture.profile(x0, x1, y_mm);
    const Band foot = band_of(profile, 0.1), top = band_of(profile, 0.9);
    sum += 0.5 * (top.from - foot.from + foot.to - top.to) / picture.px_per_mm();
    figures.once += mean_of_core(picture, x0, x1, y_mm) / kEvenLines;
  }
  figures.edge_mm = sum / kEvenLines;
}

/// Measures how much the ink of a line varies from column to column.
double unevenness_of(const Darkness& picture) {
  double sum = 0.0, squares = 0.0, count = 0.0;
  for (int line = 0; line < kEvenLines; ++line) {
    const int middle = picture.px(kEvenApart * (line + 0.5)), reach = picture.px(3.0);
    for (int x = picture.px(kRampX0 + 5); x < picture.px(kRampX1 - 5); ++x) {
      double ink = 0.0;
      for (int y = middle - reach; y <= middle + reach; ++y) ink += picture.at(x, y);
      sum += ink;
      squares += ink * ink;
      count += 1.0;
    }
  }
  const double mean = sum / count;
  return mean > 0.0 ? std::sqrt(std::max(squares / count - mean * mean, 0.0)) / mean : 0.0;
}

}  // namespace

Result<LookFigures> measure(const Artist& artist, double dpi) {
  LookFigures figures;
  const auto drawn = [&](const TestPage& page, double at_dpi) {
    return artist.draw(page, at_dpi).map([&](const Image& image) {
      return Darkness(image, artist.ink(), at_dpi);
    });
  };
  const auto ramp_picture = drawn(ramp(), dpi);
  const auto once = drawn(even_lines(0.5, 1), dpi), twice = drawn(even_lines(0.5, 2), dpi);
  const auto back = drawn(lines_there_and_back(0.5), dpi);
  const auto light = drawn(even_lines(0.3, 1), kScreenDpi);
  if (!ramp_picture) return tl::unexpected(ramp_picture.error());
  if (!once) return tl::unexpected(once.error());
  if (!twice) return tl::unexpected(twice.error());
  if (!back) return tl::unexpected(back.error());
  if (!light) return tl::unexpected(light.error());
  measure_ramp(*ramp_picture, figures);
  measure_grain(*once, figures);
  measure_edge(*once, figures);
  LookFigures again;
  measure_edge(*twice, again);
  figures.twice = again.once;
  again.once = 0.0;
  measure_edge(*back, again);
  figures.back = again.once;
  figures.unevenness = unevenness_of(*light);
  return figures;
}

}  // namespace felt::bench
