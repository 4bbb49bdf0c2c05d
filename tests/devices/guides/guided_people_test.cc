// Simulated people draw along the guides of a drawing (docs/design/forces.md#guides-of-a-drawing).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "felt/base/constants.h"
#include "felt/base/random.h"
#include "felt/devices/simulated/feedback_hand.h"
#include "felt/devices/simulated/scripted_hand.h"
#include "felt/geometry/polyline.h"
#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/rt/servo.h"
#include "felt/rt/virtual_clock.h"
#include "felt/tools/guided_feel.h"
#include "felt/tools/scene.h"
#include "felt/tools/stroke_guide.h"
#include "hovering_guide.h"

namespace felt::guided_people_test {
namespace {

constexpr Point kMiddle{80.0, 80.0};
constexpr double kPencilStrength = 0.6;  // the default of pencil.strength

/// The measurements of a drawing; distances are those from `path`.
struct Drawing {
  double rms_mm = 0.0, max_mm = 0.0;
  double spread_mm = 0.0;  ///< standard deviation of the signed distance
  double shown_mm = 0.0;   ///< RMS distance from the path that the guide holds to, and shows
  double mean_n = 0.0, max_n = 0.0, last_n = 0.0;  ///< of the guide
  double energy_mj = 0.0;                          ///< work of the guide on the hand
  double lead_mj = 0.0;  ///< the part of it that a force along the path does
  double sent_mj = 0.0;  ///< work of the device in the plane, with the friction of the surface
  double air_mj = 0.0;   ///< work of the device on a pen in the air
};

/// What a person draws: a planned movement, and the path from which distances are measured, from a
/// distance along the plan on.
struct Task {
  std::vector<Point> plan, path;
  DrawingGuidePtr guide;  ///< null: without a guide
  double from_x_mm = -1e9;
  /// If true, the touch chooses the path of the guide. Then the errors are those from the path that
  /// the guide shows; without a guide, those from the best parallel or concentric path.
  bool is_through_touch = false;
  double hover_mm = HandScriptOptions{}.hover_mm;  ///< height of the pen between strokes
  std::vector<Point> before{};                     ///< a stroke that is drawn first; empty: none

  [[nodiscard]] double error_mm(const Drawing& drawing) const {
    if (!is_through_touch) return drawing.rms_mm;
    return guide ? drawing.shown_mm : drawing.spread_mm;
  }
};

/// What the eyes of a person compare the pen with: the planned path, or the guide on the page.
enum class Eyes : std::uint8_t { kOnPlan, kOnGuide };

/// Measures the ticks of a drawing.
class Watch {
 public:
  explicit Watch(const Task& task) : task_(task) {}

  void add(const TickReport& tick) {
    const Point pen = on_page(tick.sample.position);
    const Vec moved = has_last_ ? pen - last_ : Vec{};
    last_ = pen;
    has_last_ = true;
    if (!in_contact(tick.sample)) {
      out_.air_mj += tick.sent.x * moved.x + tick.sent.y * moved.y;
      return;
    }
    if (pen.x < task_.from_x_mm) return;
    const PolylineNearest near = nearest_on_polyline(task_.path, pen);
    const double away_mm = std::sqrt(near.distance_squared);
    const Vec along = task_.path[near.index + 1] - task_.path[near.index];
    squares_ += near.distance_squared;
    sum_ += std::copysign(away_mm, cross(along, pen - near.point));
    ++ticks_;
    out_.max_mm = std::max(out_.max_mm, away_mm);
    out_.last_n = 0.0;
    out_.sent_mj += tick.sent.x * moved.x + tick.sent.y * moved.y;
    for (const ForceTerms::Term& term : tick.terms) {
      if (std::string_view(term.name) != "guide") continue;
      const Vec force{term.force.x, term.force.y}, path = normalized(along);
      out_.last_n = norm(term.force);
      out_.mean_n += out_.last_n;
      out_.max_n = std::max(out_.max_n, out_.last_n);
      out_.energy_mj += dot(force, moved);
      out_.lead_mj += dot(force, path) * dot(moved, path);
    }
  }
  /// Adds the distance from the path that the guide shows.
  void add_shown(Point pen, double distance_mm) {
    if (pen.x < task_.from_x_mm) return;
    shown_squares_ += distance_mm * distance_mm;
    ++shown_ticks_;
  }
  Drawing drawing() {
    const double mean_mm = sum_ / std::max(ticks_, 1.0);
    out_.shown_mm = std::sqrt(shown_squares_ / std::max(shown_ticks_, 1.0));
    out_.rms_mm = std::sqrt(squares_ / std::max(ticks_, 1.0));
    out_.spread_mm = std::sqrt(std::max(0.0, out_.rms_mm * out_.rms_mm - mean_mm * mean_mm));
    out_.mean_n /= std::max(ticks_, 1.0);
    return out_;
  }

 private:
  const Task& task_;
  Drawing out_;
  double squares_ = 0.0, sum_ = 0.0, ticks_ = 0.0, shown_squares_ = 0.0, shown_ticks_ = 0.0;
  Point last_;
  bool has_last_ = false;
};

/// Returns a number of trials: that of an environment variable, or `usual`.
std::size_t trials_of(const char* variable, std::size_t usual) {
  const char* text = std::getenv(variable);
  return text ? std::strtoul(text, nullptr, 10) : usual;
}

/// Returns the height below which the guides pull a pen in the air: 0 unless FELT_GUIDE_HOVER_MM
/// says otherwise.
double guided_height_mm() {
  return static_cast<double>(trials_of("FELT_GUIDE_HOVER_MM", 0));
}

/// Returns the aims of a person who draws the strokes of a task.
std::vector<TimedAim> aims_of(const Person& person, const Task& task, std::uint64_t trial,
                              HandScriptOptions options) {
  options.hover_mm = task.hover_mm;
  std::vector<RecordedPath> plans;
  if (!task.before.empty()) plans.push_back(plan_movement(person, task.before, trial));
  plans.push_back(plan_movement(person, task.plan, trial));
  return script_hand(plans, options);
}

/// Lets a person draw with a simulated device, the haptic loop and the forces of the pencil.
Drawing draw(const Person& person, const Task& task, Eyes eyes, std::string_view device = "premium",
             std::uint64_t trial = 0) {
  StylusPreset preset = *find_stylus_preset(device);
  center_workspace(preset.capabilities, kMiddle);
  const Capabilities& capabilities = preset.capabilities;
  const auto hand = std::make_unique<FeedbackHand>(preset, person);
  const auto servo = std::make_unique<Servo>(
      *hand, ServoOptions{.period_ns = capabilities.period_ns, .limits = limits_for(capabilities)});
  const SurfaceMaterial& paper = surface_materials()[0];
  Medium pencil = scaled_medium(media()[0], kPencilStrength, kPencilStrength);
  if (task.guide) pencil = guided_medium(pencil);
  const SurfaceForce surface =
      make_surface_force(paper, pencil, capabilities, surface_grain(paper));

  HandScriptOptions options = script_options_for(preset, person.grip());
  set_surface(options, paper, capabilities, &pencil);
  const std::vector<TimedAim> aims = aims_of(person, task, trial, options);
  std::vector<DrawingGuidePtr> guides;
  if (task.guide) guides.push_back(task.guide);
  const Document document;
  StrokeGuide guide;
  VirtualClock clock(*servo);
  Watch watch(task);
  HoveringGuide hovering{{}, guided_height_mm()};
  servo->publish(ForceModel(Compose(surface, hovering)));
  servo->arm();
  const std::int64_t end_ns = aims.back().time_ns + std::llround(1e9 * person.preview_s);
  std::size_t next = 0;
  while (clock.next_ns() < end_ns) {
    for (; next < aims.size() && aims[next].time_ns <= clock.next_ns(); ++next) {
      hand->aim(Aim{aims[next].target_mm, aims[next].pressure});
    }
    const TickReport& tick = clock.tick();
    watch.add(tick);
    const PenSample guided = hovering.lowered(tick.sample);
    guide.update(guided, in_contact(guided), guides, document, guide_spring_for(capabilities));
    if (guide.force() && in_contact(tick.sample)) {
      const Point pen = on_page(tick.sample.position);
      const Vec error = pen - guide.force()->nearest(pen);
      watch.add_shown(pen, norm(error));
      if (eyes == Eyes::kOnGuide) hand->see(error);
    }
    hovering.guide = guide.force() ? *guide.force() : Guide();
    servo->publish(ForceModel(Compose(surface, hovering)));
  }
  return watch.drawing();
}

std::vector<Point> points_along(int count, const std::function<Point(double)>& at) {
  std::vector<Point> points;
  for (int i = 0; i <= count; ++i) points.push_back(at(double(i) / count));
  return points;
}

DrawingGuidePtr made(DrawingGuide guide) {
  return std::make_shared<const DrawingGuide>(std::move(guide));
}

Task line_task() {
  const auto path = points_along(200, [](double t) { return Point{20.0 + 120.0 * t, 80.0}; });
  return {path, path, made({.kind = DrawingGuideKind::kLine, .origin = {0.0, 80.0}})};
}
Task circle_task() {
  const auto path = points_along(200, [](double t) {
    return kMiddle + 30.0 * Vec{std::sin(kTau * t), -std::cos(kTau * t)};
  });
  Task task{path, path, made({.kind = DrawingGuideKind::kCompass, .origin = kMiddle})};
  task.is_through_touch = true;
  return task;
}
Task ellipse_task() {
  const auto path = points_along(300, [](double t) {
    return kMiddle + Vec{40.0 * std::sin(kTau * t), -20.0 * std::cos(kTau * t)};
  });
  return {path, path,
          made({.kind = DrawingGuideKind::kEllipse,
                .origin = kMiddle,
                .size_mm = 40.0,
                .second_mm = 20.0})};
}
Task perspective_task() {
  Task task = line_task();
  task.is_through_touch = true;
  task.guide = made({.kind = DrawingGuideKind::kPerspective, .points = {{600.0, 80.0}}});
  return task;
}
/// A wave, as a teacher drew it with 25 mm/s.
Task teacher_task() {
  const auto path = points_along(300, [](double t) {
    return Point{20.0 + 120.0 * t, 80.0 + 15.0 * std::sin(2.0 * kTau * t)};
  });
  DrawingGuide guide{.kind = DrawingGuideKind::kTeacher, .points = path};
  for (std::size_t i = 0; i < path.size(); ++i) guide.times_ms.push_back(20.0 * double(i));
  return {path, path, made(std::move(guide))};
}
/// The person comes from the free side of a ruler, and pushes against it by aiming beyond it.
Task ruler_task(double push_mm) {
  Task task = line_task();
  for (Point& p : task.plan) {
    const double come = std::clamp((p.x - 20.0) / 12.0, 0.0, 1.0);
    p.y += -1.5 + (1.5 + push_mm) * come;
  }
  task.guide = made({.kind = DrawingGuideKind::kRuler, .origin = {0.0, 80.0}, .size_mm = 160.0});
  task.from_x_mm = 36.0;
  return task;
}

/// A person's way to draw with a guide.
struct Manner {
  const char* name;
  Eyes eyes = Eyes::kOnGuide;
  double gives_way = 0.0;
  bool compensates = false;  ///< learns the force of the guide as a load

  [[nodiscard]] Person of(const Person& person) const {
    return compensates ? person : led_by_a_guide(person, gives_way);
  }
};
constexpr Manner kHoldsThePlan{"holds the plan", Eyes::kOnPlan, 0.0, true};
constexpr Manner kYields{"gives way by half", Eyes::kOnGuide, 0.5};

/// The means over people, with the largest forces and energies.
struct Means {
  double error_mm = 0.0, mean_n = 0.0, max_n = 0.0, energy_mj = 0.0;
  double across_mj = 0.0;  ///< of the energy without what a force along the path did
  double lead_mj = 0.0, sent_mj = -1e9;
};
Means means(const Task& task, std::size_t people, const Manner& manner) {
  Means out;
  const double share = 1.0 / double(people);
  for (const Person& person : population(people, 1)) {
    const Drawing one = draw(manner.of(person), task, manner.eyes);
    out.error_mm += share * task.error_mm(one);
    out.mean_n += share * one.mean_n;
    out.max_n = std::max(out.max_n, one.max_n);
    out.energy_mj = std::max(out.energy_mj, one.energy_mj);
    out.across_mj = std::max(out.across_mj, one.energy_mj - one.lead_mj);
    out.lead_mj = std::max(out.lead_mj, one.lead_mj);
    out.sent_mj = std::max(out.sent_mj, one.sent_mj);
  }
  return out;
}

Means free_means(Task task, std::size_t people) {
  task.guide = nullptr;
  task.plan = task.path;
  return means(task, people, kHoldsThePlan);
}

TEST(GuidedPeople, DrawWithAThirdOfTheirErrorAtSmallForces) {
  for (const Task& task : {line_task(), ellipse_task(), circle_task(), perspective_task(),
                           teacher_task(), ruler_task(0.25)}) {
    const Means free = free_means(task, 3), led = means(task, 3, kYields);
    EXPECT_LE(led.error_mm, 0.3 * free.error_mm) << int(task.guide->kind);
    EXPECT_LE(led.mean_n, 0.4);
    EXPECT_LE(led.max_n, 0.8 + 1e-9);
    // A teacher leads along the path, which is work on purpose: at most the force of the lead times
    // the length of the path. Everything else is passive, and so is the device as a whole, because
    // the friction of the pencil takes more.
    const bool leads = task.guide->kind == DrawingGuideKind::kTeacher;
    EXPECT_LE(leads ? led.across_mj : led.energy_mj, 1.0) << int(task.guide->kind);
    EXPECT_LE(led.lead_mj,
              leads ? GuideLaw::teacher(1.0).lead_n * polyline_length(task.path) : 1.0);
    EXPECT_LT(led.sent_mj, 0.0);
  }
}

/// Returns the task of trial i: along a guide, then across it at 50 to 90 degrees, 14 mm away.
Task exit_task(std::uint64_t seed) {
  Random random(seed);
  const double turn = (0.28 + 0.22 * random.between(0.0, 1.0)) * 0.5 * kTau;
  const double side = random.between(0.0, 1.0) < 0.5 ? -1.0 : 1.0;
  const double along_mm = 10.0 + 20.0 * random.between(0.0, 1.0);
  Task task;
  task.guide = made({.kind = DrawingGuideKind::kLine, .origin = {0.0, 80.0}});
  task.path = {{0.0, 80.0}, {200.0, 80.0}};
  const Point corner{50.0 + along_mm, 80.0};
  const Vec away = 14.0 / std::sin(turn) * Vec{std::cos(turn), side * std::sin(turn)};
  for (double t = 0.0; t < 1.0; t += 0.02) task.plan.push_back(lerp({50.0, 80.0}, corner, t));
  task.plan.insert(task.plan.end(), {corner, corner});
  for (double t = 0.05; t <= 1.0; t += 0.05) task.plan.push_back(corner + t * away);
  return task;
}

/// Returns how many of the trials left the guide by 10 mm with at most 0.8 N. Somebody who leaves a
/// guide does not give way to it.
int exits(std::uint64_t first, std::uint64_t trials, double& max_n) {
  int count = 0;
  for (std::uint64_t seed = first; seed < first + trials; ++seed) {
    const Drawing drawing = draw(person_of(seed), exit_task(seed), Eyes::kOnPlan, "premium", seed);
    max_n = std::max(max_n, drawing.max_n);
    if (drawing.max_mm >= 10.0 && drawing.last_n == 0.0 && drawing.max_n <= 0.8 + 1e-9) ++count;
  }
  return count;
}

TEST(GuidedPeople, LeaveAGuideOnPurpose) {
  const std::size_t trials = trials_of("FELT_GUIDE_EXITS", 12);
  double max_n = 0.0;
  const int count = exits(1, trials, max_n);
  std::printf("%d of %zu exits of 10 mm; at most %.3f N\n", count, trials, max_n);
  EXPECT_EQ(static_cast<std::size_t>(count), trials);
  EXPECT_GT(max_n, 0.3);
}

/// A person comes over a guide with the pen in the air, and draws beside it.
Task pass_task(double beyond_mm, double hover_mm) {
  Task task = line_task();
  task.plan = points_along(20, [&](double t) { return Point{80.0 + 20.0 * t, 80.0 + beyond_mm}; });
  task.path = task.plan;
  task.before = points_along(20, [](double t) { return Point{50.0 + 20.0 * t, 70.0}; });
  task.from_x_mm = 75.0;
  task.hover_mm = hover_mm;
  return task;
}

// A guide lets a pen pass that is in the air, however low it is. With FELT_GUIDE_HOVER_MM, prints
// how a guide that acts in the air would hinder these people.
TEST(GuidedPeople, PassOverAGuideInTheAir) {
  const std::size_t people = trials_of("FELT_GUIDE_PEOPLE", 2);
  for (const double hover_mm : {1.0, 2.0, 4.0}) {
    double error_mm = 0.0, air_mj = 0.0;
    for (const Person& person : population(people, 1)) {
      const Drawing one = draw(person, pass_task(4.0, hover_mm), Eyes::kOnPlan);
      error_mm += one.rms_mm / double(people);
      air_mj = std::max(air_mj, one.air_mj);
    }
    std::printf("over a line at %.0f mm, then 4 mm beside it: error %.2f mm, %.2f mJ in the air\n",
                hover_mm, error_mm, air_mj);
    if (guided_height_mm() > 0.0) continue;
    EXPECT_LT(error_mm, 0.4) << hover_mm;
    EXPECT_LT(air_mj, 0.05) << hover_mm;
  }
}

/// Prints the figures of docs/design/forces.md#guides-of-a-drawing.
TEST(GuidedPeople, DrawMoreTrulyWithEveryGuide) {
  const std::size_t people = trials_of("FELT_GUIDE_PEOPLE", 2);
  const auto line = [](const char* name, const char* who, const Means& m, const Means& free) {
    std::printf(
        "%-12s %-18s error %.3f mm = %.2f  mean %.3f N  max %.3f N  %.2f mJ: across %.2f, along "
        "%.2f;"
        " device %.1f mJ\n",
        name, who, m.error_mm, m.error_mm / free.error_mm, m.mean_n, m.max_n, m.energy_mj,
        m.across_mj, m.lead_mj, m.sent_mj);
  };
  for (const auto& [name, task] : {std::pair<const char*, Task>{"line", line_task()},
                                   {"compass", circle_task()},
                                   {"ellipse", ellipse_task()},
                                   {"perspective", perspective_task()},
                                   {"teacher", teacher_task()},
                                   {"ruler 0.25", ruler_task(0.25)},
                                   {"ruler 0.5", ruler_task(0.5)}}) {
    const Means free = free_means(task, people);
    line(name, "free", free, free);
    for (const Manner& manner :
         {kHoldsThePlan, Manner{"looks at the guide", Eyes::kOnGuide, 0.0, true},
          Manner{"no compensation"}, kYields}) {
      line(name, manner.name, means(task, people, manner), free);
    }
    const Means led = means(task, people, kYields);
    EXPECT_LT(led.error_mm, free.error_mm) << name;
    EXPECT_LE(led.max_n, 0.8 + 1e-9) << name;
  }
}

}  // namespace
}  // namespace felt::guided_people_test
