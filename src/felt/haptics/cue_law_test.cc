#include "felt/haptics/cue_law.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "felt/base/constants.h"
#include "felt/material/relief.h"

namespace felt::cue_law_test {
namespace {

CueFeel pencil_on_paper() {
  return cue_feel_of(*find_medium("pencil"), *find_surface("paper"));
}

struct Said {
  std::int64_t time_ns = 0;
  Cue cue;
};

/// A CueLaw with its input, which records the cues.
struct Fixture {
  CueLaw law;
  std::vector<Said> said;
  std::int64_t now_ns = 0;

  Fixture() { law.set_feel(pencil_on_paper()); }
  void step(CueInput input, std::int64_t after_ns = kMs) {
    input.time_ns = now_ns += after_ns;
    if (const auto cue = law.step(input)) said.push_back({now_ns, *cue});
  }
  void run(int ms, const CueInput& input, int step_ms = 1) {
    for (int t = 0; t < ms; t += step_ms) step(input, step_ms * kMs);
  }
  [[nodiscard]] int count(CueWaveform waveform) const {
    return static_cast<int>(std::count_if(
        said.begin(), said.end(), [=](const Said& s) { return s.cue.waveform == waveform; }));
  }
};

constexpr CueInput kAir{.height_mm = 5.0, .speed_mm_per_s = 100.0};
constexpr CueInput kStroke{.touches = true, .speed_mm_per_s = 120.0, .push_n = 1.0};
constexpr CueInput kRest{.touches = true, .speed_mm_per_s = 0.0, .push_n = 1.0};

TEST(RubIntensity, IsNothingAtRestWithoutPushAndForNonsense) {
  const CueFeel feel = pencil_on_paper();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(rub_intensity(feel, 0, 3), 0.0);
  EXPECT_EQ(rub_intensity(feel, 2, 3), 0.0);
  EXPECT_EQ(rub_intensity(feel, 300, 0), 0.0);
  EXPECT_EQ(rub_intensity(feel, -300, 1), 0.0);
  EXPECT_EQ(rub_intensity(feel, 300, -1), 0.0);
  for (const double odd : {nan, inf, -inf}) {
    EXPECT_EQ(rub_intensity(feel, odd, 1), 0.0);
    EXPECT_EQ(rub_intensity(feel, 100, odd), 0.0);
    const CueFeel nonsense{.waveform = CueWaveform::kBuzz, .friction = odd, .roughness = odd};
    EXPECT_EQ(rub_intensity(nonsense, 100, 1), 0.0);
  }
}

RC_GTEST_PROP(RubIntensity, GrowsWithSpeedAndPushAndStaysWithinOne, ()) {
  const auto& tool = media()[*rc::gen::inRange<std::size_t>(0, media().size())];
  const auto& surface =
      surface_materials()[*rc::gen::inRange<std::size_t>(0, surface_materials().size())];
  CueFeel feel = cue_feel_of(tool, surface);
  feel.wear = std::min(feel.wear, 0.5);  // greater wear may remove more than the push adds
  const double v = 0.1 * *rc::gen::inRange(0, 10000), f = 0.01 * *rc::gen::inRange(0, 500);
  const double more_v = v + 0.1 * *rc::gen::inRange(0, 1000);
  const double more_f = f + 0.01 * *rc::gen::inRange(0, 100);
  const double i = rub_intensity(feel, v, f);
  RC_ASSERT(i >= 0.0);
  RC_ASSERT(rub_intensity(feel, more_v, f) >= i);
  RC_ASSERT(rub_intensity(feel, v, more_f) >= i);
  RC_ASSERT(rub_intensity(feel, more_v, more_f) <= 1.0);
  // The intensity is continuous, with the modulus of continuity of a root: sqrt(a + h) - sqrt(a) <=
  // sqrt(h).
  const double dp = feel.friction * (more_f * std::max(more_v - 2, 0.0) - f * std::max(v - 2, 0.0));
  RC_ASSERT(rub_intensity(feel, more_v, more_f) - i <= std::sqrt(dp / 75.0) + 1e-12);
}

TEST(CueFeel, FollowsToolAndSurface) {
  const auto feel = [](std::string_view tool, std::string_view surface) {
    return cue_feel_of(*find_medium(tool), *find_surface(surface));
  };
  EXPECT_EQ(feel("pencil", "paper").waveform, CueWaveform::kPencil);
  EXPECT_EQ(feel("pencil", "glass").waveform, CueWaveform::kInk);
  EXPECT_EQ(feel("felt-tip", "paper").waveform, CueWaveform::kMarker);
  EXPECT_EQ(feel("crayon", "paper").waveform, CueWaveform::kChiselMarker);
  EXPECT_EQ(feel("eraser", "glass").waveform, CueWaveform::kEraser);
  EXPECT_EQ(feel("chalk", "blackboard").waveform, CueWaveform::kBuzz);
  EXPECT_DOUBLE_EQ(feel("pencil", "glass").roughness, 0.4);
  EXPECT_NEAR(feel("pencil", "paper").roughness, 0.81, 0.01);
  EXPECT_GT(feel("chalk", "blackboard").roughness, feel("pencil", "paper").roughness);
  EXPECT_GT(feel("chalk", "blackboard").friction, feel("chalk", "paper").friction);
  // 1.5 N at 200 mm/s on the roughest surface gives the maximum.
  EXPECT_NEAR(rub_intensity({.friction = 0.25, .roughness = 1.0}, 202, 1.5), 1.0, 1e-12);
  EXPECT_EQ(feel("pencil-hard", "paper").waveform, CueWaveform::kPencil);
  EXPECT_EQ(feel("pencil-soft", "paper").waveform, CueWaveform::kPencil);
  EXPECT_EQ(feel("charcoal", "paper").waveform, CueWaveform::kBuzz);
  EXPECT_EQ(feel("ink-pen", "paper").waveform, CueWaveform::kInk);
  EXPECT_EQ(feel("brush-pen", "paper").waveform, CueWaveform::kBrush);
  Medium mine = *find_medium("felt-tip");
  mine.id = "my-marker";
  EXPECT_EQ(cue_feel_of(mine, *find_surface("paper")).waveform, CueWaveform::kMarker);
}

TEST(CueFeel, HasTheReliefOfTheSurfaceAndTheMediumsShareOfIt) {
  for (const SurfaceMaterial& surface : surface_materials()) {
    for (const Medium& tool : media()) {
      const CueFeel feel = cue_feel_of(tool, surface);
      EXPECT_EQ(feel.relief, surface_grain(surface)) << "the one of the hand (R47)";
      EXPECT_EQ(feel.grain, tool.grain);
      EXPECT_EQ(feel.wear, tool.wear);
    }
  }
}

TEST(RubIntensity, AFirmPushWearsTheRoughnessButNotTheRubbing) {
  CueFeel feel = cue_feel_of(*find_medium("pencil"), *find_surface("canvas"));
  feel.wear = 0.0;
  CueFeel worn = feel;
  worn.wear = 1.0;
  EXPECT_NEAR(rub_intensity(worn, 60, 0.01) / rub_intensity(feel, 60, 0.01), 1.0, 0.01);
  // At a firm push only the intensity of a surface without grain remains.
  EXPECT_NEAR(rub_intensity(worn, 20, kFullPushN) / rub_intensity(feel, 20, kFullPushN),
              0.4 / feel.roughness, 1e-12);
}

RC_GTEST_PROP(HillSwell, IsBoundedContinuousAndTellsTheHillsOfTheSurface, ()) {
  const auto& tool = media()[*rc::gen::inRange<std::size_t>(0, media().size())];
  const auto& surface =
      surface_materials()[*rc::gen::inRange<std::size_t>(0, surface_materials().size())];
  const CueFeel feel = cue_feel_of(tool, surface);
  CueInput now{.touches = true};
  now.speed_mm_per_s = 0.1 * *rc::gen::inRange(0, 600);
  now.push_n = 0.01 * *rc::gen::inRange(0, 300);
  now.place = {0.01 * *rc::gen::inRange(-9000, 9000), 0.01 * *rc::gen::inRange(-9000, 9000)};
  const double swell = hill_swell(feel, now);
  RC_ASSERT(swell >= 0.4 - 1e-12);
  RC_ASSERT(swell <= 1.6 + 1e-12);
  if (feel.relief == nullptr) {
    RC_ASSERT(swell == 1.0);
    return;
  }
  const double height = feel.relief->at(now.place).height_mm;
  RC_ASSERT((swell - 1.0) * height >= 0.0);
  if (now.speed_mm_per_s / surface.grain_mm >= kLostHillsPerS) RC_ASSERT(swell == 1.0);
  // A small change of position, speed or push changes the intensity only slightly.
  CueInput beside = now;
  beside.place.x += 0.001;
  const double slope = feel.relief->max_slope() / (2e-3 * surface.grain_um);
  RC_ASSERT(std::abs(hill_swell(feel, beside) - swell) <= 0.6 * slope * 0.001 + 1e-9);
  CueInput faster = now;
  faster.speed_mm_per_s += 0.001;
  RC_ASSERT(std::abs(hill_swell(feel, faster) - swell) <= 0.001);
  CueInput harder = now;
  harder.push_n += 0.001;
  RC_ASSERT(std::abs(hill_swell(feel, harder) - swell) <= 0.001);
}

TEST(HillSwell, OddNumbersAreNoHills) {
  const CueFeel feel = cue_feel_of(*find_medium("pencil"), *find_surface("canvas"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  for (const double odd : {nan, inf, -inf, 1e300}) {
    EXPECT_EQ(hill_swell(feel, {.speed_mm_per_s = 5.0, .place = {odd, odd}}), 1.0);
    const double swell = hill_swell(feel, {.speed_mm_per_s = odd, .push_n = odd, .place = {1, 1}});
    EXPECT_GE(swell, 0.4);
    EXPECT_LE(swell, 1.6);
  }
}

// While the pen creeps over a coarse surface, the intensity swells once per hill, at the same
// points as the felt relief. If the hills are too fine it does not swell, and it swells less if the
// medium carries less of the relief.
TEST(CueLaw, R47_CreepingOverHillsIsFeltHillByHill) {
  const auto swells = [](const char* tool, const char* surface) {
    Fixture fixture;
    const CueFeel feel = cue_feel_of(*find_medium(tool), *find_surface(surface));
    fixture.law.set_feel(feel);
    double with = 0.0, of_cues = 0.0, of_hills = 0.0, mean = 0.0;
    int count = 0;
    CueInput input{.touches = true, .speed_mm_per_s = 8.0, .push_n = 0.8};
    std::vector<std::pair<double, double>> pairs;  // intensity of the playing cue, height
    for (int ms = 0; ms < 10'000; ++ms) {
      input.place.x = 0.008 * ms;
      fixture.step(input);
      if (ms < 500 || fixture.said.back().cue.waveform != feel.waveform) continue;
      const double height = feel.relief == nullptr ? 0.0 : feel.relief->at(input.place).height_mm;
      pairs.emplace_back(fixture.said.back().cue.intensity, height);
      mean += pairs.back().first;
      ++count;
    }
    mean /= count;
    for (const auto& [intensity, height] : pairs) {
      with += (intensity - mean) * height;
      of_cues += (intensity - mean) * (intensity - mean);
      of_hills += height * height;
    }
    struct Seen {
      double spread, likeness;
    };
    return Seen{std::sqrt(of_cues / count) / mean,
                of_cues > 0.0 && of_hills > 0.0 ? with / std::sqrt(of_cues * of_hills) : 0.0};
  };
  const auto rough = swells("pencil", "watercolour");
  EXPECT_GT(rough.spread, 0.12);
  EXPECT_GT(rough.likeness, 0.6) << "it swells where the hill is";
  EXPECT_LT(swells("pencil", "paper").spread, 0.02) << "too fine to be told, even so slowly";
  EXPECT_LT(swells("felt-tip", "watercolour").spread, 0.5 * rough.spread);
}

TEST(CueLaw, R47_AHillUnderAPenThatRestsIsSilent) {
  Fixture fixture;
  fixture.law.set_feel(cue_feel_of(*find_medium("chalk"), *find_surface("canvas")));
  CueInput input = kRest;
  for (int place = 0; place < 100; ++place) {
    input.place = {0.37 * place, 0.11 * place};
    fixture.run(30, input);
  }
  EXPECT_EQ(fixture.said.size(), 1u) << "the touch";
}

TEST(CueInput, ComesFromPressureOrDepth) {
  PenSample pen;
  pen.velocity = {30, 40, 900};
  pen.position.z = 0.7;
  const SurfaceMaterial& paper = *find_surface("paper");
  EXPECT_FALSE(cue_input_of(pen, paper).touches);
  EXPECT_EQ(cue_input_of(pen, paper).push_n, 0.0);
  EXPECT_DOUBLE_EQ(cue_input_of(pen, paper).height_mm, 0.7);
  EXPECT_DOUBLE_EQ(cue_input_of(pen, paper).speed_mm_per_s, 50.0);
  pen.position.z = -2.0;
  EXPECT_TRUE(cue_input_of(pen, paper).touches);
  EXPECT_DOUBLE_EQ(cue_input_of(pen, paper).push_n, 1.0);
  pen.pressure = 0.25;
  EXPECT_DOUBLE_EQ(cue_input_of(pen, paper).push_n, 0.5);
  pen.pressure = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(cue_input_of(pen, paper).push_n, 0.0);
}

TEST(CueLaw, AStrokeIsATouchAHumAndALift) {
  Fixture fixture;
  fixture.run(100, kAir);
  EXPECT_TRUE(fixture.said.empty()) << "silent above the surface, however fast";
  fixture.run(1000, kStroke);
  fixture.run(100, kAir);
  ASSERT_GE(fixture.said.size(), 4u);
  EXPECT_EQ(fixture.said.front().cue.waveform, CueWaveform::kPress);
  EXPECT_EQ(fixture.said.front().time_ns, 101 * kMs);
  EXPECT_EQ(fixture.said[1].cue.waveform, CueWaveform::kPencil);
  EXPECT_GE(fixture.said[1].time_ns - fixture.said[0].time_ns, CueLaw::kSingleNs);
  EXPECT_EQ(fixture.said.back().cue.waveform, CueWaveform::kRelease);
  EXPECT_EQ(fixture.count(CueWaveform::kPress), 1);
  EXPECT_EQ(fixture.count(CueWaveform::kRelease), 1);
  // A steady stroke is sent again at most five times a second.
  EXPECT_EQ(fixture.count(CueWaveform::kPencil), 5);
  EXPECT_NEAR(fixture.said[1].cue.intensity, rub_intensity(pencil_on_paper(), 120, 1), 0.02);
}

TEST(CueLaw, APenAtRestFallsSilentWithinATenthOfASecond) {
  Fixture fixture;
  fixture.run(500, kStroke);
  const std::int64_t rest_ns = fixture.now_ns;
  fixture.run(1000, kRest);
  ASSERT_EQ(fixture.said.back().cue, Cue{});
  EXPECT_LE(fixture.said.back().time_ns - rest_ns, 100 * kMs);
}

TEST(CueLaw, AHandThatTremblesAtRestIsSilent) {
  Fixture fixture;
  for (int t = 0; t < 5000; ++t) {
    CueInput input = kRest;
    input.speed_mm_per_s = 2.0 + 0.4 * std::sin(0.05 * t);
    fixture.step(input);
  }
  EXPECT_EQ(fixture.said.size(), 1u) << "the touch";
}

TEST(CueLaw, ChatteringOnTheSurfaceTouchesOnce) {
  for (const int period : {2, 3, 7, 16, 25, 40}) {
    Fixture fixture;
    for (int t = 0; t < 3000; ++t) {
      CueInput input = kStroke;
      input.touches = t % period < (period + 1) / 2;
      input.height_mm = input.touches ? 0.0 : 0.2;
      fixture.step(input);
    }
    EXPECT_EQ(fixture.count(CueWaveform::kPress), 1) << "period " << period;
    EXPECT_EQ(fixture.count(CueWaveform::kRelease), 0) << "period " << period;
    EXPECT_LE(fixture.said.size(), 40u) << "period " << period;
  }
}

TEST(CueLaw, IntensityAroundTheThresholdDoesNotChatter) {
  Fixture fixture;
  for (int t = 0; t < 4000; ++t) {
    CueInput input = kStroke;
    input.push_n = t % 60 < 30 ? 0.016 : 0.010;  // around the threshold at which humming starts
    fixture.step(input);
  }
  EXPECT_EQ(fixture.count(CueWaveform::kNone), 0);
  EXPECT_LE(fixture.said.size(), 1u + 20u + 4u);
}

TEST(CueLaw, TheMoreImportantEventIsSaidAndNoneLate) {
  Fixture fixture;
  fixture.run(300, kStroke);
  fixture.law.report(CueEvent::kSnapped);
  fixture.law.report(CueEvent::kTook);
  fixture.run(200, kAir);  // lifted at the same moment, which is less important
  EXPECT_EQ(fixture.count(CueWaveform::kSuccess), 1);
  EXPECT_EQ(fixture.count(CueWaveform::kClick), 0);
  EXPECT_EQ(fixture.count(CueWaveform::kRelease), 0);
  // The event is 200 ms older than the next step, so it is dropped.
  fixture.law.report(CueEvent::kRefused);
  fixture.step(kAir, 200 * kMs);
  EXPECT_EQ(fixture.count(CueWaveform::kError), 0);
  fixture.law.report(CueEvent::kRefused);
  fixture.step(kAir);
  EXPECT_EQ(fixture.count(CueWaveform::kError), 1);
  fixture.law.report(CueEvent::kRefused);
  fixture.run(150, kAir);
  EXPECT_EQ(fixture.count(CueWaveform::kError), 1) << "the same one at once again";
}

TEST(CueLaw, ATimeThatRunsBackIsNoTime) {
  Fixture fixture;
  fixture.run(200, kStroke);
  const std::size_t before = fixture.said.size();
  CueInput input = kStroke;
  for (const std::int64_t t : {INT64_MAX, INT64_MIN, std::int64_t{0}, INT64_MIN, INT64_MAX}) {
    input.time_ns = t;
    const auto cue = fixture.law.step(input);
    if (cue) {
      EXPECT_LE(cue->intensity, 1.0);
    }
  }
  EXPECT_LE(fixture.said.size(), before + 5);
}

TEST(CueLaw, ResetPlaysNothingAndKeepsTheFeel) {
  Fixture fixture;
  fixture.law.set_feel(cue_feel_of(*find_medium("eraser"), *find_surface("paper")));
  fixture.run(300, kStroke);
  fixture.law.reset();
  fixture.said.clear();
  fixture.run(300, kStroke);
  ASSERT_GE(fixture.said.size(), 2u);
  EXPECT_EQ(fixture.said[0].cue.waveform, CueWaveform::kPress);
  EXPECT_EQ(fixture.said[1].cue.waveform, CueWaveform::kEraser);
}

/// The test uses any input at any rate.
RC_GTEST_PROP(CueLaw, IsBoundedInRateAndIntensityAndDeterministic, ()) {
  Fixture fixture, again;
  const int steps = *rc::gen::inRange(50, 600);
  for (int i = 0; i < steps; ++i) {
    CueInput input;
    input.touches = *rc::gen::inRange(0, 3) > 0;
    input.height_mm = input.touches ? 0.0 : 0.05 * *rc::gen::inRange(0, 20);
    input.speed_mm_per_s = *rc::gen::element(0.0, 1.0, 5.0, 80.0, 300.0, 1e300, std::nan(""));
    input.push_n = *rc::gen::element(0.0, 0.01, 0.5, 3.0, 1e300, std::nan(""));
    const std::int64_t after_ns = *rc::gen::inRange(0, 40) * kMs / 2;
    const int event = *rc::gen::inRange(0, 24);
    for (Fixture* d : {&fixture, &again}) {
      if (event < 4) d->law.report(static_cast<CueEvent>(event));
      d->step(input, after_ns);
    }
  }
  RC_ASSERT(fixture.said.size() == again.said.size());
  std::array<std::int64_t, 16> last{};
  last.fill(-1'000'000'000);
  for (std::size_t i = 0; i < fixture.said.size(); ++i) {
    const auto& [time_ns, cue] = fixture.said[i];
    RC_ASSERT(cue == again.said[i].cue);
    RC_ASSERT(cue.intensity >= 0.0);
    RC_ASSERT(cue.intensity <= 1.0);
    if (i > 0) RC_ASSERT(time_ns - fixture.said[i - 1].time_ns >= CueLaw::kMinApartNs);
    if (cue.waveform == CueWaveform::kNone || is_continuous(cue.waveform)) continue;
    std::int64_t& same = last[static_cast<std::size_t>(cue.waveform)];
    RC_ASSERT(time_ns - same >= CueLaw::kSameApartNs);
    same = time_ns;
  }
}

/// The same stroke gives the same humming at 1 kHz, 250 Hz and 60 Hz.
TEST(CueLaw, FeelsTheSameAtAnyRate) {
  std::vector<double> levels;
  for (const int step_ms : {1, 4, 16}) {
    Fixture fixture;
    fixture.run(800, kStroke, step_ms);
    ASSERT_FALSE(fixture.said.empty());
    levels.push_back(fixture.said.back().cue.intensity);
    EXPECT_GE(fixture.count(CueWaveform::kPencil), 3);
  }
  EXPECT_NEAR(levels[0], levels[1], 0.01);
  EXPECT_NEAR(levels[0], levels[2], 0.01);
}

}  // namespace
}  // namespace felt::cue_law_test
