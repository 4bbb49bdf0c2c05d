#include "felt/tools/overlay.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace felt::overlay_test
