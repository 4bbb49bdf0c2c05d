#include "felt/render/plot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "felt/render/plot_canvas.h"

namespace felt::plot_test {
namespace {

constexpr Rgba kBlue{0, 0, 255, 255};
constexpr Rgba kWhite{255, 255, 255, 255};

/// Returns one panel with one signal over 10 s, without text: only axes and line.
Plot plot_of(const std::function<double(double)>& signal) {
  PlotTrace trace(0.0, 0.01);
  for (int i = 0; i < 1000; ++i) trace.add(signal(0.01 * i));
  Plot plot;
  plot.span = {0.0, 10.0};
  plot.panels.push_back({"", "", {{"", kBlue, trace, 2.0}}});
  return plot;
}

int count_pixels(const Image& image, PixelRect area, Rgba color) {
  int count = 0;
  for (int y = area.y0; y < area.y1; ++y) {
    for (int x = area.x0; x < area.x1; ++x) count += image.at(x, y) == color ? 1 : 0;
  }
  return count;
}

/// Returns the mean height of the pixels of a colour in a column, or NaN if the column has no such
/// pixel.
double height_in_column(const Image& image, int x, Rgba color) {
  double sum = 0.0;
  int count = 0;
  for (int y = 0; y < image.height(); ++y) {
    if (image.at(x, y) != color) continue;
    sum += y;
    ++count;
  }
  return count > 0 ? sum / count : std::nan("");
}

TEST(Plot, TheLineIsWhereTheSignalIs) {
  // A ramp is a straight line, so the heights in three columns are evenly spaced, and the last one
  // is the highest.
  const Image image = draw_plot(plot_of([](double t) { return 3.0 * t; })).value();
  const int third = image.width() / 4;
  const double a = height_in_column(image, third, kBlue);
  const double b = height_in_column(image, 2 * third, kBlue);
  const double c = height_in_column(image, 3 * third, kBlue);
  EXPECT_GT(a, b);
  EXPECT_GT(b, c);
  EXPECT_NEAR(a - b, b - c, 2.0);
}

TEST(Plot, AGapInTheSignalIsAGapInTheLine) {
  const Image image =
      draw_plot(plot_of([](double t) { return t > 4.0 && t < 6.0 ? std::nan("") : 1.0; })).value();
  EXPECT_TRUE(std::isnan(height_in_column(image, image.width() / 2, kBlue)));
  EXPECT_FALSE(std::isnan(height_in_column(image, image.width() / 4, kBlue)));
}

TEST(Plot, AShortPeakInALongRecordingIsSeen) {
  const Plot calm = plot_of([](double) { return 0.0; });
  Plot peak = calm;
  PlotTrace trace(0.0, 1e-5);
  for (int i = 0; i < 1'000'000; ++i) trace.add(i == 654'321 ? 1.0 : 0.0);
  peak.panels[0].lines[0].trace = trace;
  const Image image = draw_plot(peak).value();
  int highest = image.height();
  for (int x = 0; x < image.width(); ++x) {
    for (int y = 0; y < highest; ++y) {
      if (image.at(x, y) == kBlue) highest = y;
    }
  }
  const double calm_height = height_in_column(draw_plot(calm).value(), 900, kBlue);
  EXPECT_LT(highest, calm_height - 50.0);
}

TEST(Plot, ShadesTheTimesOfTheShade) {
  Plot plot = plot_of([](double) { return 1.0; });
  plot.shade = PlotTrace(0.0, 0.01);
  for (int i = 0; i < 1000; ++i) plot.shade.add(i >= 500 ? 1.0 : 0.0);
  const Image image = draw_plot(plot).value();
  // Inside the axes, which begin 88 pixels below the top.
  const PixelRect left{200, 100, 800, 130}, right{1000, 100, 1700, 130};
  EXPECT_GT(count_pixels(image, left, kWhite), 10'000);
  EXPECT_EQ(count_pixels(image, right, kWhite), 0);
}

TEST(Plot, LimitsAreInThePicture) {
  Plot plot = plot_of([](double) { return 1.0; });
  const double without = height_in_column(draw_plot(plot).value(), 900, kBlue);
  plot.panels[0].limits = {{"most", 4.0}};
  // The axis makes room for the limit, so the signal moves down.
  EXPECT_GT(height_in_column(draw_plot(plot).value(), 900, kBlue), without + 40.0);
}

TEST(Plot, PanelsStackAndTheSamePlotGivesTheSamePixels) {
  Plot plot = plot_of([](double t) { return std::sin(t); });
  plot.title = "Forces";
  plot.note = "a note (in ASCII), 1 kHz";
  plot.shade_name = "contact";
  const int one = draw_plot(plot).value().height();
  plot.panels.push_back(plot.panels[0]);
  plot.panels[1].span = PlotSpan{2.0, 3.0};
  const Image image = draw_plot(plot).value();
  EXPECT_GT(image.height(), one + 200);
  EXPECT_EQ(image, draw_plot(plot).value());
  EXPECT_EQ(image.width(), 1800);
}

TEST(Plot, SignalsWithoutValuesAreEmptyAxes) {
  Plot plot = plot_of([](double) { return std::nan(""); });
  plot.panels[0].lines.push_back({"never", kBlue, PlotTrace{}, 1.0});
  EXPECT_TRUE(draw_plot(plot));
}

TEST(Plot, RefusesNonsense) {
  const Plot plot = plot_of([](double) { return 1.0; });
  EXPECT_FALSE(draw_plot({}));
  EXPECT_FALSE(draw_plot(plot, {.width = 10.0}));
  EXPECT_FALSE(draw_plot(plot, {.width = std::nan("")}));
  EXPECT_FALSE(draw_plot(plot, {.width = 1e5, .scale = 100.0}));
  Plot broken = plot;
  broken.span = {1.0, 1.0};
  EXPECT_FALSE(draw_plot(broken));
  broken = plot;
  broken.panels[0].span = PlotSpan{0.0, std::numeric_limits<double>::infinity()};
  EXPECT_FALSE(draw_plot(broken));
  broken = plot;
  broken.panels[0].height = -1.0;
  EXPECT_FALSE(draw_plot(broken));
}

TEST(PlotCanvas, TextIsAsLongAsItSaysAndStaysInItsPlace) {
  Image image = Image::create(400, 60).value();
  fill(image.pixels(), image.pixels().rect(), kWhite);
  PlotCanvas canvas(image.pixels(), 1.0);
  const double width = canvas.text_width("Force, N", 12.0);
  EXPECT_GT(width, 40.0);
  EXPECT_NEAR(canvas.text_width("Force, NForce, N", 12.0), 2.0 * width, 3.0);
  canvas.text({300.0, 40.0}, "Force, N",
              {.size = 12.0, .color = {0, 0, 0, 255}, .align = PlotAlign::kRight});
  const int from = static_cast<int>(300.0 - width);
  const PixelRect place{from - 2, 24, 302, 46};
  const PixelRect all{0, 0, 400, 60};
  const auto inked = [&](PixelRect area) {
    return area.width() * area.height() - count_pixels(image, area, kWhite);
  };
  EXPECT_GT(inked(place), 100);
  EXPECT_EQ(inked(place), inked(all));
  EXPECT_GT(inked({from - 2, 24, from + 8, 46}), 10);  // begins there
}

}  // namespace
}  // namespace felt::plot_test
