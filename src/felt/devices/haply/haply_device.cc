#include "felt/devices/haply/haply_device.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>
#include <utility>

namespace felt::haply {
namespace {

constexpr double kMmPerM = 1000.0;
constexpr int kMostUnanswered = 8;  // more messages are not piled up before a service that is slow
constexpr int kMostMessages = 16;   // that one tick looks at
constexpr int kMostEvents = 4;
constexpr double kNsPerS = 1e9;

// While a person puts the pen home.
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
      is_calibrated_(inventory_.calibrated.value_or(true)) {
  status_.notice = ShortText(first_notice(events_ != nullptr));
  shown_.publish(status_);
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
  if (inventory_.has_power == false) add("The device has no power: plug its supply in.");
  if (inventory_.gravity_compensation == false) add("Its gravity compensation is off.");
  if (!has_events) add("The service's events are not heard: its brake is not told.");
  const auto shown = [](double v) {
    std::string text = std::to_string(v);
    return text.substr(0, text.find('.') + 3);
  };
  if (inventory_.force_gate.value_or(0.0) > 0.0) {
    add("The service's force gate (" + shown(*inventory_.force_gate) + ") acts on our forces.");
  }
  if (inventory_.damping.value_or(0.0) > 0.0) {
    add("The service adds damping (" + shown(*inventory_.damping) + ").");
  }
  return notice;
}

DeviceStatus HaplyDevice::status() noexcept {
  shown_.update();
  return shown_.get();
}

tl::unexpected<DeviceFault> HaplyDevice::failed(DeviceFault fault,
                                                const ShortText& words) noexcept {
  status_.fault = status_.last_fault = fault;
  status_.vendor_words = words;
  ++status_.faults;
  shown_.publish(status_);
  return tl::unexpected(fault);
}

tl::unexpected<DeviceFault> HaplyDevice::gone(std::string_view words) noexcept {
  if (!is_gone_) {
    is_gone_ = true;
    gone_words_ = ShortText(words);
    gate_.let_go();
    tell_to_let_go();
  }
  return failed(DeviceFault::kDisconnected, gone_words_);
}

// Whatever is left of the connection is told: a service that stood still and was given up may go on
// after all, with a force that waited there.
void HaplyDevice::tell_to_let_go() noexcept {
  static_cast<void>(control_->send(write_command(inventory_.id, key_, {}, command_.data()), 0));
}

// The service is behind. It is asked for a state all the same, since answers may have been lost:
// now and then only, so that no more than it can answer waits there. Once states come again one
// waits for the rest; what does not come was answered by the last.
void HaplyDevice::send_nothing() noexcept {
  gate_.let_go();
  sent_n_ = 0.0;
  if (settles_) {
    if (missed_ < kSettleTicks) return;
    settles_ = false;
    ask_anew();
  } else if (unanswered_ < kMostUnanswered || missed_ % kMostUnanswered == 0) {
    send({});
  }
}

// What is unanswered is forgotten, though a force may lie among it before a service that stands
// still, and would be added to the next: none goes before something is answered.
void HaplyDevice::ask_anew() noexcept {
  unanswered_ = 0;
  has_answered_ = false;
}

bool HaplyDevice::send(const Force& force) noexcept {
  sent_n_ = 0.0;
  const std::string_view command = write_command(inventory_.id, key_, force, command_.data());
  const auto sent = control_->send(command, kSendNs);
  if (!sent) {
    if (sent.error() != SocketFault::kTimedOut) gone("The connection to the service was closed.");
    return false;
  }
  unanswered_ = std::min(unanswered_ + 1, kMostUnanswered);
  sent_n_ = norm(force);
  sent_ns_ = now_ns_;
  return true;
}

HaplyDevice::Heard HaplyDevice::hear(std::int64_t within_ns) noexcept {
  const auto message = control_->receive(within_ns);
  if (!message) {
    return message.error() == SocketFault::kTimedOut ? Heard::kNothing : Heard::kClosed;
  }
  if (unanswered_ > 0) --unanswered_;
  has_answered_ = true;
  settles_ = unanswered_ > 0;
  return read_state(*message, inventory_.id, grip_id_, state_) ? Heard::kState : Heard::kBad;
}

// The newest state that has come: what waits behind it is taken too, though it was not owed any
// more, or states would stay old. Waits for one only.
HaplyDevice::Heard HaplyDevice::hear_all(std::int64_t within_ns) noexcept {
  Heard newest = hear(within_ns);
  for (int i = 1; i < kMostMessages; ++i) {
    if (newest == Heard::kNothing || newest == Heard::kClosed) break;
    const Heard next = hear(0);
    if (next == Heard::kNothing) break;
    newest = next;
  }
  return newest;
}

void HaplyDevice::take_event(const Event& event) noexcept {
  switch (event.kind) {
    case EventKind::kNone:
      return;
    case EventKind::kNotice:
      status_.notice = event.words;
      return;
    case EventKind::kBrakeOn:
      brake_is_on_ = true;
      brake_words_ = event.words;
      force_stopped_ = event.words;  // told once, though it be over by the next write()
      return;
    case EventKind::kBrakeOff:
      brake_is_on_ = false;
      status_.notice = event.words;
      return;
    case EventKind::kForceStopped:
      force_stopped_ = event.words;
      return;
    case EventKind::kGone:
      gone(event.words.view());
      return;
  }
}

void HaplyDevice::hear_events() noexcept {
  if (!events_) return;
  for (int i = 0; i < kMostEvents; ++i) {
    const auto message = events_->receive(0);
    if (!message) {
      if (message.error() == SocketFault::kTimedOut) return;
      if (!events_are_over_) status_.notice = ShortText("The service's events have stopped.");
      events_are_over_ = true;
      return;
    }
    if (const auto event = read_event(*message, inventory_.id)) take_event(*event);
  }
}

void HaplyDevice::check_that_force_is_heard() noexcept {
  constexpr double kNothingN = 1e-9;
  if (unanswered_ > 0) return;  // it may answer what bore no force
  const bool is_deaf = state_.force_n && norm(*state_.force_n) < kNothingN && sent_n_ >= kHeardN;
  if (sent_n_ < kHeardN && deaf_states_ > 0) return;  // nothing to hear just now
  deaf_states_ = is_deaf ? deaf_states_ + 1 : 0;
  if (deaf_states_ < kDeafStates || keys_tried_ > 2) return;
  deaf_states_ = 0;
  if (keys_tried_++ == 2) {
    status_.notice = ShortText("The service shows no force in its states.");
    return;
  }
  force_stopped_ = key_ == ForceKey::kValues
                       ? ShortText("The service took no force as \"values\"; \"vector\" is tried.")
                       : ShortText("The service took no force as \"vector\"; \"values\" is tried.");
  key_ = other(key_);
}

void HaplyDevice::count_rate(std::int64_t now_ns) noexcept {
  const auto span_ns = static_cast<double>(now_ns) - static_cast<double>(rate_since_ns_);
  if (rate_reads_ != 0 && span_ns >= 0.0 && span_ns < kNsPerS) return;
  if (rate_reads_ != 0 && span_ns > 0.0) {
    status_.rate_hz = kNsPerS * static_cast<double>(status_.reads - rate_reads_) / span_ns;
  }
  rate_since_ns_ = now_ns;
  rate_reads_ = status_.reads;
}

tl::expected<PenSample, DeviceFault> HaplyDevice::nothing_heard() noexcept {
  ++missed_;
  if (missed_ > kMostSilentTicks) return gone("The Inverse Service is silent.");
  if (missed_ > kMostMissed || !has_sample_) {
    return failed(DeviceFault::kOther, ShortText("The Inverse Service does not answer."));
  }
  sample_.time_ns = now_ns_;
  return sample_;
}

// How old the state is that has come: it was made when the message was sent. A clock that jumped, a
// loop that stood still: no guess.
double HaplyDevice::ahead_s(std::int64_t now_ns) const noexcept {
  const double age_s = (static_cast<double>(now_ns) - static_cast<double>(sent_ns_)) / kNsPerS;
  const double most_s = 2e-9 * static_cast<double>(descriptor_.capabilities.period_ns);
  return age_s > 0.0 && age_s <= most_s ? age_s : 0.0;
}

tl::expected<PenSample, DeviceFault> HaplyDevice::read(std::int64_t now_ns) noexcept {
  now_ns_ = now_ns;
  if (!is_gone_) hear_events();
  if (is_gone_) return failed(DeviceFault::kDisconnected, gone_words_);
  if (unanswered_ == 0) send({});
  switch (is_gone_ ? Heard::kClosed : hear_all(has_sample_ ? kWaitNs : kFirstWaitNs)) {
    case Heard::kClosed:
      return gone("The connection to the service was closed.");
    case Heard::kNothing:
      return nothing_heard();
    case Heard::kBad:
      missed_ = 0;
      return failed(DeviceFault::kBadData, ShortText("The service's message is not readable."));
    case Heard::kState:
      break;
  }
  missed_ = 0;
  if (!state_.has_device) return gone("The service does not know the device any more.");
  is_calibrated_ = state_.calibrated.value_or(is_calibrated_);
  if (!is_calibrated_) {
    return failed(DeviceFault::kNotCalibrated, ShortText("The device is not calibrated."));
  }
  sample_.time_ns = now_ns;
  sample_.velocity = kMmPerM * state_.velocity_m_per_s;
  sample_.position = kMmPerM * state_.position_m + ahead_s(now_ns) * sample_.velocity;
  sample_.buttons = state_.buttons;
  axis_ = state_.grip_axis;
  has_sample_ = true;
  check_that_force_is_heard();
  if (!brake_is_on_) status_.fault.reset();
  ++status_.reads;
  count_rate(now_ns);
  shown_.publish(status_);
  return sample_;
}

tl::expected<void, DeviceFault> HaplyDevice::write(const Force& force) noexcept {
  if (is_gone_) return tl::unexpected(DeviceFault::kDisconnected);
  const ForceGate::Passed passed = gate_.pass(force, now_ns_);
  const bool is_off = brake_is_on_ || force_stopped_.has_value();
  if (is_off) gate_.let_go();
  if (unanswered_ > 0 || !has_answered_) {
    send_nothing();
  } else {
    send(is_off ? Force{} : passed.force);
  }
  if (is_gone_) return tl::unexpected(DeviceFault::kDisconnected);
  if (!passed.was_finite) {
    return failed(DeviceFault::kBadData, ShortText("A force was asked for that is no number."));
  }
  if (!is_off) return {};
  const ShortText words = force_stopped_.value_or(brake_words_);
  force_stopped_.reset();
  return failed(DeviceFault::kForcesOff, words);
}

void HaplyDevice::stop() noexcept {
  gate_.let_go();
  if (is_gone_) {
    tell_to_let_go();
  } else {
    send({});
  }
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
    if (unanswered_ == 0) send({});
    const Heard heard = hear_all(kHomingWaitNs);
    if (heard == Heard::kClosed) gone("The connection was closed.");
    if (heard == Heard::kNothing) ask_anew();
    if (is_gone_) break;
    if (state_.calibrated.value_or(is_calibrated_)) {
      is_calibrated_ = true;
      return {};
    }
    std::this_thread::sleep_for(kHomingPause);
  }
  return fail(ErrorCode::kIo, is_gone_ ? "The connection to the Inverse Service was closed."
                                       : "The device is still not calibrated. Put the handle into "
                                         "the inkwell once more, or calibrate it in Haply Hub.");
}

}  // namespace felt::haply
