#include "felt/tools/overlay.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <vector>

namespace felt::overlay_test {
namespace {

/// A ring of two segments.
Stroke small_ring() {
  StrokeData data;
  data.points = {{1, 0}, {1, 1.3}, {-1, 1.3}, {-1, 0}, {-1, -1.3}, {1, -1.3}, {1, 0}};
  data.joints.assign(2, JointKind::kSmooth);
  data.closed = true;
  data.widths = {{0.0, 1.0}, {2.0, 1.0}};
  return Stroke::create(std::move(data)).value();
}

std::size_t spans(double u0, double u1) {
  Overlay overlay;
  add_span(overlay, small_ring(), u0, u1, Overlay::Role::kSpan);
  return overlay.spans.size();
}

TEST(AddSpan, GoesThroughTheSeamOfAClosedStroke) {
  EXPECT_EQ(spans(0.2, 0.8), 1U);
  EXPECT_EQ(spans(0.2, 1.8), 2U);
  EXPECT_EQ(spans(1.5, 0.5), 2U);
  EXPECT_EQ(spans(0.5, 0.5), 3U) << "once round";
}

TEST(AddSpan, EndsWhereItBeginsAtTheSeam) {
  EXPECT_EQ(spans(2.0, 2.0), 2U) << "all of it, from the seam on";
  EXPECT_EQ(spans(2.0, 1.0), 1U);
  EXPECT_EQ(spans(7.0, 3.0), 2U);
}

std::vector<Overlay::InkSegment> ink_of_widths(std::initializer_list<double> widths) {
  std::vector<Overlay::InkSegment> ink;
  for (const double width : widths) ink.push_back({Cubic{}, width, width});
  return ink;
}

TEST(StableInk, ContinuesTheSameStrokeAndReplacesAnother) {
  Overlay overlay;
  const auto show = [&](std::uint64_t stroke, std::initializer_list<double> stable) {
    overlay.clear();
    overlay.add_stable_ink(stroke, ink_of_widths(stable));
    overlay.ink.push_back({Cubic{}, 9.0, 9.0});  // the provisional segment at the end
    EXPECT_EQ(overlay.ink_stroke, stroke);
    EXPECT_EQ(overlay.ink_stable, stable.size());
    std::vector<Overlay::InkSegment> expected = ink_of_widths(stable);
    expected.push_back({Cubic{}, 9.0, 9.0});
    EXPECT_EQ(overlay.ink, expected);
  };
  show(1, {});
  show(1, {1, 2});
  show(1, {1, 2, 3});
  show(2, {4, 5});
  show(2, {4, 5, 6});
  overlay.clear();
  overlay.clear();
  EXPECT_TRUE(overlay.ink.empty());
  EXPECT_EQ(overlay.ink_stroke, 0U);
  EXPECT_EQ(overlay.ink_stable, 0U);
  show(2, {4, 5, 6, 7});
  show(1, {1, 2, 3, 4, 5});
}

TEST(StableInk, OfTwoStrokesIsOfNoKnownStroke) {
  Overlay overlay;
  for (int i = 0; i < 2; ++i) {
    overlay.clear();
    overlay.add_stable_ink(1, ink_of_widths({1, 2}));
    overlay.add_stable_ink(2, ink_of_widths({3}));
    EXPECT_EQ(overlay.ink, ink_of_widths({1, 2, 3}));
    EXPECT_EQ(overlay.ink_stroke, 0U);
    EXPECT_EQ(overlay.ink_stable, 0U);
  }
  overlay.clear();
  overlay.add_stable_ink(1, ink_of_widths({1, 2, 4}));
  EXPECT_EQ(overlay.ink, ink_of_widths({1, 2, 4}));
}

}  // namespace
}  // namespace felt::overlay_test
