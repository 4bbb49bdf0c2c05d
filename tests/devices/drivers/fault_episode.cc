// The course of a case. fault_rules.cc has the rules that it must keep.
#include "tests/devices/drivers/fault_episode.h"
#include "felt/base/constants.h"

#include <algorithm>
#include <array>
#include <utility>

#include "felt/geometry/rect.h"

namespace felt {
namespace {

constexpr std::int64_t kSleepNs = 600'000 * kMs;
constexpr std::int64_t kTurnNs = 4 * kMs;
constexpr std::int64_t kLandNs = 80 * kMs, kDragNs = 700 * kMs;
constexpr double kHoverMm = 4.0, kPressMm = -4.0;
constexpr double kMarginMm = 6.0;
constexpr Rect kDrawing{18.0, 24.0, 84.0, 58.0};  // holds the hand and the drawing

using Way = std::array<Point, 4>;

Way way_of(ToolPath path) {
  switch (path) {
    case ToolPath::kFree:
      return {{{25, 39}, {42, 42}, {60, 40}, {78.5, 49}}};
    case ToolPath::kAlong:
      return {{{22, 30}, {40, 30}, {60, 30}, {78, 30}}};
    case ToolPath::kAcross:
      return {{{34, 26}, {34, 36}, {33, 44}, {32, 54}}};
    case ToolPath::kAround:
      return {{{20, 25}, {46, 26}, {46, 56}, {20, 56}}};
    case ToolPath::kFromEnd:
      return {{{80, 30}, {81, 35}, {81, 41}, {80, 46}}};
    case ToolPath::kAway:
      break;
  }
  return {{{40, 30}, {41, 35}, {43, 40}, {45, 46}}};
}

Point along(const Way& way, double share) {
  const double at = 3.0 * std::clamp(share, 0.0, 1.0);
  const auto leg = std::min<std::size_t>(static_cast<std::size_t>(at), 2);
  return lerp(way[leg], way[leg + 1], at - static_cast<double>(leg));
}

double share(std::int64_t at_ns, std::int64_t from_ns, std::int64_t lasts_ns) {
  return std::clamp(static_cast<double>(at_ns - from_ns) / static_cast<double>(lasts_ns), 0.0, 1.0);
}

// A malicious force model that changes direction every 8 ms.
struct BadForce {
  double newtons;
  Force operator()(const PenSample& sample, ForceMemory&) const noexcept {
    const double sign = sample.time_ns / (8 * kMs) % 2 == 0 ? 1.0 : -1.0;
    return {sign * newtons, 0.5 * newtons, -sign * newtons};
  }
  [[nodiscard]] static Slopes slopes() noexcept { return {}; }
};

// Returns a wavy line of eight segments at this height of the drawing.
StrokePtr line_at(double y_mm, double scale, Vec shift) {
  constexpr int kSegments = 8;
  StrokeData data;
  const auto put = [&](double x, double y) {
    data.points.push_back({scale * x + shift.x, scale * y + shift.y});
  };
  for (int i = 0; i <= kSegments; ++i) {
    const double x = 20.0 + 7.5 * i, y = y_mm + (i % 2 == 0 ? 0.0 : 1.5);
    if (i > 0) put(x - 2.5, y);
    put(x, y);
    if (i < kSegments) put(x + 2.5, y);
  }
  data.joints.assign(kSegments - 1, JointKind::kSmooth);
  data.widths = {{0.0, 0.6}, {kSegments, 1.8}};
  return std::make_shared<const Stroke>(Stroke::create(std::move(data)).value());
}

}  // namespace

FaultEpisode::FaultEpisode(const BenchMaker& make, const FaultCase& fault)
    : fault_(fault), random_(fault.seed + 77) {
  std::vector<FaultWindow> windows;
  FaultWindow window{fault.fault, fault.at_ns, fault.at_ns + fault.lasts_ns, fault.amount};
  const bool unplugs =
      fault.happening == Happening::kSuspend || fault.happening == Happening::kOtherModel;
  if (unplugs) window.fault = InjectedFault::kUnplugged;
  if (fault.happening == Happening::kSuspend) {
    window.from_ns += kSleepNs;
    window.until_ns += kSleepNs;
  }
  if (unplugs || fault.happening == Happening::kDeviceFault) windows.push_back(window);
  bench_ = make(std::move(windows));
  device_.emplace(*bench_);

  const Capabilities& space = bench_->world().preset().capabilities;
  const Vec3 low = space.workspace_min, high = space.workspace_max;
  scale_ = std::min({1.0, (high.x - low.x - 2.0 * kMarginMm) / kDrawing.width(),
                     (high.y - low.y - 2.0 * kMarginMm) / kDrawing.height()});
  const bool fits = low.x + kMarginMm <= kDrawing.x0 && high.x - kMarginMm >= kDrawing.x1 &&
                    low.y + kMarginMm <= kDrawing.y0 && high.y - kMarginMm >= kDrawing.y1;
  if (!fits) {
    shift_ = {0.5 * (low.x + high.x) - scale_ * 0.5 * (kDrawing.x0 + kDrawing.x1),
              0.5 * (low.y + high.y) - scale_ * 0.5 * (kDrawing.y0 + kDrawing.y1)};
  }
  start_ = document_of(std::array{line_at(30.0, scale_, shift_), line_at(50.0, scale_, shift_)});
  session_ = std::make_unique<Session>(
      make_tools(), SessionOptions{.device = device_->capabilities(), .document = start_});
  (void)session_->apply({0, SetOption{"pencil.snap", std::string("force")}});
  (void)session_->apply({0, SelectTool{fault.tool}});
  path_ = session_->tool().use().path;
  kind_ = session_->tool().info().kind;
  lift_ns_ =
      std::max(landing_ns(fault.state) + 900 * kMs, fault.at_ns + fault.lasts_ns + 250 * kMs);
  arm_ns_ = lift_ns_ + 300 * kMs;
  // Before its fault, a late service must have answered promptly for a while.
  if (fault.happening == Happening::kDeviceFault && bench_->stays_off_ns(fault.fault) > 0) {
    arm_ns_ += bench_->stays_off_ns(fault.fault);
  }
  ends_ns_ = arm_ns_ + 820 * kMs;
  new_loop();
}

void FaultEpisode::new_loop() {
  ServoOptions options;
  options.period_ns = device_->capabilities().period_ns;
  options.limits = limits_for(device_->capabilities());
  servo_ = std::make_unique<Servo>(*device_, options);
  period_ns_ = servo_->options().period_ns;
  last_state_ = SafetyState::kOff;
  has_last_ = false;
}

/// Returns the position that the hand aims at: down and along the path, up, back, down and along
/// again.
Vec3 FaultEpisode::hand_at(std::int64_t script_ns) const {
  const Way way = way_of(path_);
  const bool is_again = script_ns >= arm_ns_;
  const std::int64_t landing = is_again ? arm_ns_ + 80 * kMs : landing_ns(fault_.state);
  const bool rests = !is_again && fault_.state == PenState::kContact;
  const std::int64_t drag = landing + (rests ? 400 : 150) * kMs;
  double z = kHoverMm + (kPressMm - kHoverMm) * share(script_ns, landing, kLandNs);
  Point at = along(way, share(script_ns, drag, kDragNs));
  if (!is_again && script_ns >= lift_ns_) {
    z = kPressMm + (kHoverMm - kPressMm) * share(script_ns, lift_ns_, kLandNs);
    // The pen moves back above the surface.
    at = along(way, share(lift_ns_, drag, kDragNs) *
                        (1.0 - share(script_ns, lift_ns_ + kLandNs, arm_ns_ - lift_ns_ - kLandNs)));
  }
  return {scale_ * at.x + shift_.x, scale_ * at.y + shift_.y, z};
}

void FaultEpisode::move_hand() {
  bench_->hand().aim(hand_at(script_ns_), {}, 0);
}

/// Runs the edit side's work of a few milliseconds.
void FaultEpisode::turn() {
  if (phase_ == Phase::kDuring && fault_.happening == Happening::kEditSilent) return;
  if (script_ns_ < turn_ns_) return;
  turn_ns_ = script_ns_ + kTurnNs;
  PenSample sample;
  while (servo_->for_edit().pop(sample)) {
    if (in_contact(sample) && is_truthful()) believed_.push_back(sample);
    if (const Result<void> reported = session_->sample(sample); !reported)
      broken(reported.error().message);
  }
  while (servo_->for_autosave().pop(sample)) {
  }
  if (device_->unread() == DeviceFault::kDisconnected && !is_reported_) {
    is_reported_ = true;
    if (const Result<void> done = session_->finish(); !done) broken(done.error().message);
  }
  servo_->heartbeat(now());
  if (phase_ == Phase::kDuring && fault_.happening == Happening::kBadForce) return;
  servo_->publish(session_->force());
}

void FaultEpisode::begin_happening() {
  phase_ = Phase::kDuring;
  switch (fault_.happening) {
    case Happening::kStall:
      script_ns_ += fault_.lasts_ns / period_ns_ * period_ns_;
      break;
    case Happening::kClockStep:
      offset_ns_ += static_cast<std::int64_t>(1e9 * fault_.amount);
      break;
    case Happening::kSuspend:
      offset_ns_ += kSleepNs;
      break;
    case Happening::kUndo:
      (void)session_->apply({now(), UndoEvent{}});
      believed_.clear();
      break;
    case Happening::kOtherTool:
      choose_other_tool();
      break;
    case Happening::kMaterial:
      (void)session_->apply({now(), SetOption{"surface.material", std::string("glass")}});
      break;
    case Happening::kBadForce:
      servo_->publish(ForceModel(BadForce{fault_.amount}));
      break;
    case Happening::kLetGo:
      bench_->world().stylus().hold(std::nullopt);
      break;
    default:
      break;
  }
  since_ns_ = script_ns_;
}

void FaultEpisode::choose_other_tool() {
  const Tool* other =
      session_->first_tool(kind_ == ToolKind::kSelects ? ToolKind::kDraws : ToolKind::kSelects);
  (void)session_->apply({now(), SelectTool{std::string(other->info().id)}});
}

void FaultEpisode::end_happening() {
  phase_ = Phase::kAfter;
  free_ticks_ = 3;
  if (fault_.happening == Happening::kBadForce) servo_->publish(session_->force());
  if (fault_.happening == Happening::kLetGo) bench_->world().stylus().hold(typical_hand());
}

/// While the device is unplugged, the user may try to reconnect, which must fail.
void FaultEpisode::try_too_early() {
  const bool is_unplugged =
      fault_.happening == Happening::kDeviceFault && fault_.fault == InjectedFault::kUnplugged;
  if (!is_unplugged || was_tried_ || fault_.seed % 2 == 0) return;
  if (script_ns_ < fault_.at_ns + fault_.lasts_ns / 2) return;
  if (device_->unread() != DeviceFault::kDisconnected) return;
  was_tried_ = true;
  (void)bench_->reconnect();
  device_->renew();
  was_gone_ = false;
}

/// Does what the user does after the fault: plugs in, opens, enables forces.
void FaultEpisode::mend() {
  phase_ = Phase::kAgain;
  const auto unread = device_->unread();
  if (fault_.happening == Happening::kOtherModel) {
    const auto models = bench_->other_models();
    const Result<void> done = bench_->reconnect_as(models[fault_.seed % models.size()]);
    device_->renew();
    if (!done) return broken("another model cannot be opened: " + done.error().message);
  } else if (unread == DeviceFault::kDisconnected || unread == DeviceFault::kNotCalibrated) {
    const Result<void> done = bench_->reconnect();
    device_->renew();
    if (!done) return broken("it cannot be opened again: " + done.error().message);
  }
  if (unread || fault_.happening == Happening::kOtherModel) {
    if (bench_->device() == nullptr) return broken("nothing is open after reconnecting");
    verdict_.reconnected = true;
    new_loop();
    (void)session_->apply({now(), UseDevice{device_->capabilities()}});
    if (bench_->world().held_force() != Force{}) broken("a force is held right after opening");
  }
  // The pencil would otherwise wait for ever, because it is attracted by the ink of the fault.
  (void)session_->apply({now(), SetOption{"pencil.snap", std::string("off")}});
  was_gone_ = false;
  must_be_zero_ = false;
  servo_->arm();
}

void FaultEpisode::advance() {
  if (phase_ == Phase::kDuring && fault_.happening == Happening::kDoubleTicks && !is_repeat_) {
    is_repeat_ = true;
    return;
  }
  is_repeat_ = false;
  std::int64_t step = period_ns_;
  if (phase_ == Phase::kDuring && fault_.happening == Happening::kMissedTicks) {
    step *= 1 + static_cast<std::int64_t>(random_.bits() % 4);
  }
  script_ns_ += step;
  if (phase_ == Phase::kBefore && script_ns_ >= fault_.at_ns) {
    begin_happening();
  } else if (phase_ == Phase::kDuring && script_ns_ >= fault_.at_ns + fault_.lasts_ns) {
    end_happening();
  }
  if (phase_ == Phase::kDuring) try_too_early();
  if (phase_ == Phase::kAfter && script_ns_ >= arm_ns_) mend();
}

FaultVerdict FaultEpisode::run() {
  bench_->world().stylus().place(hand_at(0));
  servo_->publish(session_->force());
  servo_->arm();
  while (script_ns_ < ends_ns_ && verdict_.broken.empty()) {
    move_hand();
    const TickReport& tick = servo_->step(now());
    ++verdict_.ticks;
    check_tick(tick);
    // The hand moves on even if the device is not read.
    if (device_->unread() == DeviceFault::kDisconnected) {
      (void)bench_->world().stylus().read(now());
    }
    turn();
    advance();
  }
  if (verdict_.broken.empty()) check_back();
  servo_->stop();
  if (verdict_.broken.empty()) check_end();
  verdict_.digest = hash_.value();
  return verdict_;
}

}  // namespace felt
