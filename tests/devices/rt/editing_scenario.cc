#include "tests/devices/rt/editing_scenario.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "felt/devices/simulated/simulated_stylus.h"
#include "felt/session/session.h"

namespace felt::rt_test {
namespace {

constexpr int kEditTicks = 4;  // the edit side runs at every fourth tick

// One gesture: the hand hovers above the first point of `way`, presses, moves along the other
// points and lifts.
struct Task {
  std::string tool;
  std::array<Point, 4> way;
  const char* option = nullptr;  // of the tool, set before the gesture; null: none
  const char* choice = nullptr;  // value of `option`
};
constexpr int kHoverTicks = 150, kLandTicks = 100, kWayTicks = 600, kLiftTicks = 200;
constexpr int kTaskTicks = kHoverTicks + kLandTicks + kWayTicks + kLiftTicks;

constexpr std::array<Point, 4> kOut{{{40, 30}, {41, 35}, {43, 40}, {45, 46}}};
constexpr std::array<Point, 4> kAlong{{{22, 30}, {40, 30}, {60, 30}, {78, 30}}};
constexpr std::array<Point, 4> kAcross{{{34, 26}, {34, 36}, {33, 44}, {32, 54}}};
constexpr std::array<Point, 4> kRound{{{15, 24}, {46, 24}, {46, 56}, {15, 56}}};

constexpr std::array<Point, 4> kFromEnd{{{80, 30}, {81, 35}, {81, 41}, {80, 46}}};

/// Returns the points of a typical gesture for this kind of path.
std::array<Point, 4> way_of(ToolPath path) {
  switch (path) {
    case ToolPath::kAlong:
      return kAlong;
    case ToolPath::kFree:
    case ToolPath::kAcross:
      return kAcross;
    case ToolPath::kAround:
      return kRound;
    case ToolPath::kFromEnd:
      return kFromEnd;
    case ToolPath::kAway:
      break;
  }
  return kOut;
}

/// Returns a task for every mode that has its own force, then one task for each other tool.
std::vector<Task> all_tasks() {
  std::vector<Task> tasks = {{"pull", kOut, "mode", "brush"},
                             {"pull", kOut, "mode", "grab"},
                             {"pull", kAcross, "mode", "push"},
                             {"pull", kOut, "mode", "sweep"},
                             {"smooth", kAlong},
                             {"width", kAlong, "mode", "brush"},
                             {"width", kAlong, "mode", "retrace"},
                             {"width", kOut, "mode", "scale"},
                             {"eraser", kAcross, "mode", "touched"},
                             {"eraser", kAcross, "mode", "crossing"},
                             {"lasso", kRound, "take", "points"},
                             {"transform", kOut, "mode", "move"},
                             {"transform", kOut, "mode", "rotate"},
                             {"transform", kOut, "mode", "scale"},
                             {"connect", kFromEnd},
                             {"pencil", kAcross}};
  for (const auto& tool : make_tools()) {
    const bool is_listed = std::any_of(
        tasks.begin(), tasks.end(), [&](const Task& task) { return task.tool == tool->info().id; });
    if (!is_listed) tasks.push_back({std::string(tool->info().id), way_of(tool->use().path)});
  }
  return tasks;
}

// Returns a wavy horizontal line of eight segments at y = `y_mm`.
StrokePtr line_at(double y_mm) {
  constexpr int kSegments = 8;
  constexpr double kStepMm = 7.5;
  StrokeData data;
  for (int i = 0; i <= kSegments; ++i) {
    const Point at{20.0 + kStepMm * i, y_mm + (i % 2 == 0 ? 0.0 : 1.5)};
    if (i > 0) data.points.push_back(at - Vec{kStepMm / 3.0, 0.0});
    data.points.push_back(at);
    if (i < kSegments) data.points.push_back(at + Vec{kStepMm / 3.0, 0.0});
  }
  data.joints.assign(kSegments - 1, JointKind::kSmooth);
  data.widths = {{0.0, 0.6}, {kSegments, 1.8}};
  return std::make_shared<const Stroke>(Stroke::create(std::move(data)).value());
}

Document small_drawing() {
  return document_of(std::array{line_at(30.0), line_at(50.0)});
}

class EditingSession final : public Session {
 public:
  EditingSession()
      : stylus_(*find_stylus_preset("touch")),
        session_(make_tools(), {.device = stylus_.capabilities(),
                                .document = small_drawing(),
                                .on_event = {},
                                .on_edit = {}}) {
    ServoOptions options;
    options.period_ns = stylus_.capabilities().period_ns;
    options.limits = limits_for(stylus_.capabilities());
    servo_ = std::make_unique<Servo>(stylus_, options);
    servo_->arm();
  }

  Servo& servo() override { return *servo_; }

  void edit(int tick, std::int64_t now_ns) override {
    const int phase = tick % kTaskTicks;
    const Task& task = tasks_[static_cast<std::size_t>(tick / kTaskTicks) % tasks_.size()];
    if (phase == 0) begin(task, now_ns);
    stylus_.aim(aim_of(task, phase), {}, 0);
    if (tick % kEditTicks != 0) return;
    PenSample sample;
    while (servo_->for_edit().pop(sample)) (void)session_.sample(sample);
    while (servo_->for_autosave().pop(sample)) {
    }
    servo_->heartbeat(now_ns);
    servo_->publish(session_.force());
  }

 private:
  void begin(const Task& task, std::int64_t now_ns) {
    while (session_.history().can_undo()) {
      if (!session_.apply({now_ns, UndoEvent{}})) break;
    }
    (void)session_.apply({now_ns, SelectTool{task.tool}});
    if (!task.option) return;
    const std::string id = task.tool + "." + task.option;
    (void)session_.apply({now_ns, SetOption{id, std::string(task.choice)}});
  }

  static Vec3 aim_of(const Task& task, int phase) {
    const int on_way = std::clamp(phase - kHoverTicks - kLandTicks, 0, kWayTicks);
    const double along = 3.0 * on_way / kWayTicks;
    const auto leg = std::min<std::size_t>(static_cast<std::size_t>(along), 2);
    const Point at = lerp(task.way[leg], task.way[leg + 1], along - static_cast<double>(leg));
    const bool is_down = phase >= kHoverTicks && phase < kHoverTicks + kLandTicks + kWayTicks;
    return {at.x, at.y, is_down ? -4.0 : 4.0};
  }

  SimulatedStylus stylus_;
  felt::Session session_;
  std::unique_ptr<Servo> servo_;
  const std::vector<Task> tasks_ = all_tasks();
};

}  // namespace

std::unique_ptr<Session> make_editing_session() {
  return std::make_unique<EditingSession>();
}

}  // namespace felt::rt_test
