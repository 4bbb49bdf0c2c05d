#include "desktop/canvas/wet_ink_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "felt/material/relief.h"

namespace felt::desktop::wet_ink_view_test {
namespace {

constexpr QSize kSize{400, 300};
constexpr std::size_t kOpen = 3;  // number of provisional segments at the end of a line

/// Returns segment i of a line that crosses itself, or of its provisional end.
Overlay::InkSegment segment(std::size_t i, bool is_open) {
  const auto at = [&](double u) {
    const double r = is_open ? 31.0 : 30.0;
    return Point{60.0 + r * std::sin(0.31 * u), 45.0 + r * std::sin(0.47 * u)};
  };
  const auto u = static_cast<double>(i);
  const Point a = at(u), b = at(u + 1.0);
  return {{{a, lerp(a, b, 1.0 / 3.0), lerp(a, b, 2.0 / 3.0), b}}, 1.0, 1.5};
}

/// Adds the first n segments of a stroke to the overlay; the last ones are provisional.
void show(Overlay& overlay, std::uint64_t stroke, std::size_t n) {
  std::vector<Overlay::InkSegment> stable;
  for (std::size_t i = 0; i + kOpen < n; ++i) stable.push_back(segment(i, false));
  overlay.clear();
  overlay.add_stable_ink(stroke, stable);
  for (std::size_t i = stable.size(); i < n; ++i) overlay.ink.push_back(segment(i, true));
}

WetInkView view_of_the_page() {
  DeviceView view;
  view.view.set_size(kSize);
  view.view.fit({0.0, 0.0, 120.0, 90.0});
  WetInkView ink;
  ink.set_view(view);
  return ink;
}

QImage picture(WetInkView& ink) {
  QImage image(kSize, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::white);
  QPainter painter(&image);
  ink.paint(painter, image.rect());
  return image;
}

/// Stable segments are not read again. To show this, the test overwrites them.
TEST(WetInkView, LooksOnlyAtInkThatIsNotStable) {
  WetInkView ink = view_of_the_page(), expected = view_of_the_page();
  Overlay overlay;
  std::size_t stable = 0;
  for (std::size_t n = 1; n < 200; n += 1 + n % 3) {
    show(overlay, 1, n);
    Overlay unknown = overlay, spoiled = overlay;
    unknown.ink_stroke = 0;  // without a stroke id, everything is compared
    const QRegion changed = expected.update(unknown);
    for (std::size_t i = 0; i < stable; ++i) spoiled.ink[i] = segment(7 * i, true);
    EXPECT_EQ(ink.update(spoiled), changed);
    EXPECT_LE(overlay.ink.size() - overlay.ink_stable, kOpen) << "so many are compared at most";
    stable = overlay.ink_stable;
  }
  EXPECT_EQ(picture(ink), picture(expected));
}

TEST(WetInkView, ShowsAnotherStrokeWhole) {
  WetInkView ink = view_of_the_page(), expected = view_of_the_page();
  Overlay overlay;
  show(overlay, 1, 40);
  for (Overlay::InkSegment& s : overlay.ink) s.curve = reversed(s.curve);
  ink.update(overlay);
  show(overlay, 2, 50);
  ink.update(overlay);
  expected.update(overlay);
  EXPECT_EQ(picture(ink), picture(expected));
  overlay.clear();
  ink.update(overlay);
  EXPECT_TRUE(ink.is_empty());
}

/// A line of a dry medium that crosses itself is as dark at the crossing as the finished stroke.
TEST(WetInkView, BuildsUpLikeDryInk) {
  const std::vector<Point> corners{{20, 45}, {100, 45}, {100, 20}, {60, 20}, {60, 70}};
  StrokeData data;
  data.points = {corners[0]};
  Overlay overlay;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Cubic c = straight(corners[i - 1], corners[i]);
    data.points.insert(data.points.end(), {c.p[1], c.p[2], c.p[3]});
    overlay.ink.push_back({c, 3.0, 3.0, 0.5, 0.5});
  }
  data.joints.assign(3, JointKind::kCorner);
  data.widths = {{0.0, 3.0, 0.5}, {4.0, 3.0, 0.5}};
  data.medium = "charcoal";
  const Stroke stroke = Stroke::create(data).value();
  overlay.ink_color = stroke.color();
  const Grain grain(surface_grain(*find_surface("paper")));
  WetInkView ink = view_of_the_page();
  ink.set_grain(grain, "charcoal");
  ink.update(overlay);
  const QImage wet = picture(ink);
  DeviceView view;
  view.view.set_size(kSize);
  view.view.fit({0.0, 0.0, 120.0, 90.0});
  QImage dry(kSize, QImage::Format_ARGB32_Premultiplied);
  dry.fill(Qt::white);
  const Pixels pixels{dry.bits(), dry.width(), dry.height(), dry.bytesPerLine(), PixelOrder::kBgra};
  Rasterizer rasterizer;
  rasterizer.draw(stroke, view.as_view(), pixels.rect(), grain, pixels);
  int worst = 0;
  const auto darkness = [&](Point middle) {
    const Point px = view.to_px(middle);
    double sum = 0.0;
    for (int y = -4; y <= 4; ++y) {
      for (int x = -4; x <= 4; ++x) {
        sum += 255 - qGray(wet.pixel(static_cast<int>(px.x) + x, static_cast<int>(px.y) + y));
      }
    }
    return sum / (81.0 * 255.0);
  };
  for (int y = 0; y < dry.height(); ++y) {
    for (int x = 0; x < dry.width(); ++x) {
      worst = std::max(worst, std::abs(qGray(dry.pixel(x, y)) - qGray(wet.pixel(x, y))));
    }
  }
  EXPECT_LE(worst, 3);
  EXPECT_GT(darkness({60, 45}), darkness({40, 45}) + 0.1) << "the crossing is darker";
}

}  // namespace
}  // namespace felt::desktop::wet_ink_view_test
