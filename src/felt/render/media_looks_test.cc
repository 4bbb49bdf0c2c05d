// How the built-in media look on paper: the properties that ./dev bench looks measures beside the
// presets of libmypaint.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "felt/material/relief.h"
#include "felt/render/page_painter.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::media_looks_test {
namespace {

constexpr const char* kDry[] = {"pencil-hard", "pencil", "pencil-soft",
                                "charcoal",    "chalk",  "crayon"};

/// A line of 80 mm along x in the middle of the page, as an upright pen draws it with this
/// pressure.
StrokePtr line_of(const Medium& medium, double pressure) {
  const MediumLine& line = medium.line;
  const double width = line.min_mm + (line.max_mm - line.min_mm) * std::pow(pressure, line.gamma);
  StrokeData data = testing::straight_stroke({10, 10}, {90, 10}, width, width).data();
  data.medium = medium.id;
  for (WidthKnot& knot : data.widths) {
    knot.tone = std::lerp(line.tone_light, line.tone_heavy, std::pow(pressure, line.tone_gamma));
  }
  return std::make_shared<const Stroke>(Stroke::create(data).value());
}

/// The darkness of pixels, 0 on white paper and 1 on black ink, as rows along the line.
using Rows = std::vector<std::vector<double>>;

const Grain& on_paper() {
  static const Grain grain(surface_grain(*find_surface("paper")));
  return grain;
}

/// Draws the strokes on paper, and returns the rows within `reach_mm` of the middle of the line.
Rows rows_of(const std::vector<StrokePtr>& strokes, double dpi, double reach_mm,
             const Grain& grain = on_paper()) {
  PageOptions options{.dpi = dpi, .area = Rect{15, 10 - reach_mm, 85, 10 + reach_mm}};
  options.grain = grain;
  const Image image = render_page(strokes, options).value();
  Rows rows(static_cast<std::size_t>(image.height()));
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      rows[static_cast<std::size_t>(y)].push_back(1.0 - image.at(x, y).g / 255.0);
    }
  }
  return rows;
}

/// Returns the share of pixels with a darkness in [from, to].
double share_of(const Rows& rows, double from, double to) {
  double found = 0.0, all = 0.0;
  for (const auto& row : rows) {
    all += static_cast<double>(row.size());
    found += static_cast<double>(
        std::count_if(row.begin(), row.end(), [&](double v) { return v >= from && v <= to; }));
  }
  return found / all;
}

double mean_of(const Rows& rows) {
  double sum = 0.0, all = 0.0;
  for (const auto& row : rows) {
    for (const double v : row) sum += v;
    all += static_cast<double>(row.size());
  }
  return sum / all;
}

/// Returns the highest correlation of the darkness of two points that are 0.9 to 12 mm apart along
/// the line. A grain with cells, or one that repeats, has a peak.
double second_peak_of(const Rows& rows, double dpi) {
  const auto first = static_cast<std::size_t>(0.9 * dpi / 25.4);
  const auto last = static_cast<std::size_t>(12.0 * dpi / 25.4);
  const auto covariance = [&](std::size_t lag) {
    double sum = 0.0, count = 0.0;
    for (const auto& row : rows) {
      const double mean = mean_of({row});
      for (std::size_t x = 0; x + lag < row.size(); ++x) {
        sum += (row[x] - mean) * (row[x + lag] - mean);
        count += 1.0;
      }
    }
    return sum / count;
  };
  double peak = 0.0;
  for (std::size_t lag = first; lag <= last; ++lag) peak = std::max(peak, covariance(lag));
  return peak / covariance(0);
}

TEST(MediaLooks, ADryMediumAnswersPressureWithTone) {
  for (const char* id : kDry) {
    const Medium& medium = *find_medium(id);
    const double reach = 0.2 * medium.line.min_mm;
    double last = mean_of(rows_of({line_of(medium, 0.05)}, 200, reach));
    EXPECT_LT(last, 0.2) << id << ": a light line is pale";
    for (const double pressure : {0.2, 0.35, 0.5, 0.65, 0.8, 0.95}) {
      const double tone = mean_of(rows_of({line_of(medium, pressure)}, 200, reach));
      EXPECT_GT(tone, last + 0.02) << id << " at " << pressure;
      EXPECT_LT(tone, last + 0.3) << id << " at " << pressure << ": the tone does not jump";
      last = tone;
    }
    EXPECT_GT(last, 0.5) << id << ": a firm line is dark";
  }
}

TEST(MediaLooks, APencilGrowsTwoToThreeTimesInWidthAndInksBroaden) {
  for (const char* id : kDry) {
    const MediumLine& line = find_medium(id)->line;
    EXPECT_GE(line.max_mm, 2.0 * line.min_mm) << id;
    EXPECT_LE(line.max_mm, 3.0 * line.min_mm + 1e-9) << id;
    EXPECT_GT(line.tilt_width, 1.5) << id << ": the side of the tip is broader";
  }
  for (const char* id : {"ink-pen", "brush-pen"}) {
    const MediumLine& line = find_medium(id)->line;
    EXPECT_GE(line.max_mm, 4.0 * line.min_mm) << id;
  }
}

TEST(MediaLooks, ALineOfADryMediumIsMostlyOfMidTones) {
  for (const char* id : kDry) {
    const Medium& medium = *find_medium(id);
    double mid = 0.0, full = 0.0;
    for (int i = 0; i < 10; ++i) {
      const Rows rows = rows_of({line_of(medium, 0.05 + 0.1 * i)}, 144, 0.25 * medium.line.min_mm);
      mid += 0.1 * share_of(rows, 0.1, 0.9);
      full += 0.1 * share_of(rows, 0.9, 1.0);
    }
    EXPECT_GT(mid, 0.6) << id;
    EXPECT_LT(full, std::string(id).starts_with("pencil") ? 0.1 : 0.15) << id;
  }
}

// The presets of libmypaint vary by 0.06 to 0.24.
TEST(MediaLooks, ALightLineIsContinuousOnAScreen) {
  for (const char* id : kDry) {
    const Medium& medium = *find_medium(id);
    for (const double dpi : {84.0, 96.0, 144.0}) {
      const Rows rows = rows_of({line_of(medium, 0.3)}, dpi, 2.0);
      double mean = 0.0, square = 0.0, least = 1e9;
      const std::size_t columns = rows[0].size();
      for (std::size_t x = 0; x < columns; ++x) {
        double ink = 0.0;
        for (const auto& row : rows) ink += row[x];
        mean += ink / static_cast<double>(columns);
        square += ink * ink / static_cast<double>(columns);
        least = std::min(least, ink);
      }
      EXPECT_LT(std::sqrt(square - mean * mean), 0.25 * mean) << id << " at " << dpi;
      EXPECT_GT(least, 0.3 * mean) << id << " at " << dpi << ": a gap";
    }
  }
}

TEST(MediaLooks, TheGrainHasNoCellAndNoPeriodAtAnyScale) {
  // A broad line of the same look, so that there are many points to compare.
  const auto broad = [](const Medium& medium) {
    StrokeData data = line_of(medium, 0.5)->data();
    for (WidthKnot& knot : data.widths) knot.width_mm = 16.0;
    return std::make_shared<const Stroke>(Stroke::create(data).value());
  };
  for (const char* id : kDry) {
    for (const double dpi : {144.0, 288.0}) {
      const Rows rows = rows_of({broad(*find_medium(id))}, dpi, 5.0);
      EXPECT_LT(second_peak_of(rows, dpi), 0.12) << id << " at " << dpi;
    }
  }
  // The relief of smooth paper alone, which the hand feels, has cells of 1 mm.
  Materials felt_only = Materials::built_in();
  Medium pencil = *find_medium("pencil");
  pencil.look.crumb = 0.0;
  felt_only.put(pencil);
  const Grain relief_only(surface_grain(*find_surface("paper")), felt_only);
  EXPECT_GT(second_peak_of(rows_of({broad(pencil)}, 288, 5.0, relief_only), 288), 0.12);
}

TEST(MediaLooks, ToneBuildsUpWhereStrokesCross) {
  for (const char* id : kDry) {
    const Medium& medium = *find_medium(id);
    const StrokePtr line = line_of(medium, 0.4);
    const double reach = 0.2 * medium.line.min_mm;
    const double once = mean_of(rows_of({line}, 144, reach));
    const double twice = mean_of(rows_of({line, line}, 144, reach));
    const double often = mean_of(rows_of({line, line, line, line}, 144, reach));
    EXPECT_GT(twice, 1.15 * once) << id;
    EXPECT_GT(often, 1.1 * twice) << id;
  }
}

TEST(MediaLooks, ABrushPenHasNoSpeckles) {
  const Medium& brush = *find_medium("brush-pen");
  for (const double pressure : {0.2, 0.5, 0.9}) {
    const StrokePtr line = line_of(brush, pressure);
    const double reach = 0.25 * line->data().widths.front().width_mm;
    EXPECT_GT(share_of(rows_of({line}, 576, reach), 0.95, 1.0), 0.98) << pressure;
  }
}

}  // namespace
}  // namespace felt::media_looks_test
