#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "felt/geometry/nearest.h"
#include "felt/stroke/testing/stroke_probe.h"
#include "felt/tools/pull/grab_gesture.h"
#include "felt/tools/pull/push_gesture.h"
#include "felt/tools/pull/sweep_gesture.h"
#include "felt/tools/testing/tool_fixture.h"

namespace felt::other_modes_test {
namespace {

using testing::distance_to;
using testing::Fixture;
using testing::straight_stroke;

PenSample pen_at(Point p, int ms = 0) {
  PenSample pen;
  pen.time_ns = 1'000'000LL * ms;
  pen.position = {p.x, p.y, -1.0};
  return pen;
}

StrokePtr after(const Edit& edit, StrokeId id) {
  for (const StrokeChange& change : edit.changes) {
    if (change.id == id) return change.after;
  }
  return nullptr;
}

/// Five straight lines across, 2 mm apart, and one far away.
struct Lines : Fixture {
  Lines() {
    for (int k = 0; k < 5; ++k) {
      ids.push_back(add(straight_stroke({0, 2.0 * k}, {120, 2.0 * k}, 1.0, 1.0)));
    }
    far = add(straight_stroke({0, 80}, {120, 80}, 1.0, 1.0));
  }
  std::vector<StrokeId> ids;
  StrokeId far;
};

TEST(GrabGesture, R23_BackHomeNothingHasHappened) {
  Lines fixture;
  const StrokeHit hit = *fixture.index.nearest({50, 0.5}, 8.0);
  const auto grab = make_grab(pen_at({50, 0.5}), fixture.scene(), hit, {}, TouchOffset::kKept);
  EXPECT_EQ(grab->feel().kind, PullFeel::Kind::kSpring);
  EXPECT_EQ(grab->feel().origin, (Point{50, 0.5}));
  EXPECT_FALSE(grab->move(pen_at({50, 0.5}), fixture.scene()));
  const auto moved = grab->move(pen_at({53, 7.5}), fixture.scene());
  ASSERT_TRUE(moved);
  ASSERT_EQ(moved->changes.size(), 1U);
  // The grabbed point keeps the distance from the pen that it had at the touch.
  EXPECT_LE(distance_to(*after(*moved, hit.stroke), {53, 7}), 1e-9);
  EXPECT_FALSE(grab->move(pen_at({53, 7.5}), fixture.scene()));
  Overlay overlay;
  grab->draw(overlay);
  EXPECT_FALSE(overlay.spans.empty());
  EXPECT_FALSE(overlay.lines.empty());
  // The pen is back at the start.
  const auto home = grab->move(pen_at({50, 0.5}), fixture.scene());
  ASSERT_TRUE(home);
  EXPECT_EQ(*after(*home, hit.stroke), *fixture.document.find(hit.stroke));
  EXPECT_TRUE(grab->end(fixture.scene()).empty());
}

TEST(GrabGesture, AShapeThatIsNotPossibleIsNotShown) {
  Lines fixture;
  const StrokeHit hit = *fixture.index.nearest({50, 0}, 8.0);
  const auto grab = make_grab(pen_at({50, 0}), fixture.scene(), hit, {});
  ASSERT_TRUE(grab->move(pen_at({50, 5}), fixture.scene()));
  EXPECT_FALSE(grab->move(pen_at({std::nan(""), 5}), fixture.scene()));
  const Edit edit = grab->end(fixture.scene());
  EXPECT_LE(distance_to(*after(edit, hit.stroke), {50, 5}), 0.05);
  fixture.apply(edit);
}

TEST(PushGesture, R27_SeveralStrokesAtOnceEachFromItsSide) {
  Lines fixture;
  const auto push = make_push(pen_at({60, -20}), fixture.scene(), {});
  std::optional<Edit> last;
  for (int k = 0; k <= 400; ++k) {
    const Point pen{60, -20 + 0.1 * k};
    if (auto edit = push->move(pen_at(pen, k), fixture.scene())) last = std::move(edit);
    if (!last) continue;
    for (const StrokeId id : fixture.ids) {
      const StrokePtr now = after(*last, id) ? after(*last, id) : fixture.document.find(id);
      ASSERT_GE(distance_to(*now, pen), 3.0 - 1e-6);
    }
  }
  ASSERT_TRUE(last);
  EXPECT_EQ(last->changes.size(), 5U);
  EXPECT_EQ(after(*last, fixture.far), nullptr);
  const Edit edit = push->end(fixture.scene());
  EXPECT_EQ(edit.changes.size(), 5U);
  const Document before = fixture.document;
  fixture.apply(edit);
  for (const StrokeId id : fixture.ids) {
    EXPECT_GE(distance_to(*fixture.document.find(id), {60, 20}), 3.0 - 1e-6);
    EXPECT_GT(distance_to(*fixture.document.find(id), {60, 10}), 9.0);
  }
  fixture.undo();
  EXPECT_EQ(fixture.document, before);
}

TEST(PushGesture, R27_WhatIsNotTouchedIsNotMoved) {
  Lines fixture;
  const auto push = make_push(pen_at({60, -20}), fixture.scene(), {.radius_mm = 3.0});
  for (int k = 0; k <= 165; ++k) {
    EXPECT_FALSE(push->move(pen_at({60, -20 + 0.1 * k}, k), fixture.scene())) << k;
  }
  EXPECT_TRUE(push->end(fixture.scene()).empty());
}

TEST(PushGesture, HiddenAndLockedStrokesStay) {
  Lines fixture;
  LayerState locked = fixture.document.layers().front().state();
  const LayerState open = locked;
  locked.locked = true;
  fixture.apply({"Lock", {}, {{fixture.layer, open, locked, 0, 0}}});
  const auto push = make_push(pen_at({60, -20}), fixture.scene(), {});
  for (int k = 0; k <= 40; ++k) {
    EXPECT_FALSE(push->move(pen_at({60, -20.0 + k}, k), fixture.scene()));
  }
  EXPECT_TRUE(push->end(fixture.scene()).empty());
}

TEST(PushGesture, R27_WhatIsCommittedIsAsClearOfTheNib) {
  for (int k = 0; k < 40; ++k) {
    Lines fixture;
    const auto push = make_push(pen_at({20.0 + 2.1 * k, -20}), fixture.scene(), {});
    Point pen;
    for (int i = 0; i <= 300; ++i) {
      pen = {20.0 + 2.1 * k + 0.01 * (k % 7) * i, -20 + 0.1 * i};
      (void)push->move(pen_at(pen, i), fixture.scene());
    }
    fixture.apply(push->end(fixture.scene()));
    for (const StrokeId id : fixture.ids) {
      EXPECT_GE(distance_to(*fixture.document.find(id), pen), 3.0 - 1e-6) << k;
    }
  }
}

TEST(SweepGesture, OneEditThatIsUndoneAtOnce) {
  Lines fixture;
  const StrokeHit hit = *fixture.index.nearest({50, 8.2}, 8.0);
  const auto sweep = make_sweep(pen_at({50, 8.2}), fixture.scene(), hit, {});
  EXPECT_EQ(sweep->feel().kind, PullFeel::Kind::kSweep);
  for (int k = 1; k < 400; ++k) {
    (void)sweep->move(pen_at({50 + 0.05 * k, 8.2 + 4.0 * std::sin(0.01 * k)}, k), fixture.scene());
  }
  const Document before = fixture.document;
  const Edit edit = sweep->end(fixture.scene());
  ASSERT_EQ(edit.changes.size(), 1U);
  fixture.apply(edit);
  EXPECT_GT(distance_to(*fixture.document.find(hit.stroke), {58, 8}), 2.0);
  fixture.undo();
  EXPECT_EQ(fixture.document, before);
}

}  // namespace
}  // namespace felt::other_modes_test
