#include "felt/studies/measured_trial.h"

#include <gtest/gtest.h>

#include <cmath>

#include "felt/document/visible_strokes.h"
#include "felt/geometry/nearest.h"
#include "felt/geometry/polyline.h"
#include "felt/session/session.h"
#include "felt/studies/testing/study_fixture.h"

namespace felt::measured_trial_test {
namespace {

constexpr std::int64_t kTickNs = 1'000'000;

/// Returns the recording of a pen that draws a line of 60 mm along x in 1 s, and then hovers.
FeltRecording line_recording(const std::string& stabiliser) {
  FeltRecording recording;
  recording.events.push_back({0, {0, SetOption{"pencil.snap", std::string("off")}}});
  recording.events.push_back({0, {0, SetOption{"pencil.stabiliser", stabiliser}}});
  for (int i = 0; i <= 1000; ++i) {
    RecordedSample sample;
    sample.time_ns = i * kTickNs;
    sample.pen.position = {40.0 + 0.06 * i, 50.0, i < 1000 ? -0.2 : 2.0};
    sample.forces = RecordedForces{{}, {0.5, -0.25, 1.0}};
    sample.pen.pressure = 0.5;
    if (i == 1000) sample.pen.pressure = 0.0;
    if (i == 0) sample.forces.reset();
    recording.samples.push_back(sample);
  }
  return recording;
}

TEST(MeasuredTrial, ConvertsTheSamplesOfARecording) {
  const std::vector<TrialSample> samples = trial_samples(line_recording("off"));
  ASSERT_EQ(samples.size(), 1001U);
  EXPECT_EQ(samples[500].time_ns, 500 * kTickNs);
  EXPECT_EQ(samples[500].position, (Point{70.0, 50.0}));
  EXPECT_EQ(samples[500].pressure, 0.5);
  EXPECT_EQ(samples[500].force_n, (Vec{0.5, -0.25}));
  EXPECT_FALSE(samples[0].force_n);
  EXPECT_TRUE(samples[999].contact);
  EXPECT_FALSE(samples[1000].contact);
}

TEST(MeasuredTrial, APenThatTowsTheNibDrawsBehindIt) {
  const std::vector<TrialSample> samples = trial_samples(line_recording("towed"));
  const double behind_mm = 70.0 - samples[500].position.x;
  EXPECT_GT(behind_mm, 3.0) << "the rope is 4 mm long";
  EXPECT_LT(behind_mm, 8.0);
  EXPECT_NEAR(samples[500].position.y, 50.0, 1e-6);
  EXPECT_NEAR(samples.back().position.x, 100.0, 1e-9) << "a hover sample is where the pen is";
  ASSERT_GT(samples.size(), 1001U) << "the ink is completed up to the pen";
  const TrialSample& end = samples[samples.size() - 2];
  EXPECT_TRUE(end.contact);
  EXPECT_NEAR(end.position.x, 40.0 + 0.06 * 999, 1e-9);
}

// The ink of the session and the samples are two results of the same recording.
TEST(MeasuredTrial, TheSamplesAreWhereTheInkIs) {
  for (const char* kind : {"towed", "inertia"}) {
    FeltRecording recording = line_recording(kind);
    for (std::size_t i = 0; i < recording.samples.size(); ++i) {
      recording.samples[i].pen.position.y = 50.0 + 5.0 * std::sin(0.02 * static_cast<double>(i));
    }
    Session session(make_tools(), {});
    ASSERT_TRUE(play_recording(recording, [&](const Event& e) { return session.apply(e); }));
    const std::vector<StrokePtr> ink = visible_strokes(session.document());
    ASSERT_EQ(ink.size(), 1U);
    for (const TrialSample& sample : trial_samples(recording)) {
      double away = sample.contact ? 1e9 : 0.0;
      for (int i = 0; sample.contact && i < ink[0]->segment_count(); ++i) {
        away = std::min(away,
                        std::sqrt(nearest(ink[0]->segment(i), sample.position).distance_squared));
      }
      ASSERT_LT(away, 0.15) << kind << " at " << sample.time_ns;
    }
  }
}

class MeasuredTrialTest : public felt::testing::StudyFixture {
 protected:
  StudyFiles study_with(const std::string& shape) {
    write("s.toml", "id = \"s\"\n[[condition]]\nname = \"c\"\n[[shape]]\nname = \"l\"\n" + shape);
    return read_study_files(path("s.toml")).value();
  }
  /// Returns samples along a path, 10 ms apart.
  static std::vector<TrialSample> along(const std::vector<Point>& path, Vec shift = {}) {
    std::vector<TrialSample> samples;
    for (const Point p : path) {
      samples.push_back(
          {.time_ns = 10 * kTickNs * std::ssize(samples), .position = p + shift, .contact = true});
    }
    return samples;
  }
};

TEST_F(MeasuredTrialTest, ACopyIsComparedAtTheCentreOfTheInk) {
  const StudyFiles files = study_with("kind = \"circle\"\ntask = \"copy\"\nsize_mm = 40\n");
  const std::vector<TrialSample> ink = along(files.paths[0].points, {7.0, -5.0});
  const StudyPath path = compared_path(files, PlannedTrial(), ink);
  EXPECT_NEAR(path.points[0].x, files.paths[0].points[0].x + 7.0, 1e-9);
  EXPECT_NEAR(path.points[0].y, files.paths[0].points[0].y - 5.0, 1e-9);
  EXPECT_LT(*measure_recorded_trial(files, PlannedTrial(), ink).err_max_mm, 1e-6);
  EXPECT_EQ(compared_path(files, PlannedTrial(), {}).points, files.paths[0].points) << "no ink";
}

TEST_F(MeasuredTrialTest, ATracedShapeIsComparedWhereItIs) {
  const StudyFiles files = study_with("kind = \"line\"\nsize_mm = 40\n");
  const std::vector<TrialSample> ink = along(files.paths[0].points, {0.0, 3.0});
  EXPECT_NEAR(*measure_recorded_trial(files, PlannedTrial(), ink).err_mean_mm, 3.0, 1e-6);
}

TEST_F(MeasuredTrialTest, TheGeometryIsThatOfTheTask) {
  const auto geometry = [this](const std::string& shape) {
    return geometry_of(study_with(shape), PlannedTrial());
  };
  EXPECT_EQ(geometry("kind = \"circle\"\n").ends, TrialPathEnds::kClosed);
  EXPECT_FALSE(geometry("kind = \"line\"\n").tunnel_width_mm);
  EXPECT_EQ(geometry("kind = \"wave\"\ntask = \"tunnel\"\ntunnel_mm = 4\n").tunnel_width_mm, 4.0);
  EXPECT_EQ(geometry("kind = \"line\"\ntask = \"connect\"\n").target_width_mm, kConnectTargetMm);
}

TEST(MeasuredTrial, NamesTheFirstBrokenRule) {
  CatchRules rules{
      .min_length_share = 0.8, .max_lifts = 2, .left_tunnel = true, .max_mm_per_s = 100.0};
  TrialMetrics metrics;
  metrics.ink_length_mm = 80.0;
  metrics.lifts = 2.0;
  metrics.speed_mean_mm_per_s = 100.0;
  metrics.out_of_tunnel_share = 0.0;
  EXPECT_EQ(broken_rule(rules, metrics, 100.0, false), "");
  EXPECT_EQ(broken_rule(rules, metrics, 100.0, true), "device_fault");
  EXPECT_EQ(broken_rule(rules, metrics, 101.0, false), "min_length_share");
  EXPECT_EQ(broken_rule(rules, TrialMetrics(), 100.0, false), "min_length_share") << "no ink";
  metrics.out_of_tunnel_share = 0.01;
  EXPECT_EQ(broken_rule(rules, metrics, 100.0, false), "left_tunnel");
  metrics.speed_mean_mm_per_s = 100.1;
  EXPECT_EQ(broken_rule(rules, metrics, 100.0, false), "max_mm_per_s");
  metrics.lifts = 3.0;
  EXPECT_EQ(broken_rule(rules, metrics, 100.0, false), "max_lifts");
  rules = {.device_fault = false};
  EXPECT_EQ(broken_rule(rules, metrics, 1e6, true), "") << "no rules";
}

}  // namespace
}  // namespace felt::measured_trial_test
