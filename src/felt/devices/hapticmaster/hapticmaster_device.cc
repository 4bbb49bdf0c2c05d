#include "felt/devices/hapticmaster/hapticmaster_device.h"

#include <algorithm>
#include <utility>

#include "felt/base/constants.h"

namespace felt::hapticmaster {
namespace {

constexpr int kMaxAnswers = 8;  // answers read in one tick
constexpr int kStopTries = 4;
constexpr double kSecondsPerNs = 1e-9;

const ShortText kUnguarded(
    "The process that switches the machine off when Feltline cannot does not run: prepare it "
    "again.");
const ShortText kNotSent("The controller does not accept the request to end the force.");

std::optional<Vec3> in_mm(const std::optional<Vec3>& m) noexcept {
  if (!m) return std::nullopt;
  return kMmPerM * *m;
}

double since_s(std::int64_t from_ns, std::int64_t to_ns) noexcept {
  return kSecondsPerNs * (static_cast<double>(to_ns) - static_cast<double>(from_ns));
}

}  // namespace

HapticMasterDevice::HapticMasterDevice(std::unique_ptr<ControllerLink> link, Connect connect,
                                       const Sector& sector, DeviceDescriptor descriptor)
    : link_(std::move(link)),
      connect_(std::move(connect)),
      descriptor_(std::move(descriptor)),
      gate_(descriptor_.capabilities),
      mode_words_(kNotPrepared),
      time_(descriptor_.capabilities.period_ns),
      motion_(outer_box(sector)),
      report_(descriptor_.capabilities.period_ns,
              {.late = ShortText("The controller does not answer in time."),
               .slow = ShortText("The controller answers too slowly.")}) {}

// The guard switches the machine off when its connection is destroyed. The requests on this
// connection do the same if the guard cannot. Waits at most a few seconds, on the edit thread.
HapticMasterDevice::~HapticMasterDevice() {
  stop();
  if (guard_) static_cast<void>(shut_down());
}

tl::unexpected<DeviceFault> HapticMasterDevice::failed(DeviceFault fault,
                                                       const ShortText& words) noexcept {
  return report_.failed(fault, words, link_->last_errno());
}

tl::unexpected<DeviceFault> HapticMasterDevice::not_ready() noexcept {
  return failed(mode_ == Mode::kGone ? DeviceFault::kDisconnected : DeviceFault::kNotCalibrated,
                mode_words_);
}

// Switches the machine off through both connections, because one of them may be the problem. From
// now on, no sign of life is given to the guard, so it acts even if it is not asked.
void HapticMasterDevice::switch_off(const ShortText& words) noexcept {
  if (mode_ != Mode::kReady) return;
  mode_ = Mode::kNotReady;
  mode_words_ = off_words_ = words;
  static_cast<void>(release());  // in case the machine refuses to switch off
  is_off_pending_ = true;
  off_ns_ = 0;
  ask_off();
}

void HapticMasterDevice::ask_off() noexcept {
  off_asked_ns_ = 0;
  guard_->let_guard_speak();
  if (queue_.may_send(Request::kOff)) send(Request::kOff, "set state off");
  if (mode_ != Mode::kGone && queue_.may_send(Request::kState)) send(Request::kState, "get state");
}

// Repeats the request to switch the machine off until its state is `off`, `ns` after the last tick.
void HapticMasterDevice::follow_off(std::int64_t ns) noexcept {
  if (is_off_pending_ && mode_ == Mode::kNotReady) static_cast<void>(receive(0));
  if (!is_off_pending_ || mode_ != Mode::kNotReady) return;
  off_ns_ += ns;
  off_asked_ns_ += ns;
  if (off_ns_ > kOffKnownNs) mode_words_ = ShortText(kNotOff);
  if (off_asked_ns_ >= kOffAskedNs) ask_off();
}

// Gives the connection up. Its own release may not arrive any more, so the guard acts, too.
HapticMasterDevice::Received HapticMasterDevice::lose(std::string_view words,
                                                      std::string_view answer) noexcept {
  if (mode_ == Mode::kGone) return Received::kClosed;
  std::array<char, ShortText::kBytes> room{};
  const std::string_view part = answer.substr(0, 60);
  words = words.substr(0, ShortText::kBytes - part.size() - 2);
  char* at = std::copy(words.begin(), words.end(), room.data());
  if (!part.empty()) {
    at = std::copy_n(": ", 2, at);
    at = std::copy(part.begin(), part.end(), at);
  }
  mode_words_ = ShortText({room.data(), static_cast<std::size_t>(at - room.data())});
  if (mode_ == Mode::kReady) static_cast<void>(release());
  mode_ = Mode::kGone;
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
  queue_.add({request, now_ns_, sum_ns_});
  return true;
}

// Sends zero force if that is not under way already. Returns false if it cannot be sent.
bool HapticMasterDevice::release() noexcept {
  gate_.release();
  is_release_pending_ = true;
  if (!queue_.may_send(Request::kRelease)) return true;
  ForceText room;
  const std::string_view text = write_force(effect_, {}, room);
  for (int i = 0; i < kStopTries; ++i) {
    const auto sent = link_->send(text, kSendNs);
    if (sent) {
      queue_.add({Request::kRelease, now_ns_, sum_ns_});
      return true;
    }
    if (sent.error() != LinkFault::kTimedOut) break;
  }
  return false;
}

// Sends this force, limited by the gate, if the last one is answered. Otherwise only a release may
// be sent, so the last force stays in effect unless the new one is zero. A release is sent in each
// tick without a force, too, so that a controller that refuses it is noticed before it matters.
void HapticMasterDevice::put(const Force& force) noexcept {
  const ForceGate before = gate_;
  ForceText room;
  if (force == Force{}) {
    is_release_pending_ = true;
    if (!queue_.may_send(Request::kRelease)) return;
    gate_.release();
    if (!send(Request::kRelease, write_force(effect_, {}, room))) gate_ = before;
  } else if (queue_.may_send(Request::kForce)) {
    const Force passed = gate_.pass(force, now_ns_).force;
    if (send(Request::kForce, write_force(effect_, passed, room))) {
      is_release_pending_ = false;
    } else {
      gate_ = before;
    }
  }
}

// An invalid velocity makes the position that follows it invalid, too.
HapticMasterDevice::Received HapticMasterDevice::take_velocity(std::string_view answer) noexcept {
  velocity_mm_per_s_.reset();
  const AnswerKind kind = kind_of(answer);
  if (kind == AnswerKind::kError) {
    refused_words_ = ShortText(answer);
    return Received::kNothing;
  }
  if (kind != AnswerKind::kVector) return lose("Not an answer to get modelvel", answer);
  velocity_mm_per_s_ = in_mm(read_vector(answer));
  return Received::kNothing;
}

HapticMasterDevice::Received HapticMasterDevice::take_position(
    std::string_view answer, const RequestQueue::Sent& sent) noexcept {
  const AnswerKind kind = kind_of(answer);
  if (kind == AnswerKind::kError) {
    refused_words_ = ShortText(answer);
    return Received::kRefused;
  }
  if (kind != AnswerKind::kVector) return lose("Not an answer to get measpos", answer);
  const MotionReport motion{in_mm(read_vector(answer)), velocity_mm_per_s_, sent.sum_ns};
  const MotionVerdict verdict = motion_.judge(motion);
  if (verdict == MotionVerdict::kImpossible) return Received::kBad;
  measured_mm_ = *motion.position_mm;
  measured_ns_ = sent.time_ns;
  return verdict == MotionVerdict::kGood ? Received::kPosition : Received::kDoubtful;
}

HapticMasterDevice::Received HapticMasterDevice::take_state(std::string_view answer) noexcept {
  const AnswerKind kind = kind_of(answer);
  if (kind != AnswerKind::kWord && kind != AnswerKind::kError) {
    return lose("Not an answer to get state", answer);
  }
  is_in_force_ = answer == "force";
  if (answer == "off" && std::exchange(is_off_pending_, false)) mode_words_ = off_words_;
  if (is_in_force_ || mode_ != Mode::kReady) return Received::kNothing;
  refused_words_ = kind == AnswerKind::kError
                       ? ShortText(answer)
                       : ShortText("The machine has left the state in which it follows the hand.");
  report_.stop_force(refused_words_);
  if (answer == "off" || answer == "init") switch_off(refused_words_);
  return Received::kNothing;
}

// An error means that the machine may hold any earlier force. After a refused force, write() sends
// a release. If even that is refused, the effect is gone, or only the guard can help.
HapticMasterDevice::Received HapticMasterDevice::take_confirmation(std::string_view answer,
                                                                   Request request) noexcept {
  const AnswerKind kind = kind_of(answer);
  const bool is_release = request == Request::kRelease;
  if (kind == AnswerKind::kSentence) {
    if (is_release) is_release_pending_ = false;
    return Received::kNothing;
  }
  if (kind != AnswerKind::kError) return lose("Not an answer to set force", answer);
  refused_words_ = ShortText(answer);
  report_.stop_force(refused_words_);
  if (is_release) switch_off(refused_words_);
  return Received::kNothing;
}

HapticMasterDevice::Received HapticMasterDevice::take_answer(std::string_view answer) noexcept {
  const std::optional<RequestQueue::Sent> sent = queue_.answered();
  if (!sent) return lose("An answer that nobody asked for", answer);
  switch (sent->request) {
    case Request::kVelocity:
      return take_velocity(answer);
    case Request::kPosition:
      return take_position(answer, *sent);
    case Request::kState:
      return take_state(answer);
    case Request::kForce:
    case Request::kRelease:
      return take_confirmation(answer, sent->request);
    case Request::kOff:
      break;
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

void HapticMasterDevice::request_all() noexcept {
  const bool is_due = ++ticks_ % kStateTicks == 0;
  if (is_due && queue_.may_send(Request::kState)) send(Request::kState, "get state");
  if (!queue_.may_send(Request::kVelocity) || !queue_.may_send(Request::kPosition)) return;
  if (mode_ != Mode::kGone && send(Request::kVelocity, "get modelvel")) {
    send(Request::kPosition, "get measpos");
  }
}

// Says which conditions of the table (kLimits) this tick shows.
Signs HapticMasterDevice::signs_of(Received received) const noexcept {
  const auto sign = [](bool is_present) { return is_present ? Sign::kPresent : Sign::kAbsent; };
  const bool is_silent = received == Received::kNothing;
  const bool is_bad = received == Received::kBad || received == Received::kRefused;
  Signs signs{};
  const auto set = [&signs](Condition condition, Sign to) {
    signs[static_cast<std::size_t>(condition)] = to;
  };
  set(Condition::kReleasePending, sign(is_release_pending_));
  set(Condition::kNoAnswer, sign(is_silent));
  set(Condition::kImpossiblePosition, is_silent ? Sign::kUnknown : sign(is_bad));
  set(Condition::kInconsistentPosition,
      is_silent || is_bad ? Sign::kUnknown : sign(received == Received::kDoubtful));
  return signs;
}

tl::expected<PenSample, DeviceFault> HapticMasterDevice::nothing_received() noexcept {
  if (report_.pace().waited_ns() > kMaxHeldNs || !has_sample_) {
    return failed(DeviceFault::kOther, ShortText("The controller does not answer."));
  }
  return sample_;
}

tl::expected<PenSample, DeviceFault> HapticMasterDevice::position_received() noexcept {
  place_pen();
  if (!no_force_words()) report_.status().fault.reset();
  ++report_.status().reads;
  report_.publish();
  return sample_;
}

// Extrapolates the position to now if it came a little late. A position that is older than two
// periods is not changed and carries the time at which it was asked for, so that nobody takes it
// for the present one.
void HapticMasterDevice::place_pen() noexcept {
  const double age_s = since_s(measured_ns_, now_ns_);
  const double max_s =
      2.0 * kSecondsPerNs * static_cast<double>(descriptor_.capabilities.period_ns);
  const bool is_old = age_s > max_s;
  const Vec3 velocity_mm_per_s = velocity_mm_per_s_.value_or(Vec3{});
  sample_.time_ns = is_old ? measured_ns_ : now_ns_;
  sample_.velocity = velocity_mm_per_s;
  sample_.position = measured_mm_;
  if (age_s > 0.0 && !is_old) sample_.position += age_s * velocity_mm_per_s;
  has_sample_ = true;
}

// Returns the time since the last tick. A pause after a confirmed stop() does not count if it is so
// long that the guard would have acted. Shorter ones do, because after a fault the loop calls
// stop() in each tick.
std::int64_t HapticMasterDevice::tick(std::int64_t now_ns) noexcept {
  const std::int64_t ns = time_.tick(now_ns);
  now_ns_ = now_ns;
  sum_ns_ +=
      std::min(ns, kSecond);  // cannot overflow; MotionCheck begins anew after less than that
  const bool was_resting = std::exchange(is_resting_, false);
  return was_resting && ns > kGuardNs ? 0 : ns;
}

tl::expected<PenSample, DeviceFault> HapticMasterDevice::read(std::int64_t now_ns) noexcept {
  const std::int64_t ns = tick(now_ns);
  follow_off(ns);
  if (mode_ != Mode::kReady) return not_ready();
  guard_->beat();
  if (!guard_->is_guarded()) {
    switch_off(kUnguarded);
    return not_ready();
  }
  request_all();
  const Received received = mode_ == Mode::kGone ? Received::kClosed : receive(kWaitNs);
  report_.follow(ns, received != Received::kNothing && received != Received::kClosed);
  const Limit* const broken = watch_.tick(ns, signs_of(received));
  if (broken != nullptr) switch_off(ShortText(broken->words));
  if (mode_ != Mode::kReady) return not_ready();
  switch (received) {
    case Received::kNothing:
      return nothing_received();
    case Received::kBad:
      return failed(DeviceFault::kBadData, ShortText("The position or velocity is impossible."));
    case Received::kRefused:
      return failed(DeviceFault::kOther, refused_words_);
    case Received::kPosition:
    case Received::kDoubtful:
      return position_received();
    case Received::kClosed:
      break;
  }
  return not_ready();
}

// Returns the reason why no force is sent, or nullopt if forces are sent.
std::optional<ShortText> HapticMasterDevice::no_force_words() noexcept {
  if (!guard_->is_guarded()) return kUnguarded;
  if (report_.stopped_words()) return report_.stopped_words();
  if (!is_in_force_) return refused_words_;
  return report_.pace_words();
}

tl::expected<void, DeviceFault> HapticMasterDevice::write(const Force& force) noexcept {
  if (mode_ != Mode::kReady) return not_ready();
  const std::optional<ShortText> no_force = no_force_words();
  put(report_.allowed(force, no_force));
  if (mode_ != Mode::kReady) return not_ready();
  return report_.written(force, no_force);
}

// The loop may now stand still for a while, for example because the user changes settings. The
// guard rests only if the controller has confirmed that no force acts; otherwise it switches the
// machine off if the loop does not go on.
void HapticMasterDevice::stop() noexcept {
  if (mode_ != Mode::kReady) return;
  if (!release()) return switch_off(kNotSent);
  const StreamDeadline deadline(kWaitNs);
  for (int i = 0; i < kMaxAnswers && mode_ == Mode::kReady && is_release_pending_; ++i) {
    const auto answer = link_->receive(deadline.left_ns());
    if (answer) {
      take_answer(*answer);
    } else if (answer.error() != LinkFault::kTimedOut) {
      lose("The connection was closed", {});
    } else {
      break;
    }
  }
  if (mode_ != Mode::kReady || is_release_pending_) return;
  guard_->let_guard_rest();
  is_resting_ = true;
}

}  // namespace felt::hapticmaster
