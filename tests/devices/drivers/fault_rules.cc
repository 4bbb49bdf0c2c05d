// The rules of fault_episode.h.
#include <algorithm>
#include <cmath>
#include <limits>

#include "felt/base/constants.h"
#include "felt/driver/force_gate.h"
#include "felt/io/ndjson/ndjson_writer.h"
#include "tests/devices/drivers/fault_episode.h"

namespace felt {
namespace {

constexpr double kNoForceN = 1e-9;
constexpr double kRiseNPerMs = 0.3, kEngageNPerMs = 0.01;
constexpr std::int64_t kSoftFallNs = 60 * kMs;
constexpr std::int64_t kSilentNs = 2'070 * kMs;
constexpr std::int64_t kNoAnswerNs = 50 * kMs;
constexpr std::int64_t kCrossFadeNs = 20 * kMs;
constexpr std::int64_t kJumpHoldNs = 2 * kMs;
constexpr std::int64_t kJumpsOftenNs = 27 * kMs;
// until the delay is detected and the force is released
constexpr std::int64_t kSlowServiceNs = 250 * kMs;
constexpr double kWireN = 1e-5;
constexpr double kSurelyAJumpMm = 8.0;
/// Largest distance of ink from the samples, mm: the tolerance of the fit, plus filter and
/// refinement.
constexpr double kInkMm = 0.6;

std::string newtons(double n) {
  return std::to_string(n) + " N";
}

double distance_to(const Stroke& stroke, Point p) {
  double nearest = std::numeric_limits<double>::infinity();
  Point last = stroke.position(0.0);
  for (int i = 1; i <= 24 * stroke.segment_count(); ++i) {
    const Point next = stroke.position(i / 24.0);
    const Vec way = next - last, to = p - last;
    const double length2 = dot(way, way);
    const double t = length2 > 0.0 ? std::clamp(dot(way, to) / length2, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, distance(p, last + t * way));
    last = next;
  }
  return nearest;
}

}  // namespace

void FaultEpisode::broken(std::string rule) {
  if (!verdict_.broken.empty()) return;
  verdict_.broken = std::move(rule);
  verdict_.broken += ", at " + std::to_string(1e-6 * static_cast<double>(script_ns_)) + " ms";
}

/// Returns how long a force may stay after the first tick of the fault, or nullopt if it may stay.
std::optional<std::int64_t> FaultEpisode::zero_within_ns() const {
  switch (fault_.happening) {
    case Happening::kDeviceFault:
      return zero_after_device_fault_ns();
    case Happening::kStall:
      if (fault_.lasts_ns > 25 * kMs) return 0;
      if (fault_.lasts_ns > 7 * kMs) return kSoftFallNs;
      return std::nullopt;
    case Happening::kClockStep:
    case Happening::kSuspend:
      return 0;
    case Happening::kOtherModel:
      return bench_->notice_ns();
    case Happening::kBadForce:
      // A third force model waits until the first of two has faded out.
      if (std::isnan(fault_.amount)) return period_ns_ + kCrossFadeNs;
      return std::nullopt;
    case Happening::kEditSilent:
      if (fault_.lasts_ns > kSilentNs + kSoftFallNs) return kSilentNs + kSoftFallNs;
      return std::nullopt;
    default:
      return std::nullopt;
  }
}

/// The same for a fault of the device.
std::optional<std::int64_t> FaultEpisode::zero_after_device_fault_ns() const {
  const std::int64_t notice = bench_->notice_ns();
  const std::int64_t jump_ns = kJumpHoldNs + 3 * period_ns_ + notice;
  switch (fault_.fault) {
    case InjectedFault::kReadError:
    case InjectedFault::kUnplugged:
    case InjectedFault::kUncalibrated:
    case InjectedFault::kForcesOff:
    case InjectedFault::kWarmMotors:
      return notice;
    case InjectedFault::kWriteError:
      return std::max(notice, bench_->watchdog_ns());
    case InjectedFault::kNotFinite:
    case InjectedFault::kInfinite:
      return period_ns_ + notice;
    case InjectedFault::kJump:
      if (fault_.amount < kSurelyAJumpMm) return std::nullopt;
      [[fallthrough]];
    case InjectedFault::kSignFlip:
      if (fault_.lasts_ns < jump_ns + 2 * period_ns_) return std::nullopt;
      return jump_ns;
    case InjectedFault::kJumpOften: {
      const std::int64_t often_ns = kJumpsOftenNs + notice;
      if (fault_.lasts_ns < often_ns + 2 * period_ns_) return std::nullopt;
      return often_ns;
    }
    case InjectedFault::kSlowAnswers:
    case InjectedFault::kLostAnswers:
    case InjectedFault::kBurstAnswers: {
      const double period_ms = 1e-6 * static_cast<double>(period_ns_);
      const bool is_prompt =
          fault_.fault != InjectedFault::kLostAnswers && fault_.amount < 2.0 * period_ms;
      if (is_prompt || fault_.lasts_ns < kSlowServiceNs + period_ns_) return std::nullopt;
      return kSlowServiceNs;
    }
    case InjectedFault::kNoAnswer: {
      const std::int64_t limit = std::max(kNoAnswerNs, bench_->watchdog_ns()) + notice;
      if (fault_.lasts_ns < limit + period_ns_) return std::nullopt;
      return limit;
    }
    default:
      return std::nullopt;
  }
}

/// Returns true if a service whose watchdog has released the motors still applies a force that was
/// sent before the delay.
bool FaultEpisode::acts_after_its_watchdog() const noexcept {
  return fault_.happening == Happening::kDeviceFault && is_of_a_service(fault_.fault) &&
         1e6 * fault_.amount >= static_cast<double>(bench_->watchdog_ns());
}

/// Returns true if the user must arm again.
bool FaultEpisode::is_hard() const noexcept {
  return fault_.happening == Happening::kDeviceFault || fault_.happening == Happening::kSuspend ||
         fault_.happening == Happening::kOtherModel || fault_.happening == Happening::kBadForce;
}

/// Returns true if the samples report the real position of the pen and must become ink.
bool FaultEpisode::is_truthful() const noexcept {
  if (phase_ == Phase::kBefore) return true;
  if (fault_.happening == Happening::kOtherTool || fault_.happening == Happening::kUndo) {
    return phase_ == Phase::kAgain && fault_.happening == Happening::kUndo;
  }
  if (fault_.happening != Happening::kDeviceFault) return true;
  switch (fault_.fault) {
    case InjectedFault::kReadError:
    case InjectedFault::kWriteError:
    case InjectedFault::kUnplugged:
    case InjectedFault::kForceIgnored:
    case InjectedFault::kForcesOff:
    case InjectedFault::kWarmMotors:
    case InjectedFault::kUncalibrated:
      return true;
    default:
      return phase_ == Phase::kAgain;
  }
}

void FaultEpisode::check_tick(const TickReport& tick) {
  const Force held = bench_->world().held_force();
  for (const double value : {held.x, held.y, held.z, tick.sample.position.x, tick.sample.position.y,
                             tick.sample.position.z}) {
    hash_.add_value(value);
  }
  check_force(tick);
  check_log(tick);
  check_zero(tick);
  check_reading(tick);
  if (phase_ == Phase::kBefore) {
    verdict_.force_before_n = norm(held);
    if (tick.safety.hard_faults > 0) broken("a hard fault before anything went wrong");
  }
  if (phase_ == Phase::kAgain) {
    verdict_.force_after_n = std::max(verdict_.force_after_n, norm(held));
    Force asked = tick.asked;
    // the device has no motor on this axis
    if (device_->capabilities().actuated_axes < 3) asked.z = 0.0;
    const bool should = norm(asked) > 0.1 && tick.safety.state == SafetyState::kActive;
    asked_long_ = should ? asked_long_ + period_ns_ : 0;
    const SafetyLimits& limits = servo_->options().limits;
    calm_ticks_ = norm(tick.asked) < limits.engage_below_n ? calm_ticks_ + 1 : 0;
    was_calm_ = was_calm_ || calm_ticks_ > limits.engage_ticks;
  }
  last_now_ns_ = now();
  last_held_n_ = norm(held);
  last_state_ = tick.safety.state;
  has_last_ = true;
  if (free_ticks_ > 0) --free_ticks_;
}

void FaultEpisode::check_force(const TickReport& tick) {
  const Force held = bench_->world().held_force();
  if (!is_finite(held)) return broken("a force that is no number is held");
  const double held_n = norm(held);
  if (held_n > servo_->options().limits.peak_force_n + 1e-6) {
    return broken(newtons(held_n) + " are held");
  }
  if (!has_last_) return;
  const std::int64_t dt_ns = std::clamp<std::int64_t>(now() - last_now_ns_, 0, 5 * kMs);
  const double dt_ms = 1e-6 * static_cast<double>(dt_ns + bench_->notice_ns());
  const double more_n = held_n - last_held_n_;
  const bool ignores = fault_.happening == Happening::kDeviceFault &&
                       (fault_.fault == InjectedFault::kForceIgnored ||
                        fault_.fault == InjectedFault::kNoAnswer || acts_after_its_watchdog());
  if (ignores && (phase_ == Phase::kDuring || free_ticks_ > 0)) return;
  if (more_n > kRiseNPerMs * dt_ms + 1e-4) return broken("it rises by " + newtons(more_n));
  // A late service receives few commands, so the force can rise by several steps in one.
  const bool is_late = fault_.happening == Happening::kDeviceFault &&
                       is_of_a_service(fault_.fault) && phase_ != Phase::kAgain;
  const bool engages = !is_late && tick.safety.state == SafetyState::kEngaging &&
                       last_state_ == SafetyState::kEngaging;
  if (engages && more_n > kEngageNPerMs * dt_ms + 1e-4) {
    return broken("while engaging it rises by " + newtons(more_n));
  }
  if (verdict_.reconnected && phase_ == Phase::kAgain) {
    const double since_ms = 1e-6 * static_cast<double>(script_ns_ - arm_ns_);
    if (held_n > kEngageNPerMs * (since_ms + dt_ms) + 1e-4 && since_ms < 300.0) {
      broken(newtons(held_n) + " are held so soon after reconnecting");
    }
  }
}

/// Checks that the fake received the force that the tick reports.
void FaultEpisode::check_log(const TickReport& tick) {
  const std::optional<Force> asked = bench_->last_asked();
  if (!asked || bench_->device() == nullptr) return;
  // nothing is received any more
  if (bench_->device()->status().fault == DeviceFault::kDisconnected) return;
  if (norm(*asked - tick.sent) > kWireN) {
    broken("the log says " + newtons(norm(tick.sent)) + ", the other side was told " +
           newtons(norm(*asked)));
  }
}

void FaultEpisode::check_zero(const TickReport& tick) {
  const bool is_zero = norm(bench_->world().held_force()) <= kNoForceN;
  if (must_be_zero_) {
    if (!is_zero) return broken("a force is held after a fault, before the user armed");
    if (tick.safety.state != SafetyState::kLatched) return broken("the fault is not latched");
  }
  if (phase_ == Phase::kBefore || phase_ == Phase::kAgain || was_zero_) return;
  const std::optional<std::int64_t> within_ns = zero_within_ns();
  if (!within_ns) return;
  const std::int64_t since_ns = script_ns_ - since_ns_;
  if (is_zero && (tick.safety.state == SafetyState::kLatched || !is_hard())) {
    was_zero_ = true;
    must_be_zero_ = is_hard() && !acts_after_its_watchdog();
    verdict_.zero_after_ns = since_ns;
    const bool by_error =
        fault_.happening == Happening::kDeviceFault && bench_->device() != nullptr;
    const bool says_so = by_error && bench_->device()->status().last_fault.has_value();
    const bool is_of_device =
        fault_.fault == InjectedFault::kReadError || fault_.fault == InjectedFault::kUnplugged ||
        fault_.fault == InjectedFault::kWriteError || fault_.fault == InjectedFault::kForcesOff ||
        fault_.fault == InjectedFault::kWarmMotors || fault_.fault == InjectedFault::kUncalibrated;
    if (by_error && is_of_device && !says_so) broken("the status does not say what happened");
  } else if (since_ns >= *within_ns) {
    broken(is_zero ? "the fault is not noticed"
                   : newtons(last_held_n_) + " before, and a force is still held after " +
                         std::to_string(1e-6 * static_cast<double>(since_ns)) + " ms");
  }
}

void FaultEpisode::check_reading(const TickReport& tick) {
  const auto unread = device_->unread();
  if (was_gone_ && unread != DeviceFault::kDisconnected) {
    return broken("it said that it was gone, and lives");
  }
  if (unread == DeviceFault::kDisconnected) was_gone_ = true;
  if (phase_ == Phase::kBefore && unread) return broken("it cannot be read");
  const std::int64_t settled_ns = phase_ == Phase::kAgain ? arm_ns_ + 20 * kMs : INT64_MAX;
  if (script_ns_ > settled_ns && (unread || !tick.sample_ok)) {
    return broken("it cannot be read again");
  }
  const bool is_still_read =
      fault_.happening == Happening::kDeviceFault &&
      (fault_.fault == InjectedFault::kForcesOff || fault_.fault == InjectedFault::kWarmMotors);
  if (is_still_read && !tick.sample_ok) broken("without a force it is not read either");
}

/// Checks that the forces are back.
void FaultEpisode::check_back() {
  // The pencil is attracted by the ink that the fault left under it, so waiting is correct.
  const bool rightly_waits = last_state_ == SafetyState::kWaiting && !was_calm_;
  if (last_state_ != SafetyState::kActive && last_state_ != SafetyState::kEngaging &&
      !rightly_waits) {
    return broken("forces do not engage again");
  }
  if (asked_long_ > 50 * kMs && last_held_n_ < 0.02) broken("a force is asked for, none is held");
}

void FaultEpisode::check_end() {
  if (const Result<void> done = session_->finish(); !done) return broken(done.error().message);
  if (!bench_->broken_rule().empty()) broken(std::string(bench_->broken_rule()));
  if (bench_->device() == nullptr) return broken("nothing is open at the end");
  const double max_n = ForceGate(bench_->device()->capabilities()).max_n();
  if (!(bench_->largest_asked_n() <= max_n + 1e-6)) {
    broken("asked for " + newtons(bench_->largest_asked_n()));
  }
  if (norm(bench_->world().held_force()) > kNoForceN) broken("a force is held after the end");
  std::string lines;
  append_sketch_lines(lines, session_->document());
  hash_.add(std::as_bytes(std::span(lines)));
  if (kind_ == ToolKind::kDraws) check_ink();
  while (session_->history().can_undo() && verdict_.broken.empty()) {
    if (!session_->apply({now(), UndoEvent{}})) return broken("undo is refused");
  }
  if (!(session_->document() == start_)) broken("undo does not lead back to the first drawing");
}

/// Checks that every accepted sample in contact is ink.
void FaultEpisode::check_ink() {
  std::vector<StrokePtr> ink;
  for (const Layer& layer : session_->document().layers()) {
    for (const StrokeId id : layer.strokes) {
      if (!start_.find(id)) ink.push_back(session_->document().find(id));
    }
  }
  for (std::size_t i = 0; i < believed_.size(); i += 3) {
    const Point at{believed_[i].position.x, believed_[i].position.y};
    double nearest = std::numeric_limits<double>::infinity();
    for (const StrokePtr& stroke : ink) nearest = std::min(nearest, distance_to(*stroke, at));
    if (nearest > kInkMm) {
      return broken("ink is lost: " + std::to_string(nearest) + " mm from the sample of " +
                    std::to_string(1e-6 * static_cast<double>(believed_[i].time_ns)) + " ms");
    }
  }
}

}  // namespace felt
