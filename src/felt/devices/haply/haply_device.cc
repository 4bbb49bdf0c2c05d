#include "felt/devices/haply/haply_device.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>
#include <utility>

#include "felt/base/constants.h"

namespace felt::haply {
namespace {

constexpr int kMaxMessages = 16;  // messages read in one tick
constexpr int kMaxEvents = 4;
constexpr double kNsPerS = 1e9;

// Number of attempts to read the state during homing, while the user puts the pen into its inkwell.
constexpr int kHomingTries = 500;
constexpr std::chrono::milliseconds kHomingPause{10};
constexpr std::int64_t kHomingWaitNs = 50'000'000;

}  // namespace

HaplyDevice::HaplyDevice(Connection connection)
    : control_(std::move(connection.control)),
      events_(std::move(connection.events)),
      descriptor_(std::move(connection.descriptor)),
      inventory_(std::move(connection.device)),
      grip_id_(std::move(connection.grip_id)),
      key_(force_key_of(connection.version)),
      gate_(descriptor_.capabilities),
      is_calibrated_(inventory_.calibrated.value_or(true)),
      has_power_(inventory_.has_power.value_or(true)),
      time_(descriptor_.capabilities.period_ns),
      report_(descriptor_.capabilities.period_ns,
              {.late = ShortText("The Inverse Service does not answer in time."),
               .slow = ShortText("The Inverse Service answers too slowly.")}) {
  report_.status().notice = ShortText(first_notice(events_ != nullptr));
  report_.publish();
}

HaplyDevice::~HaplyDevice() {
  stop();
  control_->close();
  if (events_) events_->close();
}

std::string HaplyDevice::first_notice(bool has_events) const {
  std::string notice;
  const auto add = [&notice](const std::string& sentence) {
    notice += (notice.empty() ? "" : " ") + sentence;
  };
  if (inventory_.has_power == false) add("The device has no power: plug in its power supply.");
  if (inventory_.gravity_compensation == false) add("Its gravity compensation is off.");
  if (!has_events) add("The service's events do not arrive: braking is not reported.");
  const auto shown = [](double v) {
    std::string text = std::to_string(v);
    return text.substr(0, text.find('.') + 3);
  };
  if (inventory_.force_gate.value_or(0.0) > 0.0) {
    add("The service's force gate (" + shown(*inventory_.force_gate) + ") changes our forces.");
  }
  if (inventory_.damping.value_or(0.0) > 0.0) {
    add("The service adds damping (" + shown(*inventory_.damping) + ").");
  }
  return notice;
}

tl::unexpected<DeviceFault> HaplyDevice::gone(std::string_view words) noexcept {
  if (!is_gone_) {
    is_gone_ = true;
    gone_words_ = ShortText(words);
    release();
  }
  return report_.failed(DeviceFault::kDisconnected, gone_words_);
}

// Sends zero force in every state of this object, because the service must not hold a force: even a
// service that was treated as disconnected may continue later. Reads the waiting answers first,
// because a message may only be sent after them (RequestWindow).
void HaplyDevice::release() noexcept {
  gate_.release();
  for (int i = 0; i < kMaxMessages && !window_.is_clear() && !window_.may_release(); ++i) {
    if (receive(0) != Received::kState) break;
  }
  if (window_.is_clear() || window_.may_release()) send({});
}

// If all messages are answered, sends this force, limited by the gate. Otherwise only a message
// without force may be sent, so the force of the last message stays in effect unless the new force
// is zero.
void HaplyDevice::put(const Force& force) noexcept {
  const ForceGate before = gate_;
  if (window_.is_clear()) {
    if (!send(gate_.pass(force, now_ns_).force)) gate_ = before;
  } else if (force == Force{} && window_.may_release()) {
    gate_.release();
    if (!send({})) gate_ = before;
  }
}

bool HaplyDevice::send(const Force& force) noexcept {
  const std::string_view command = write_command(inventory_.id, key_, force, command_.data());
  const auto sent = control_->send(command, is_gone_ ? 0 : kSendNs);
  if (!sent) {
    const bool is_over = sent.error() != SocketFault::kTimedOut;
    if (is_over && !is_gone_) gone("The connection to the service was closed.");
    return false;
  }
  window_.sent(!(force == Force{}));
  sent_ns_ = now_ns_;
  return true;
}

HaplyDevice::Received HaplyDevice::receive(std::int64_t within_ns) noexcept {
  const auto message = control_->receive(within_ns);
  if (!message) {
    return message.error() == SocketFault::kTimedOut ? Received::kNothing : Received::kClosed;
  }
  window_.answered();
  return read_state(*message, inventory_.id, grip_id_, state_) ? Received::kState : Received::kBad;
}

// Reads all waiting messages and returns the result of the newest. If more messages came than were
// requested, reads all of them, because unread ones would make all later states late. Waits only
// for the first message.
HaplyDevice::Received HaplyDevice::receive_all(std::int64_t within_ns) noexcept {
  Received newest = receive(within_ns);
  for (int i = 1; i < kMaxMessages; ++i) {
    if (newest == Received::kNothing || newest == Received::kClosed) break;
    const Received next = receive(0);
    if (next == Received::kNothing) break;
    newest = next;
  }
  return newest;
}

void HaplyDevice::take_event(const Event& event) noexcept {
  switch (event.kind) {
    case EventKind::kNone:
      return;
    case EventKind::kNotice:
      report_.status().notice = event.words;
      return;
    case EventKind::kBrakeOn:
      brake_is_on_ = true;
      brake_words_ = event.words;
      report_.stop_force(event.words);  // reported once, even if the brake is released before
      return;
    case EventKind::kBrakeOff:
      brake_is_on_ = false;
      report_.status().notice = event.words;
      return;
    case EventKind::kForceStopped:
      report_.stop_force(event.words);
      return;
    case EventKind::kGone:
      gone(event.words.view());
      return;
  }
}

void HaplyDevice::receive_events() noexcept {
  if (!events_) return;
  for (int i = 0; i < kMaxEvents; ++i) {
    const auto message = events_->receive(0);
    if (!message) {
      if (message.error() == SocketFault::kTimedOut) return;
      if (!events_are_over_)
        report_.status().notice = ShortText("The service stopped sending events.");
      events_are_over_ = true;
      return;
    }
    if (const auto event = read_event(*message, inventory_.id)) take_event(*event);
  }
}

void HaplyDevice::check_that_force_is_received() noexcept {
  constexpr double kNothingN = 1e-9;
  if (!window_.is_clear()) return;  // this state may answer a message without force
  const double sent_n = norm(gate_.held());
  const bool is_deaf = state_.force_n && norm(*state_.force_n) < kNothingN && sent_n >= kFeltN;
  if (sent_n < kFeltN && deaf_states_ > 0) return;  // the force is too small to judge
  deaf_states_ = is_deaf ? deaf_states_ + 1 : 0;
  if (deaf_states_ < kDeafStates || keys_tried_ > 2) return;
  deaf_states_ = 0;
  if (keys_tried_++ == 2) {
    report_.status().notice = ShortText("The service reports no force in its states.");
    return;
  }
  report_.stop_force(
      key_ == ForceKey::kValues
          ? ShortText("The service did not accept a force as \"values\"; trying \"vector\".")
          : ShortText("The service did not accept a force as \"vector\"; trying \"values\"."));
  key_ = other(key_);
}

void HaplyDevice::count_rate(std::int64_t now_ns) noexcept {
  const auto span_ns = static_cast<double>(now_ns) - static_cast<double>(rate_since_ns_);
  if (rate_reads_ != 0 && span_ns >= 0.0 && span_ns < kNsPerS) return;
  if (rate_reads_ != 0 && span_ns > 0.0) {
    report_.status().rate_hz =
        kNsPerS * static_cast<double>(report_.status().reads - rate_reads_) / span_ns;
  }
  rate_since_ns_ = now_ns;
  rate_reads_ = report_.status().reads;
}

tl::expected<PenSample, DeviceFault> HaplyDevice::nothing_received() noexcept {
  if (report_.pace().counted_ns() > kMaxSilentNs) return gone("The Inverse Service sends nothing.");
  if (report_.pace().waited_ns() > kMaxHeldNs || !has_sample_) {
    return report_.failed(DeviceFault::kOther, ShortText("The Inverse Service does not answer."));
  }
  return sample_;
}

// Updates the time. After a pause of our own loop, answers may be waiting in the socket, so the
// window counts only a part of it.
void HaplyDevice::wait_until(std::int64_t now_ns) noexcept {
  tick_ns_ = time_.tick(now_ns);
  now_ns_ = now_ns;
  window_.wait(std::min(tick_ns_, ServicePace::kMaxTickNs));
}

// Returns the age of the received state, s, which is the time since the message was sent. Returns 0
// if the age is implausible because the clock jumped or the loop stood still.
double HaplyDevice::ahead_s(std::int64_t now_ns) const noexcept {
  const double age_s = (static_cast<double>(now_ns) - static_cast<double>(sent_ns_)) / kNsPerS;
  const double max_s = 2e-9 * static_cast<double>(descriptor_.capabilities.period_ns);
  return age_s > 0.0 && age_s <= max_s ? age_s : 0.0;
}

tl::expected<PenSample, DeviceFault> HaplyDevice::read(std::int64_t now_ns) noexcept {
  wait_until(now_ns);
  if (!is_gone_) receive_events();
  if (is_gone_) return report_.failed(DeviceFault::kDisconnected, gone_words_);
  if (window_.is_clear() || window_.is_overdue()) {
    gate_.release();
    send({});
  }
  const Received received =
      is_gone_ ? Received::kClosed : receive_all(has_sample_ ? kWaitNs : kFirstWaitNs);
  report_.follow(tick_ns_, received == Received::kState || received == Received::kBad);
  switch (received) {
    case Received::kClosed:
      return gone("The connection to the service was closed.");
    case Received::kNothing:
      return nothing_received();
    case Received::kBad:
      return report_.failed(DeviceFault::kBadData,
                            ShortText("The service's message could not be parsed."));
    case Received::kState:
      break;
  }
  if (!state_.has_device) return gone("The service no longer knows the device.");
  is_calibrated_ = state_.calibrated.value_or(is_calibrated_);
  if (!is_calibrated_) {
    return report_.failed(DeviceFault::kNotCalibrated, ShortText("The device is not calibrated."));
  }
  take_state();
  check_that_force_is_received();
  if (!no_force_words()) report_.status().fault.reset();
  ++report_.status().reads;
  count_rate(now_ns);
  report_.publish();
  return sample_;
}

void HaplyDevice::take_state() noexcept {
  sample_.time_ns = now_ns_;
  sample_.velocity = kMmPerM * state_.velocity_m_per_s;
  sample_.position = kMmPerM * state_.position_m + ahead_s(now_ns_) * sample_.velocity;
  sample_.buttons = state_.buttons;
  axis_ = state_.grip_axis;
  has_power_ = state_.has_power.value_or(has_power_);
  has_sample_ = true;
}

// Returns the reason why no force is sent, or nullopt if forces are sent.
std::optional<ShortText> HaplyDevice::no_force_words() const noexcept {
  if (report_.stopped_words()) return report_.stopped_words();
  if (brake_is_on_) return brake_words_;
  if (!has_power_) return ShortText("The device has no power: plug in its power supply.");
  return report_.pace_words();
}

tl::expected<void, DeviceFault> HaplyDevice::write(const Force& force) noexcept {
  if (is_gone_) return tl::unexpected(DeviceFault::kDisconnected);
  const std::optional<ShortText> no_force = no_force_words();
  put(report_.allowed(force, no_force));
  if (is_gone_) return tl::unexpected(DeviceFault::kDisconnected);
  return report_.written(force, no_force);
}

void HaplyDevice::stop() noexcept {
  release();
}

Homing HaplyDevice::homing() noexcept {
  return is_calibrated_ ? Homing::kNone : Homing::kInkwell;
}

std::string HaplyDevice::homing_words() {
  if (is_calibrated_) return {};
  return "Put the tip of the handle into the inkwell at the foot of the device and hold it there "
         "until its light has changed.";
}

Result<void> HaplyDevice::find_home() {
  for (int i = 0; i < kHomingTries && !is_gone_; ++i) {
    if (window_.is_clear() || window_.is_overdue()) {
      gate_.release();
      send({});
    }
    const Received received = receive_all(kHomingWaitNs);
    if (received == Received::kClosed) gone("The connection was closed.");
    if (received == Received::kNothing) window_.wait(kHomingWaitNs);
    if (is_gone_) break;
    if (state_.calibrated.value_or(is_calibrated_)) {
      is_calibrated_ = true;
      time_.restart();  // the time that homing took is not a delay of the service
      report_.restart_pace();
      return {};
    }
    std::this_thread::sleep_for(kHomingPause);
  }
  return fail(ErrorCode::kIo, is_gone_ ? "The connection to the Inverse Service was closed."
                                       : "The device is still not calibrated. Put the handle into "
                                         "the inkwell once more, or calibrate it in Haply Hub.");
}

}  // namespace felt::haply
