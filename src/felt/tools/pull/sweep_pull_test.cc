#include "felt/tools/pull/sweep_pull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "felt/geometry/nearest.h"
#include "felt/stroke/testing/random_stroke.h"
#include "felt/stroke/testing/stroke_probe.h"
#include "felt/tools/pull/sweep_gesture.h"
#include "felt/tools/testing/tool_fixture.h"

namespace felt::sweep_pull_test {
namespace {

using testing::Fixture;
using testing::random_stroke;
using testing::RandomStroke;
using testing::share;
using testing::straight_stroke;

const double kPart = 1.0 - std::exp(-1.0 / 50.0);  // fraction for a step of 1 ms

double farthest(const Stroke& a, const Stroke& b) {
  double far = 0.0;
  for (int k = 0; k <= 400; ++k) {
    const Point p = a.position(k / 400.0 * a.segment_count());
    double near = 1e300;
    for (int i = 0; i < b.segment_count(); ++i) {
      near = std::min(near, nearest(b.segment(i), p).distance_squared);
    }
    far = std::max(far, near);
  }
  return std::sqrt(far);
}

TEST(SweepPull, R25_HonoursTheWeights) {
  const StrokePtr stroke = share(straight_stroke({0, 0}, {9, 0}, 1.0, 1.0));
  for (const WeightKind kind : {WeightKind::kSoft, WeightKind::kPaper, WeightKind::kPrinted}) {
    SweepPull sweep(stroke, 0.4, kind);
    ASSERT_TRUE(sweep.step({3.6, 2.0}, 0.5));
    const double t = sweep.place().t;
    const EditWeights w = edit_weights(
        kind, t, {.left_joint = pinned_compliance(t), .right_joint = pinned_compliance(1.0 - t)});
    const Stroke bent = *sweep.stroke();
    for (int k = 0; k < 4; ++k) {
      const auto i = static_cast<std::size_t>(k);
      EXPECT_NEAR(bent.segment(0).p[i].y, w.w[i], 1e-9) << k;
    }
    EXPECT_NEAR(sweep.point().y, w.gain(t), 1e-9) << "of half the distance, 1 mm";
    // The loop of the paper comes to the pen, also with the equation as printed.
    for (int round = 0; round < 200; ++round) sweep.step({3.6, 2.0}, 0.5);
    EXPECT_LE(distance(sweep.point(), {3.6, 2.0}), 1e-3);
  }
}

TEST(SweepPull, R24_TenThousandTicks) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE(seed);
    const StrokePtr stroke =
        seed < 3 ? share(straight_stroke({0, 0}, {120, 0}, 1.0, 1.0)) : share(random_stroke(seed));
    RandomStroke random(seed);
    SweepPull sweep(stroke, random.uniform(0.0, stroke->segment_count()));
    Point pen = sweep.point();
    Vec way{};
    for (int tick = 0; tick < 10'000; ++tick) {
      // A hand that moves around at about 100 mm/s.
      way += Vec{random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02)} - 0.01 * way;
      pen += way - 0.001 * (pen - Point{60, 0});
      sweep.step(pen, kPart);
      if (tick % 10 != 0) continue;
      const Result<Stroke> now = sweep.stroke();  // G1 to 1e-6 degrees, finite, ...
      ASSERT_TRUE(now) << tick << ": " << now.error().message;
      ASSERT_LE(now->segment_count(), 300);
      for (int i = 0; i < now->segment_count(); ++i) {
        const Cubic c = now->segment(i);
        if (tick == 0 || c == stroke->segment(std::min(i, stroke->segment_count() - 1))) continue;
        const double largest = 1.5 * arc_length(c, 1e-4) + 1e-3;
        // Checks only segments that the sweep has changed, because strokes may have any handles.
        if (seed < 3) {
          ASSERT_LE(distance(c.p[0], c.p[1]), largest) << tick;
          ASSERT_LE(distance(c.p[2], c.p[3]), largest) << tick;
        }
      }
    }
    ASSERT_TRUE(sweep.finished());
  }
}

TEST(SweepPull, ThePenDrawsTheLineOverAgain) {
  SweepPull sweep(share(straight_stroke({0, 0}, {120, 0}, 1.0, 1.0)), 0.3);
  // The pen moves at 60 mm/s along a wave that leaves the line and comes back.
  const auto pen = [](double x) { return Point{x, 4.0 * std::sin(0.15 * (x - 36.0))}; };
  for (double x = 36.0; x < 36.0 + 2.0 * 3.14159 / 0.15; x += 0.06) sweep.step(pen(x), kPart);
  const Stroke now = *sweep.stroke();
  for (double x = 42.0; x < 72.0; x += 1.0) {
    double near = 1e300;
    for (int i = 0; i < now.segment_count(); ++i) {
      near = std::min(near, nearest(now.segment(i), pen(x)).distance_squared);
    }
    // The curve lags by at most tau times the speed across the line, 60 mm/s * .6 * 50 ms.
    EXPECT_LE(std::sqrt(near), 2.0) << x;
  }
  EXPECT_EQ(now.data().points.front(), (Point{0, 0}));
  EXPECT_EQ(now.data().points.back(), (Point{120, 0}));
}

/// Returns the result of a gesture of 600 ms at a sample rate.
Stroke swept(double rate_hz) {
  Fixture fixture;
  const StrokeId id = fixture.add(straight_stroke({0, 0}, {120, 0}, 1.0, 1.0));
  const auto pen = [](double s) {
    PenSample sample;
    sample.time_ns = std::llround(1e9 * s);
    sample.position = {36.0 + 60.0 * s, 5.0 * std::sin(9.0 * s), -1.0};
    return sample;
  };
  const StrokeHit hit{.stroke = id, .u = 0.3, .point = {36, 0}, .distance_mm = 0.0};
  const auto gesture = make_sweep(pen(0.0), fixture.scene(), hit, {});
  for (int k = 1; k <= std::lround(0.6 * rate_hz); ++k) {
    (void)gesture->move(pen(k / rate_hz), fixture.scene());
  }
  const Edit edit = gesture->end(fixture.scene());
  EXPECT_EQ(edit.changes.size(), 1U);
  return *edit.changes.front().after;
}

TEST(SweepPull, R30_TheRateOfSamplesMeansNothing) {
  const Stroke reference = swept(1000.0);
  EXPECT_LE(farthest(swept(5000.0), reference), 0.05);
  EXPECT_LE(farthest(reference, swept(5000.0)), 0.05);
  // At 60 Hz the path of the pen consists of chords, up to 0.014 mm away from the wave.
  EXPECT_LE(farthest(swept(60.0), reference), 0.1);
  EXPECT_LE(farthest(reference, swept(60.0)), 0.1);
  EXPECT_LE(farthest(swept(250.0), reference), 0.05);
}

TEST(SweepPull, HostileTimesAreSurvived) {
  Fixture fixture;
  const StrokeId id = fixture.add(straight_stroke({0, 0}, {120, 0}, 1.0, 1.0));
  PenSample pen;
  pen.position = {36, 1, -1};
  const auto gesture =
      make_sweep(pen, fixture.scene(), {.stroke = id, .u = 0.3, .point = {36, 0}}, {});
  for (const std::int64_t t : {std::numeric_limits<std::int64_t>::min(),
                               std::numeric_limits<std::int64_t>::max(), std::int64_t{0}}) {
    pen.time_ns = t;
    pen.position.y += 1.0;
    (void)gesture->move(pen, fixture.scene());
  }
  fixture.apply(gesture->end(fixture.scene()));
}

}  // namespace
}  // namespace felt::sweep_pull_test
