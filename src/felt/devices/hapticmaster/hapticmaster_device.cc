#include "felt/devices/hapticmaster/hapticmaster_device.h"

#include <algorithm>
#include <utility>

#include "felt/base/constants.h"

namespace felt::hapticmaster {
namespace {

constexpr int kMaxAnswers = 8;  // answers read in one tick
constexpr int kStopTries = 4;
constexpr double kMaxModelMmPerS = 1e5;  // the safety chain cuts the force far below
constexpr double kSecondsPerNs = 1e-9;
// A position that the reported velocities do not explain is invalid. The safety chain would not
// call it a jump, because a pen may move 12 mm in the 4 ms of a tick.
constexpr double kMaxErrorMmPerS = 1500.0;
constexpr int kSteadyPositions = 5;  // before a jump can be told from a hand that has just begun
constexpr double kMaxStepS = 0.05;

const ShortText kNotHome("The machine is not ready: it must be calibrated and switched on first.");
const ShortText kUnguarded(
    "The process that switches the machine off when Feltline cannot has ended: prepare it again.");

double since_s(std::int64_t from_ns, std::int64_t to_ns) noexcept {
  return kSecondsPerNs * (static_cast<double>(to_ns) - static_cast<double>(from_ns));
}

bool is_in(const Box& box, const Vec3& p, double margin_mm) noexcept {
  const auto within = [margin_mm](double v, double low, double high) {
    return v >= low - margin_mm && v <= high + margin_mm;
  };
  return within(p.x, box.min_mm.x, box.max_mm.x) && within(p.y, box.min_mm.y, box.max_mm.y) &&
         within(p.z, box.min_mm.z, box.max_mm.z);
}

}  // namespace

HapticMasterDevice::HapticMasterDevice(std::unique_ptr<ControllerLink> link, Connect connect,
                                       const Sector& sector, DeviceDescriptor descriptor)
    : link_(std::move(link)),
      connect_(std::move(connect)),
      inside_(outer_box(sector)),
      descriptor_(std::move(descriptor)),
      gate_(descriptor_.capabilities),
      pace_(descriptor_.capabilities.period_ns) {
  shown_.publish(status_);
}

// The guard switches the machine off when its connection is destroyed. If the guard has ended, the
// requests on this connection do.
HapticMasterDevice::~HapticMasterDevice() {
  stop();
  if (!guard_ || guard_->is_guarded() || is_gone_) return;
  static_cast<void>(link_->send("set state off", kSendNs));
  static_cast<void>(link_->send("remove all", kSendNs));
}

DeviceStatus HapticMasterDevice::status() noexcept {
  shown_.update();
  return shown_.get();
}

tl::unexpected<DeviceFault> HapticMasterDevice::failed(DeviceFault fault,
                                                       const ShortText& words) noexcept {
  // While forces are off because the controller is late, a missing position is not a new fault.
  const bool is_known =
      pace_words_ && status_.fault == DeviceFault::kForcesOff && fault == DeviceFault::kOther;
  const bool is_same = status_.fault == fault && status_.vendor_words == words;
  if (is_known || is_same) return tl::unexpected(fault);
  status_.fault = status_.last_fault = fault;
  status_.vendor_words = words;
  status_.vendor_code = link_->last_errno();
  const bool is_pace = pace_words_ && fault == DeviceFault::kForcesOff && words == *pace_words_;
  if (!(is_pace && is_pace_reported_)) ++status_.faults;
  is_pace_reported_ = is_pace_reported_ || is_pace;
  shown_.publish(status_);
  return tl::unexpected(fault);
}

tl::unexpected<DeviceFault> HapticMasterDevice::gone() noexcept {
  return failed(DeviceFault::kDisconnected, gone_words_);
}

// Gives the connection up: its own release may not arrive any more, so the guard acts.
HapticMasterDevice::Received HapticMasterDevice::lose(std::string_view words,
                                                      std::string_view answer) noexcept {
  if (is_gone_) return Received::kClosed;
  std::array<char, ShortText::kBytes> room{};
  const std::string_view part = answer.substr(0, 60);
  words = words.substr(0, ShortText::kBytes - part.size() - 2);
  char* at = std::copy(words.begin(), words.end(), room.data());
  if (!part.empty()) {
    at = std::copy_n(": ", 2, at);
    at = std::copy(part.begin(), part.end(), at);
  }
  gone_words_ = ShortText({room.data(), static_cast<std::size_t>(at - room.data())});
  release();
  is_gone_ = true;
  gate_.release();
  if (guard_) guard_->let_guard_speak();
  return Received::kClosed;
}

bool HapticMasterDevice::send(Request request, std::string_view text) noexcept {
  const auto sent = link_->send(text, kSendNs);
  if (!sent) {
    if (sent.error() != LinkFault::kTimedOut) lose("The connection was closed", {});
    return false;
  }
  queue_.sent(request, now_ns_);
  return true;
}

// Sends zero force if that is not under way already. If it cannot be sent, the guard acts.
void HapticMasterDevice::release() noexcept {
  gate_.release();
  if (is_gone_ || !queue_.may_send(Request::kRelease)) return;
  ForceText room;
  const std::string_view text = write_force({}, room);
  for (int i = 0; i < kStopTries; ++i) {
    const auto sent = link_->send(text, kSendNs);
    if (sent) return queue_.sent(Request::kRelease, now_ns_);
    if (sent.error() != LinkFault::kTimedOut) break;
  }
  if (guard_) guard_->let_guard_speak();
}

// Sends this force, limited by the gate, if the last one is answered. Otherwise only a release may
// be sent, so the last force stays in effect unless the new one is zero. A release is sent in each
// tick without a force, too, so that a controller that refuses it is noticed before it matters.
void HapticMasterDevice::put(const Force& force) noexcept {
  const ForceGate before = gate_;
  ForceText room;
  if (force == Force{}) {
    if (!queue_.may_send(Request::kRelease)) return;
    gate_.release();
    if (!send(Request::kRelease, write_force({}, room))) gate_ = before;
  } else if (queue_.may_send(Request::kForce)) {
    const Force passed = gate_.pass(force, now_ns_).force;
    if (!send(Request::kForce, write_force(passed, room))) gate_ = before;
  }
}

// An invalid velocity makes the position that follows it invalid, too.
HapticMasterDevice::Received HapticMasterDevice::take_velocity(std::string_view answer) noexcept {
  has_velocity_ = false;
  const AnswerKind kind = kind_of(answer);
  if (kind == AnswerKind::kError) {
    refused_words_ = ShortText(answer);
    return Received::kNothing;
  }
  if (kind != AnswerKind::kVector) return lose("Not an answer to get modelvel", answer);
  const std::optional<Vec3> velocity = read_vector(answer);
  has_velocity_ = velocity && norm(kMmPerM * *velocity) <= kMaxModelMmPerS;
  if (has_velocity_) velocity_mm_per_s_ = kMmPerM * *velocity;
  return Received::kNothing;
}

HapticMasterDevice::Received HapticMasterDevice::take_position(std::string_view answer,
                                                               std::int64_t sent_ns) noexcept {
  const AnswerKind kind = kind_of(answer);
  if (kind == AnswerKind::kError) {
    refused_words_ = ShortText(answer);
    return Received::kRefused;
  }
  if (kind != AnswerKind::kVector) return lose("Not an answer to get measpos", answer);
  const std::optional<Vec3> position_m = read_vector(answer);
  if (!has_velocity_ || !position_m || !is_in(inside_, kMmPerM * *position_m, kBeyondMm)) {
    return Received::kBad;
  }
  const Vec3 position_mm = kMmPerM * *position_m;
  const double step_s = since_s(measured_ns_, sent_ns);
  const bool is_next = step_s > 0.0 && step_s < kMaxStepS;
  const bool is_steady = is_next && positions_ >= kSteadyPositions;
  const double mm_per_s =
      kMaxErrorMmPerS + std::max(norm(sample_.velocity), norm(velocity_mm_per_s_));
  if (is_steady && norm(position_mm - measured_mm_) > mm_per_s * step_s) return Received::kBad;
  measured_mm_ = position_mm;
  measured_ns_ = sent_ns;
  positions_ = is_next ? std::min(positions_ + 1, kSteadyPositions) : 0;
  return Received::kPosition;
}

HapticMasterDevice::Received HapticMasterDevice::take_state(std::string_view answer) noexcept {
  const AnswerKind kind = kind_of(answer);
  if (kind != AnswerKind::kWord && kind != AnswerKind::kError) {
    return lose("Not an answer to get state", answer);
  }
  is_in_force_ = answer == "force";
  if (is_in_force_) return Received::kNothing;
  refused_words_ = kind == AnswerKind::kError
                       ? ShortText(answer)
                       : ShortText("The machine has left the state in which it follows the hand.");
  force_stopped_ = refused_words_;
  if (answer == "off" || answer == "init") is_home_ = false;
  return Received::kNothing;
}

// An error means that the machine may hold any earlier force. After a refused force, write() sends
// a release. If even that is refused, the effect is gone, or only the guard can help.
HapticMasterDevice::Received HapticMasterDevice::take_confirmation(std::string_view answer,
                                                                   Request request) noexcept {
  const AnswerKind kind = kind_of(answer);
  if (kind == AnswerKind::kSentence) return Received::kNothing;
  if (kind != AnswerKind::kError) return lose("Not an answer to set force", answer);
  force_stopped_ = refused_words_ = ShortText(answer);
  if (request == Request::kForce) return Received::kNothing;
  is_home_ = false;
  if (guard_) guard_->let_guard_speak();
  return Received::kNothing;
}

HapticMasterDevice::Received HapticMasterDevice::take_answer(std::string_view answer) noexcept {
  const std::optional<RequestQueue::Sent> sent = queue_.answered();
  if (!sent) return lose("An answer that nobody asked for", answer);
  switch (sent->request) {
    case Request::kVelocity:
      return take_velocity(answer);
    case Request::kPosition:
      return take_position(answer, sent->time_ns);
    case Request::kState:
      return take_state(answer);
    case Request::kForce:
    case Request::kRelease:
      return take_confirmation(answer, sent->request);
  }
  return Received::kNothing;
}

// Receives the answers up to that of the position, for which it waits, and those that are here
// already. Returns the result of the position.
HapticMasterDevice::Received HapticMasterDevice::receive(std::int64_t within_ns) noexcept {
  const StreamDeadline deadline(within_ns);
  Received result = Received::kNothing;
  for (int i = 0; i < kMaxAnswers; ++i) {
    const bool waits = queue_.has(Request::kPosition);
    const auto answer = link_->receive(waits ? deadline.left_ns() : 0);
    if (!answer) {
      if (answer.error() == LinkFault::kTimedOut) return result;
      return lose(answer.error() == LinkFault::kClosed ? "The controller closed the connection"
                                                       : "The controller's answers are garbled",
                  {});
    }
    const Received one = take_answer(*answer);
    if (one == Received::kClosed) return one;
    if (one != Received::kNothing) result = one;
  }
  return result;
}

// Updates the time. Accepts a clock that goes back or stands still.
void HapticMasterDevice::wait_until(std::int64_t now_ns) noexcept {
  const double ns = static_cast<double>(now_ns) - static_cast<double>(now_ns_);
  const auto longest = static_cast<double>(ServicePace::kMaxTickNs);
  tick_ns_ = has_ticked_ ? static_cast<std::int64_t>(std::clamp(ns, 0.0, longest)) : 0;
  has_ticked_ = true;
  now_ns_ = now_ns;
}

void HapticMasterDevice::request_all() noexcept {
  const bool is_due = ++ticks_ % kStateTicks == 0;
  if (is_due && queue_.may_send(Request::kState)) send(Request::kState, "get state");
  if (!queue_.may_send(Request::kVelocity) || !queue_.may_send(Request::kPosition)) return;
  if (!is_gone_ && send(Request::kVelocity, "get modelvel")) {
    send(Request::kPosition, "get measpos");
  }
}

void HapticMasterDevice::follow_pace(bool has_position) noexcept {
  pace_.tick(tick_ns_, has_position);
  if (!pace_.is_off()) {
    pace_words_.reset();
    is_pace_reported_ = false;
  } else if (!pace_words_) {
    pace_words_ = pace_.waited_ns() > ServicePace::kHoldNs
                      ? ShortText("The controller does not answer in time.")
                      : ShortText("The controller answers too slowly.");
  }
}

tl::expected<PenSample, DeviceFault> HapticMasterDevice::nothing_received() noexcept {
  if (pace_.waited_ns() > kMaxSilentNs) {
    lose("The controller sends nothing", {});
    return gone();
  }
  if (pace_.waited_ns() > kMaxHeldNs || !has_sample_) {
    return failed(DeviceFault::kOther, ShortText("The controller does not answer."));
  }
  return sample_;
}

// Extrapolates the position to now if it came late.
void HapticMasterDevice::place_pen() noexcept {
  const double age_s = since_s(measured_ns_, now_ns_);
  const double max_s =
      2.0 * kSecondsPerNs * static_cast<double>(descriptor_.capabilities.period_ns);
  const double ahead_s = age_s > 0.0 && age_s <= max_s ? age_s : 0.0;
  sample_.time_ns = now_ns_;
  sample_.velocity = velocity_mm_per_s_;
  sample_.position = measured_mm_ + ahead_s * velocity_mm_per_s_;
  has_sample_ = true;
}

tl::expected<PenSample, DeviceFault> HapticMasterDevice::read(std::int64_t now_ns) noexcept {
  wait_until(now_ns);
  if (is_gone_) return gone();
  if (!is_home_) return failed(DeviceFault::kNotCalibrated, kNotHome);
  guard_->beat();
  request_all();
  const Received received = is_gone_ ? Received::kClosed : receive(kWaitNs);
  follow_pace(received == Received::kPosition || received == Received::kBad ||
              received == Received::kRefused);
  if (received == Received::kClosed) return gone();
  if (!is_home_) return failed(DeviceFault::kNotCalibrated, refused_words_);
  if (received == Received::kNothing) return nothing_received();
  if (received == Received::kBad) {
    return failed(DeviceFault::kBadData, ShortText("The position or velocity is impossible."));
  }
  if (received == Received::kRefused) return failed(DeviceFault::kOther, refused_words_);
  place_pen();
  if (!no_force_words()) status_.fault.reset();
  ++status_.reads;
  shown_.publish(status_);
  return sample_;
}

// Returns the reason why no force is sent, or nullopt if forces are sent.
std::optional<ShortText> HapticMasterDevice::no_force_words() noexcept {
  if (!guard_ || !guard_->is_guarded()) return kUnguarded;
  if (force_stopped_) return force_stopped_;
  if (!is_in_force_) return refused_words_;
  return pace_words_;
}

tl::expected<void, DeviceFault> HapticMasterDevice::write(const Force& force) noexcept {
  if (is_gone_) return tl::unexpected(DeviceFault::kDisconnected);
  if (!is_home_) {
    release();
    return failed(DeviceFault::kNotCalibrated, kNotHome);
  }
  const bool is_number = is_finite(force);
  const std::optional<ShortText> no_force = no_force_words();
  put(is_number && !no_force ? pace_.share() * force : Force{});
  if (is_gone_) return tl::unexpected(DeviceFault::kDisconnected);
  if (!is_number) {
    return failed(DeviceFault::kBadData, ShortText("The requested force is not a number."));
  }
  if (!no_force) return {};
  force_stopped_.reset();
  return failed(DeviceFault::kForcesOff, *no_force);
}

// The loop may now stand still for a while, for example because the user changes settings. The
// guard rests only if the controller has confirmed that no force acts; otherwise it switches the
// machine off if the loop does not go on.
void HapticMasterDevice::stop() noexcept {
  release();
  if (!guard_ || is_gone_) return;
  const StreamDeadline deadline(kWaitNs);
  for (int i = 0; i < kMaxAnswers && !is_gone_ && queue_.has(Request::kRelease); ++i) {
    const auto answer = link_->receive(deadline.left_ns());
    if (answer) {
      take_answer(*answer);
    } else if (answer.error() != LinkFault::kTimedOut) {
      lose("The connection was closed", {});
    } else {
      break;
    }
  }
  if (is_home_ && !is_gone_ && !queue_.has(Request::kRelease)) guard_->let_guard_rest();
}

}  // namespace felt::hapticmaster
