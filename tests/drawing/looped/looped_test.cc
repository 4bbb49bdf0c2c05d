#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "felt/devices/simulated/samples/sample_sets.h"
#include "felt/document/edit_builder.h"
#include "felt/replay/replay_machine.h"
#include "felt/stroke/fit/ink_fitter.h"

namespace felt::looped_test {
namespace {

/// The head ends and the body begins between these heights.
constexpr double kNeckMm = 66.0;
constexpr Point kMiddleOfHead{59.0, 38.0};

/// Returns the sample cat, as the program opens it.
Document cat() {
  Document document;
  EditBuilder builder(document);
  InkFitter fitter{InkFitOptions{}};
  const std::vector<SampleSet> sets = make_sample_sets();
  for (const RecordedStroke& line : sets.front().strokes) {
    fitter.begin();
    for (const HandSample& s : line.samples) fitter.push({s.position, s.pressure, s.time_ns});
    fitter.end();
    Result<Stroke> stroke = fitter.stroke();
    EXPECT_TRUE(stroke);
    if (stroke) builder.add(document.layers().front().id, std::make_shared<const Stroke>(*stroke));
  }
  const Edit edit = std::move(builder).build("Cat");
  EXPECT_TRUE(document.apply(edit));
  return document;
}

/// A loop around the head, drawn by hand: through the neck, where the lines of the body begin.
const std::vector<Point> kLoop = {{30, 8},    {60, 4},  {92, 6},  {96, 40}, {92, 60}, {76, 64},
                                  {59, 62.4}, {42, 64}, {24, 62}, {24, 40}, {29, 10}};

/// A session in which a simulated hand loops and turns.
class Hand {
 public:
  explicit Hand(std::string_view device = "touch")
      : machine_(replay_settings(*find_stylus_preset(device), typical_hand(), true, {}, {}), cat(),
                 {.tick = [this](const ReplayTick& tick) { return watch(tick); }}) {}

  void option(const char* id, const char* value) { EXPECT_TRUE(machine_.set_option(id, value)); }
  void loop(const std::vector<Point>& corners) {
    add(SelectTool{"lasso"});
    draw(corners, 130.0);
  }
  /// Turns what is selected around the middle of the head.
  void turn(double degrees) {
    add(SelectTool{"transform"});
    add(SetOption{"transform.mode", std::string("rotate")});
    std::vector<Point> arc;
    for (int k = 0; k <= 30; ++k) {
      const double angle = std::numbers::pi / 180.0 * (degrees * k / 30.0 - 20.0);
      arc.push_back(kMiddleOfHead + 22.0 * Vec{std::cos(angle), std::sin(angle)});
    }
    turn_starts_ms_ = ms_;
    draw(arc, 8.0);
  }
  const Document& play() {
    EXPECT_TRUE(machine_.play());
    return machine_.session().document();
  }
  [[nodiscard]] const Session& session() const { return machine_.session(); }
  /// The largest force along the page while the selection was turned.
  [[nodiscard]] double turning_n() const { return turning_n_; }

 private:
  template <class What>
  void add(What what) {
    EXPECT_TRUE(machine_.add({std::llround(1e6 * ms_), std::move(what)}));
  }
  void aim(Point p, double z) {
    HandEvent event;
    event.target = {p.x, p.y, z};
    add(event);
  }
  void draw(const std::vector<Point>& path, double mm_per_s) {
    aim(path.front(), 5.0);
    ms_ += 700.0;
    aim(path.front(), 5.0);
    ms_ += 150.0;
    aim(path.front(), -2.0);
    for (std::size_t i = 1; i < path.size(); ++i) {
      ms_ += 1000.0 * distance(path[i - 1], path[i]) / mm_per_s;
      aim(path[i], -2.0);
    }
    ms_ += 200.0;
    aim(path.back(), -2.0);
    ms_ += 150.0;
    aim(path.back(), 6.0);
    ms_ += 100.0;
  }
  Result<void> watch(const ReplayTick& tick) {
    if (1e-6 * static_cast<double>(tick.report.sample.time_ns) < turn_starts_ms_) return {};
    for (const ForceTerms::Term& term : tick.report.terms) {
      if (std::string_view(term.name) != "tether") continue;
      turning_n_ = std::max(turning_n_, std::hypot(term.force.x, term.force.y));
    }
    return {};
  }

  ReplayMachine machine_;
  double ms_ = 0.0, turn_starts_ms_ = 1e12, turning_n_ = 0.0;
};

/// Returns the largest distance by which control points below the neck moved.
double body_moved_mm(const Document& before, const Document& after) {
  double moved = 0.0;
  for (const StrokeId id : before.layers().front().strokes) {
    const auto &from = before.find(id)->data().points, &to = after.find(id)->data().points;
    EXPECT_EQ(from.size(), to.size());
    for (std::size_t i = 0; i < std::min(from.size(), to.size()); ++i) {
      if (from[i].y > kNeckMm) moved = std::max(moved, distance(from[i], to[i]));
    }
  }
  return moved;
}

TEST(LoopedPart, R65_TheHeadOfTheCatTurnsAgainstItsBodyWithTheDefaults) {
  const Document before = cat();
  for (const double degrees : {15.0, -15.0}) {
    for (const std::string_view device : {"touch", "premium"}) {
      SCOPED_TRACE(std::string(device) + std::to_string(degrees));
      Hand hand(device);
      hand.loop(kLoop);
      hand.turn(degrees);
      const Document& after = hand.play();
      EXPECT_GE(hand.turning_n(), 0.2);
      EXPECT_LE(hand.turning_n(), 1.0);
      EXPECT_LE(body_moved_mm(before, after), 0.05);
      // The left ear turned with the head.
      const StrokeId ear = before.layers().front().strokes.front();
      EXPECT_GT(distance(before.find(ear)->data().points[6], after.find(ear)->data().points[6]),
                2.0);
    }
  }
}

TEST(LoopedPart, R65_LinesThatLieInTheLoopAreTakenWhole) {
  Hand hand;
  hand.loop(kLoop);
  const Document& document = hand.play();
  const Selection& taken = hand.session().selection();
  std::size_t whole = 0, in_part = 0;
  for (const StrokeId id : document.layers().front().strokes) {
    const Stroke& stroke = *document.find(id);
    const bool is_in_head =
        std::all_of(stroke.data().points.begin(), stroke.data().points.end(),
                    [](Point p) { return p.x > 32 && p.x < 90 && p.y > 9 && p.y < 58; });
    EXPECT_TRUE(!is_in_head || taken.is_whole(id)) << id.value;
    whole += taken.is_whole(id) ? 1 : 0;
    in_part += taken.find(id) && !taken.is_whole(id) ? 1 : 0;
  }
  EXPECT_GE(whole, 25u);
  EXPECT_GE(in_part, 2u) << "the flanks";
}

TEST(LoopedPart, R65_TheOptionTakesWholeLines) {
  Hand hand;
  hand.option("lasso.take", "strokes");
  hand.loop(kLoop);
  hand.turn(15.0);
  hand.play();
  for (const auto& [id, marks] : hand.session().selection().strokes()) {
    EXPECT_TRUE(hand.session().selection().is_whole(id));
  }
  EXPECT_EQ(hand.turning_n(), 0.0) << "no line leaves the selection";
}

}  // namespace
}  // namespace felt::looped_test
