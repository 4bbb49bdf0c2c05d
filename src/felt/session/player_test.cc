#include "felt/session/player.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "felt/base/constants.h"
#include "felt/base/hash.h"
#include "felt/document/visible_strokes.h"
#include "felt/rt/null_device.h"
#include "felt/session/recorder.h"
#include "felt/session/testing/fake_tools.h"

namespace felt::player_test {
namespace {

using ::testing::HasSubstr;

/// A simple force-feedback device: a pen with mass on a spring. A hand holds the spring, and forces
/// push the pen.
class SpringPen final : public Device, public HandInput {
 public:
  SpringPen() {
    capabilities_.max_force_n = 3.3;
    capabilities_.continuous_force_n = 0.88;
    capabilities_.max_stiffness_n_per_m = 800.0;
  }
  [[nodiscard]] std::string_view name() const noexcept override { return "spring"; }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override { return capabilities_; }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override {
    // The pen is critically damped, 0.05 kg on 400 N/m. Uses semi-implicit Euler with steps of 0.1
    // ms.
    for (; time_ns_ + 100'000 <= now_ns; time_ns_ += 100'000) {
      const Vec3 force_n{force_.x, force_.y, force_.z};
      const Vec3 acceleration =
          20.0 * (0.4 * (aim_.target_mm - at_) - 0.00894 * velocity_ + force_n);
      velocity_ += 0.1 * acceleration;  // N/kg = mm/ms^2 * 1e3; 1e-4 s
      at_ += 1e-4 * velocity_;
    }
    return PenSample{now_ns, at_, velocity_, aim_.pressure, aim_.buttons, aim_.tilt_deg};
  }
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override {
    force_ = force;
    written_ = std::max(written_, norm(force));
    return {};
  }
  void stop() noexcept override {
    force_ = {};
    stopped_ = true;
  }
  void aim(const Aim& aim) noexcept override {
    if (!aimed_) at_ = aim.target_mm;
    aimed_ = true;
    aim_ = aim;
  }
  [[nodiscard]] double largest_written_n() const { return written_; }
  [[nodiscard]] bool stopped() const { return stopped_; }

 private:
  Capabilities capabilities_;
  std::int64_t time_ns_ = 0;
  Vec3 at_{0, 0, 20}, velocity_;
  Aim aim_{{0, 0, 20}};
  Force force_;
  double written_ = 0.0;
  bool aimed_ = false, stopped_ = false;
};

/// The results of playing a script.
struct Played {
  Result<PlayReport> report = PlayReport{};
  Document document;
  std::uint64_t forces = 0;  ///< fingerprint of all ticks
  std::vector<Event> recorded;
  std::vector<PenSample> samples;
  std::size_t undo_count = 0;
};

void add(Fnv1a& hash, const Vec3& v) {
  hash.add_value(v.x);
  hash.add_value(v.y);
  hash.add_value(v.z);
}
void add(Fnv1a& hash, const Force& f) {
  add(hash, Vec3{f.x, f.y, f.z});
}
void add(Fnv1a& hash, const TickReport& tick) {
  hash.add_value(tick.sample.time_ns);
  add(hash, tick.sample.position);
  add(hash, tick.sample.velocity);
  add(hash, tick.asked);
  add(hash, tick.sent);
  for (const ForceTerms::Term& term : tick.terms) add(hash, term.force);
}

Played play_on(Device& device, HandInput* hand, const std::vector<Event>& events,
               PlayerOptions options = {}) {
  Played played;
  Fnv1a hash;
  Recorder recorder([&played](std::span<const Event> batch) {
    played.recorded.insert(played.recorded.end(), batch.begin(), batch.end());
  });
  SessionOptions session_options;
  session_options.device = device.capabilities();
  session_options.on_event = std::ref(recorder);
  Session session(fake_tools(), std::move(session_options));
  options.on_tick = [&](const TickReport& tick) {
    add(hash, tick);
    played.samples.push_back(tick.sample);
  };
  Player player(device, hand, session, std::move(options));
  played.report = player.play(events);
  recorder.flush();
  played.document = session.document();
  played.forces = hash.value();
  played.undo_count = session.history().undo_count();
  return played;
}

Played play(const std::vector<Event>& events, PlayerOptions options = {}) {
  SpringPen pen;
  return play_on(pen, &pen, events, std::move(options));
}

template <class What>
void add_line(std::vector<Event>& events, std::int64_t ms, double x, double y) {
  events.push_back({ms * kMs, What{{x, y, 5}, {}, 0}});
  events.push_back({(ms + 60) * kMs, What{{x, y, -1}, {}, 0}});
  events.push_back({(ms + 260) * kMs, What{{x + 20, y + 5, -1}, {}, 0}});
  events.push_back({(ms + 320) * kMs, What{{x + 20, y + 5, 5}, {}, 0}});
}

template <class What>
std::vector<Event> three_lines() {
  std::vector<Event> events;
  add_line<What>(events, 700, 0, 0);
  events.push_back({1100 * kMs, SetOption{"pencil.hard", true}});
  add_line<What>(events, 1300, 0, 10);
  events.push_back({1800 * kMs, UndoEvent{}});
  add_line<What>(events, 2000, 0, 20);
  return events;
}

TEST(Player, DrawsWhatThePenDoes) {
  const Played played = play(three_lines<PenEvent>());
  ASSERT_TRUE(played.report) << played.report.error().message;
  ASSERT_EQ(played.document.stroke_count(), 2U);
  const Stroke& first = *visible_strokes(played.document)[0];
  EXPECT_LT(distance(first.position(0), {0, 0}), 0.2);
  EXPECT_LT(distance(first.position(first.segment_count()), {20, 5}), 0.2);
  EXPECT_EQ(played.report->edits, 4U);
  EXPECT_EQ(played.report->events, 14U);
  EXPECT_EQ(played.report->samples, played.report->ticks);
  EXPECT_EQ(played.report->start_ns, 700 * kMs);
}

/// Sends the script through the loop and the recorder.
TEST(Player, ThePenTiltsAsTheScriptSays) {
  const auto tilt_at_the_end = [](auto pose) {
    pose.tilt_deg = 41.5;
    const Played played = play({{0, pose}, {50 * kMs, pose}});
    EXPECT_TRUE(played.report);
    EXPECT_FALSE(played.recorded.empty());
    for (const Event& event : played.recorded) {
      EXPECT_EQ(std::get<PenEvent>(event.what).tilt_deg, 41.5);
    }
    return played.samples.back().tilt_deg;
  };
  EXPECT_EQ(tilt_at_the_end(PenEvent{{0, 0, 5}, {}, 0}), 41.5);
  EXPECT_EQ(tilt_at_the_end(HandEvent{{0, 0, 5}, {}, 0}), 41.5);
}

TEST(Player, ForcesMoveAHand) {
  const Played with = play(three_lines<HandEvent>());
  PlayerOptions off;
  off.forces = false;
  const Played without = play(three_lines<HandEvent>(), off);
  ASSERT_TRUE(with.report);
  ASSERT_TRUE(without.report);
  const auto deepest = [](const Played& played) {  // in the last line, when forces have engaged
    double z = 0.0;
    for (const PenSample& s : played.samples) {
      if (s.time_ns > 2000 * kMs) z = std::min(z, s.position.z);
    }
    return z;
  };
  EXPECT_EQ(without.report->largest_sent_n, 0.0);
  EXPECT_GT(with.report->largest_sent_n, 0.1);
  EXPECT_LT(deepest(without), -0.9);
  EXPECT_GT(deepest(with), -0.5) << "the wall pushes back";
  EXPECT_EQ(with.document.stroke_count(), 2U);
}

TEST(Player, R51_TheDocumentIsTheSameWithoutForces) {
  const std::vector<Event> script = three_lines<PenEvent>();
  SpringPen pen;
  const Played with = play_on(pen, &pen, script);
  PlayerOptions off;
  off.forces = false;
  SpringPen unarmed;
  const Played without = play_on(unarmed, &unarmed, script, off);
  NullDevice nothing;
  const Played none = play_on(nothing, &nothing, script);
  ASSERT_TRUE(with.report && without.report && none.report);
  EXPECT_GT(with.report->largest_sent_n, 0.1);
  EXPECT_EQ(without.report->largest_sent_n, 0.0);
  EXPECT_EQ(unarmed.largest_written_n(), 0.0);
  EXPECT_GT(with.document.stroke_count(), 0U);
  EXPECT_EQ(with.document, without.document);
  EXPECT_EQ(with.document, none.document);
  EXPECT_EQ(with.undo_count, none.undo_count);
}

TEST(Player, R51_APenThatJumpsDrawsTheSame) {
  // The pen moves 200 mm in 2 ms between strokes. The safety chain removes the forces, but the ink
  // stays.
  std::vector<Event> script;
  for (int i = 0; i < 4; ++i) {
    const std::int64_t ms = 700 + 300 * i;
    script.push_back({ms * kMs, PenEvent{{200.0 * i, 0, 1}, {}, 0}});
    script.push_back({(ms + 20) * kMs, PenEvent{{200.0 * i, 0, -1}, {}, 0}});
    script.push_back({(ms + 278) * kMs, PenEvent{{200.0 * i + 10, 9, -1}, {}, 0}});
    script.push_back({(ms + 298) * kMs, PenEvent{{200.0 * i + 10, 9, 1}, {}, 0}});
  }
  SpringPen pen;
  const Played with = play_on(pen, &pen, script);
  NullDevice nothing;
  const Played none = play_on(nothing, &nothing, script);
  ASSERT_TRUE(with.report && none.report);
  EXPECT_GT(with.report->unread, 0U) << "the chain did object";
  EXPECT_EQ(with.document.stroke_count(), 4U);
  EXPECT_EQ(with.document, none.document);
}

TEST(Player, IsDeterministic) {
  for (const auto& script : {three_lines<PenEvent>(), three_lines<HandEvent>()}) {
    const Played a = play(script), b = play(script);
    ASSERT_TRUE(a.report && b.report);
    EXPECT_EQ(a.forces, b.forces);
    EXPECT_EQ(a.document, b.document);
    EXPECT_EQ(*a.report, *b.report);
    EXPECT_EQ(a.recorded, b.recorded);
  }
}

TEST(Player, PortionsOfTheEditSideChangeNoDocumentOfAPen) {
  const std::vector<Event> script = three_lines<PenEvent>();
  const Played often = play(script, {.edit_period_ns = 1 * kMs});
  for (const std::int64_t portion_ms : {3, 4, 16, 97, 2000}) {
    const Played seldom = play(script, {.edit_period_ns = portion_ms * kMs});
    ASSERT_TRUE(seldom.report);
    EXPECT_EQ(seldom.document, often.document) << portion_ms;
    EXPECT_EQ(seldom.recorded, often.recorded) << portion_ms;
    EXPECT_LT(seldom.report->turns, often.report->turns);
  }
}

TEST(Player, ARecordingGivesTheSameSessionAgain) {
  for (const auto& script : {three_lines<PenEvent>(), three_lines<HandEvent>()}) {
    const Played first = play(script);
    ASSERT_GT(first.document.stroke_count(), 0U);
    Session direct(fake_tools(), {});
    for (const Event& event : first.recorded) ASSERT_TRUE(direct.apply(event));
    EXPECT_EQ(direct.document(), first.document);
    const Played again = play(first.recorded);  // now the script moves the pen
    ASSERT_TRUE(again.report);
    EXPECT_EQ(again.document, first.document);
  }
}

TEST(Player, LosesNoInkOfAnUnfinishedStroke) {
  for (const bool by_hand : {false, true}) {
    std::vector<Event> script = by_hand ? three_lines<HandEvent>() : three_lines<PenEvent>();
    script.pop_back();  // the pen stays down
    const Played cut = play(script);
    ASSERT_TRUE(cut.report);
    EXPECT_EQ(cut.document.stroke_count(), 2U);
    const Stroke& last = *visible_strokes(cut.document)[1];
    EXPECT_LT(distance(last.position(last.segment_count()), {20, 25}), 1.0);
    EXPECT_FALSE(in_contact(cut.samples.back()));
  }
}

TEST(Player, EventsTakeEffectBetweenTheSamplesOfTheirTime) {
  // The tool changes in the middle of a line: the ink drawn so far stays, and no more is added.
  std::vector<Event> script;
  add_line<PenEvent>(script, 0, 0, 0);
  script.insert(script.begin() + 2, {160 * kMs, SelectTool{"eraser"}});
  const Played played = play(script);
  ASSERT_TRUE(played.report);
  ASSERT_EQ(played.document.stroke_count(), 1U);
  const Stroke& stroke = *visible_strokes(played.document)[0];
  EXPECT_NEAR(stroke.position(stroke.segment_count()).x, 9.9, 1e-9) << "the sample of 159 ms";

  // If a pose of the same time precedes the event, the event comes after that sample.
  script.insert(script.begin() + 2, {160 * kMs, PenEvent{{10, 2.5, -1}, {}, 0}});
  const Played behind = play(script);
  ASSERT_EQ(behind.document.stroke_count(), 1U);
  const Stroke& longer = *visible_strokes(behind.document)[0];
  EXPECT_EQ(longer.position(longer.segment_count()).x, 10.0);
}

TEST(Player, RunsAtEveryRate) {
  const std::vector<Event> script = three_lines<HandEvent>();
  for (const std::int64_t period_ns : {200'000, 500'000, 1'000'000, 4'000'000}) {
    const Played played = play(script, {.period_ns = period_ns});
    ASSERT_TRUE(played.report);
    EXPECT_EQ(played.document.stroke_count(), 2U) << period_ns;
    EXPECT_EQ(played.samples[1].time_ns - played.samples[0].time_ns, period_ns);
    EXPECT_EQ(played.report->unread, 0U) << period_ns;
  }
}

TEST(Player, ImportsWhatTheCallerReads) {
  const Played source = play(three_lines<PenEvent>());
  const std::vector<Event> script = {
      {5 * kMs, ImportEvent{"a.ndjson"}}, {9 * kMs, UndoEvent{}}, {10 * kMs, RedoEvent{}}};
  PlayerOptions options;
  options.read_import = [&source](const ImportEvent& event) -> Result<VisibleInk> {
    if (event.path != "a.ndjson") return fail(ErrorCode::kNotFound, event.path);
    return visible_ink(source.document);
  };
  const Played played = play(script, options);
  ASSERT_TRUE(played.report) << played.report.error().message;
  EXPECT_EQ(played.document.stroke_count(), source.document.stroke_count());
  EXPECT_EQ(played.undo_count, 1U);
  EXPECT_EQ(play(script).report.error().message,
            "event 1, at 5 ms: import events can only be handled by the reader of the file");
}

TEST(Player, SaysWhichEventIsWrong) {
  EXPECT_EQ(play({{0, UndoEvent{}}, {2'500'000, SelectTool{"brush"}}}).report.error().message,
            "event 2, at 2.5 ms: no tool \"brush\"; the tools are eraser, pencil");
  EXPECT_EQ(play({{5, UndoEvent{}}, {4, UndoEvent{}}}).report.error().message,
            "event 2, at 0.000004 ms: the time is earlier than that of the previous event");
  SpringPen pen;
  EXPECT_THAT(play_on(pen, nullptr, {{0, HandEvent{}}}).report.error().message,
              HasSubstr("event 1, at 0 ms: hand events need a device with a simulated hand"));
  PlayerOptions options;
  options.longest_ns = kMs;
  EXPECT_EQ(play({{0, UndoEvent{}}, {kMs + 1, UndoEvent{}}}, options).report.error().message,
            "event 2, at 1.000001 ms: the script is longer than 1 ms");
}

TEST(Player, NothingIsPlayedOfNothing) {
  const Played played = play({});
  ASSERT_TRUE(played.report);
  EXPECT_EQ(*played.report, PlayReport{});
}

TEST(Player, CanBeCancelledWithTheInkSoFar) {
  std::vector<Event> script;
  add_line<PenEvent>(script, 0, 0, 0);
  PlayerOptions options;
  int turns = 0;
  options.is_cancelled = [&turns] { return ++turns > 40; };  // 160 ms
  SpringPen pen;
  const Played played = play_on(pen, &pen, script, options);
  ASSERT_TRUE(played.report);
  EXPECT_TRUE(played.report->cancelled);
  EXPECT_TRUE(pen.stopped());
  ASSERT_EQ(played.document.stroke_count(), 1U);
  const Stroke& stroke = *visible_strokes(played.document)[0];
  EXPECT_LT(stroke.position(stroke.segment_count()).x, 11.0);
}

TEST(Player, EndsWithoutForceAndWithThePenInTheAir) {
  SpringPen pen;
  const Played played = play_on(pen, &pen, three_lines<HandEvent>());
  ASSERT_TRUE(played.report);
  EXPECT_TRUE(pen.stopped());
  EXPECT_EQ(played.report->safety.state, SafetyState::kOff);
  EXPECT_EQ(played.report->safety.hard_faults, 0U);
  EXPECT_LE(played.report->end_ns, (2320 + 500) * kMs);
}

TEST(Player, ASecondScriptGoesOnWithTheSession) {
  SpringPen pen;
  Session session(fake_tools(), {.device = pen.capabilities()});
  Player player(pen, &pen, session, {});
  std::vector<Event> script;
  add_line<PenEvent>(script, 0, 0, 0);
  ASSERT_TRUE(player.play(script));
  for (Event& event : script) event.time_ns += 2000 * kMs;
  ASSERT_TRUE(player.play(script));
  EXPECT_EQ(session.document().stroke_count(), 2U);
}

}  // namespace
}  // namespace felt::player_test
