#include "felt/devices/pantograph/pantograph_device.h"

#include <algorithm>
#include <cstring>
#include <span>
#include <string>
#include <utility>

namespace felt::pantograph {
namespace {

constexpr double kLess =
    1.0 - 3e-6;  // margin, so that rounding to the board's floats cannot increase a torque
constexpr int kMaxUnanswered = 4;
constexpr int kMaxPieces = 8;  // pieces in which one answer may arrive
constexpr double kNsPerS = 1e9;
constexpr double kFilterHz = 80.0;
constexpr double kJumpMm = 0.5;  // a hand cannot move so far in a tick

constexpr std::int64_t kSetUpNs = 300'000'000;
constexpr int kSetUpTries = 4;
constexpr std::int64_t kResetPauseNs = 100'000'000;

// Returns the smallest gain of all versions. It is used for every board, because a board of another
// version than expected could turn the same number into too much torque.
double min_gain() noexcept {
  double smallest = 1.0;
  for (const BoardModel& model : board_models()) smallest = std::min(smallest, model.gain);
  return smallest;
}

constexpr std::string_view kNotHome = "The arms were not at rest.";
constexpr std::string_view kUnguarded =
    "The process that switches the motors off when Feltline cannot has ended: bring it home again.";

}  // namespace

PantographDevice::PantographDevice(std::unique_ptr<ByteStream> port, const BoardModel& model,
                                   DeviceDescriptor descriptor, const OpenOptions& options)
    : port_(std::move(port)),
      model_(model),
      descriptor_(std::move(descriptor)),
      gate_(descriptor_.capabilities),
      filter_(kFilterHz, kJumpMm),
      is_down_(options.pen_begins_down) {
  status_.notice = ShortText("It moves in the plane only: press a key to touch down.");
  shown_.publish(status_);
}

PantographDevice::~PantographDevice() {
  release(kEndTries);
}

DeviceStatus PantographDevice::status() noexcept {
  shown_.update();
  return shown_.get();
}

tl::unexpected<DeviceFault> PantographDevice::failed(DeviceFault fault,
                                                     std::string_view words) noexcept {
  status_.fault = status_.last_fault = fault;
  status_.vendor_words = ShortText(words);
  status_.vendor_code = port_->last_errno();
  ++status_.faults;
  shown_.publish(status_);
  return tl::unexpected(fault);
}

tl::unexpected<DeviceFault> PantographDevice::gone(std::string_view words) noexcept {
  if (!is_gone_) {
    is_gone_ = true;
    gone_words_ = ShortText(words);
    release(kStopTries);
  }
  return failed(DeviceFault::kDisconnected, gone_words_.view());
}

bool PantographDevice::send(const std::array<double, 2>& torques_nm) noexcept {
  const auto sent = port_->send(torque_frame(model_, torques_nm), kSendNs);
  if (!sent) {
    if (sent.error() != StreamFault::kTimedOut) gone("The board was unplugged.");
    return false;
  }
  unanswered_ = std::min(unanswered_ + 1, kMaxUnanswered);
  sent_ns_ = now_ns_;
  return true;
}

// Discards all waiting bytes, because they do not answer the current request.
void PantographDevice::throw_away() noexcept {
  filled_ = 0;
  unanswered_ = 0;
  for (int i = 0; i < kMaxPieces; ++i) {
    if (!port_->receive(in_, 0)) return;
  }
}

PantographDevice::Received PantographDevice::take_reply() noexcept {
  const auto reply = std::span<const std::byte>(in_).first<kReplyBytes>();
  std::array<double, 2> angles{};
  const bool is_ours = std::to_integer<std::uint8_t>(reply[0]) == kDeviceId;
  if (!is_ours || !read_angles(model_, reply, angles)) return Received::kBad;
  const auto bar = FiveBar::at(model_.size, angles);
  if (!bar) return Received::kBad;
  angles_rad_ = angles;
  bar_ = bar;
  filled_ -= kReplyBytes;
  std::memmove(in_.data(), in_.data() + kReplyBytes, filled_);
  if (unanswered_ > 0) --unanswered_;
  return Received::kAngles;
}

// Reads the waiting answers. Returns the result of the newest complete answer, or kBad after the
// first invalid one.
PantographDevice::Received PantographDevice::take_replies(Received newest) noexcept {
  while (filled_ >= kReplyBytes && newest != Received::kBad) newest = take_reply();
  return newest;
}

// Reads all waiting answers and returns the result of the newest. This includes answers to the
// guard's frames, which this object did not send. Waits only for the first answer.
PantographDevice::Received PantographDevice::receive(std::int64_t within_ns) noexcept {
  const StreamDeadline deadline(within_ns);
  Received newest = Received::kNothing;
  for (int i = 0; i < kMaxPieces; ++i) {
    newest = take_replies(newest);
    if (newest == Received::kBad) return newest;
    const bool has_one = newest == Received::kAngles;
    const auto count =
        port_->receive(std::span(in_).subspan(filled_), has_one ? 0 : deadline.left_ns());
    if (count) {
      filled_ += *count;
    } else if (count.error() == StreamFault::kTimedOut) {
      if (has_one) return newest;
      return filled_ > 0 ? Received::kHalf : Received::kNothing;
    } else {
      return Received::kClosed;
    }
  }
  return newest;
}

tl::expected<PenSample, DeviceFault> PantographDevice::nothing_received(
    Received received) noexcept {
  ++missed_;
  if (missed_ > kMaxSilentTicks) return gone("The board sends nothing.");
  if (missed_ > kMaxMissed || !has_sample_) {
    const bool is_half = received == Received::kHalf;
    throw_away();
    return is_half ? failed(DeviceFault::kBadData, "The board's answers are too short.")
                   : failed(DeviceFault::kOther, "The board does not answer.");
  }
  return sample_;
}

void PantographDevice::place_pen(std::int64_t now_ns) noexcept {
  const auto since_s = [](std::int64_t from, std::int64_t to) {
    return (static_cast<double>(to) - static_cast<double>(from)) / kNsPerS;
  };
  filter_.update(bar_->place(), since_s(received_ns_, sent_ns_));
  received_ns_ = sent_ns_;
  const double age_s = since_s(sent_ns_, now_ns);
  const double max_s = 2e-9 * static_cast<double>(descriptor_.capabilities.period_ns);
  const double ahead_s = age_s > 0.0 && age_s <= max_s ? age_s : 0.0;
  sample_.velocity = filter_.velocity();
  sample_.position = filter_.position() + ahead_s * filter_.velocity();
  sample_.position.z = is_down_.load(std::memory_order_relaxed) ? kDownMm : kUpMm;
  sample_.time_ns = now_ns;
}

tl::expected<PenSample, DeviceFault> PantographDevice::read(std::int64_t now_ns) noexcept {
  now_ns_ = now_ns;
  if (is_gone_) return failed(DeviceFault::kDisconnected, gone_words_.view());
  if (!is_home_) return failed(DeviceFault::kNotCalibrated, kNotHome);
  if (unanswered_ == 0 && send({})) sent_ = {};
  const Received received = is_gone_ ? Received::kClosed : receive(kWaitNs);
  switch (received) {
    case Received::kClosed:
      return gone("The board was unplugged.");
    case Received::kNothing:
    case Received::kHalf:
      return nothing_received(received);
    case Received::kBad:
      bar_.reset();
      throw_away();
      return failed(DeviceFault::kBadData, "The board's answer is invalid.");
    case Received::kAngles:
      break;
  }
  missed_ = 0;
  place_pen(now_ns);
  has_sample_ = true;
  status_.fault.reset();
  ++status_.reads;
  shown_.publish(status_);
  return sample_;
}

tl::expected<void, DeviceFault> PantographDevice::write(const Force& force) noexcept {
  if (is_gone_) return tl::unexpected(DeviceFault::kDisconnected);
  if (!is_set_up_) {
    gate_.release();
    return failed(DeviceFault::kNotCalibrated, kNotHome);
  }
  const ForceGate::Passed passed =
      gate_.pass(is_finite(force) ? Force{force.x, force.y, 0.0} : force, now_ns_);
  Force pushes;
  const bool is_guarded = port_->is_guarded();
  if (bar_ && is_home_ && is_guarded && missed_ <= kMaxMissed) {
    pushes = (kLess * bar_->authority()) * passed.force;
  } else {
    gate_.release();
  }
  const bool went = send(bar_ ? bar_->torques(pushes) : std::array<double, 2>{});
  if (went) sent_ = pushes;
  if (is_gone_) return tl::unexpected(DeviceFault::kDisconnected);
  if (!passed.was_finite) {
    return failed(DeviceFault::kBadData, "The requested force is not a number.");
  }
  if (!went) return failed(DeviceFault::kOther, "The board does not accept data.");
  if (!is_guarded) return failed(DeviceFault::kForcesOff, kUnguarded);
  return {};
}

// Sends zero torques, even to a board that was treated as disconnected, because it may still
// receive. Sends a reset instead to a board that is not set up, because that must not receive
// torques, not even zero.
void PantographDevice::release(int tries) noexcept {
  gate_.release();
  const auto nothing = torque_frame(model_, {});
  const auto begin = reset_frame();
  const auto frame =
      is_set_up_ ? std::span<const std::byte>(nothing) : std::span<const std::byte>(begin);
  for (int i = 0; i < tries; ++i) {
    const auto sent = port_->send(frame, kSendNs);
    if (sent) {
      sent_ = {};
      if (!is_set_up_) return;  // the board does not answer a reset
      unanswered_ = std::min(unanswered_ + 1, kMaxUnanswered);
      sent_ns_ = now_ns_;
      return;
    }
    if (sent.error() != StreamFault::kTimedOut) {
      if (!is_gone_) gone("The board was unplugged.");
      return;
    }
  }
}

void PantographDevice::stop() noexcept {
  release(kStopTries);
}

std::string PantographDevice::homing_words() {
  if (is_home_) return {};
  std::string words =
      "This device is set up as " + std::string(model_.label) +
      ". Measure it: with the wrong model, lines are bent and forces point the wrong way";
  if (model_.gain > min_gain()) words += ", and the first model is more than ten times as strong";
  return words +
         ". Then push both arms outwards as far as they go, and hold them there: the device counts "
         "from this position.";
}

Result<void> PantographDevice::set_up() {
  // Ends the guard process, because below nothing is sent for a while, so that the guard would send
  // torques; but a board that restarts must not receive any.
  static_cast<void>(port_->keep_guard({}, 0));
  is_set_up_ = false;
  sent_ = {};
  if (!port_->send(reset_frame(), kSetUpNs)) {
    return fail(ErrorCode::kIo, "The board does not accept data.");
  }
  // The board may send something while it restarts, or nothing.
  const StreamDeadline pause(kResetPauseNs);
  while (port_->receive(in_, pause.left_ns()).has_value() && pause.left_ns() > 0) {
  }
  throw_away();
  if (!port_->send(setup_frame(model_), kSetUpNs)) {
    return fail(ErrorCode::kIo, "The board does not accept data.");
  }
  is_set_up_ = true;
  for (int i = 0; i < kSetUpTries && !is_gone_; ++i) {
    throw_away();
    send({});
    const Received received = receive(kSetUpNs);
    if (received == Received::kAngles) {
      if (port_->keep_guard(torque_frame(model_, {}), kGuardNs)) return {};
      return fail(ErrorCode::kIo,
                  "The second process, which switches the motors off if Feltline cannot, could not "
                  "be started: this computer has too little memory or too many processes.");
    }
    if (received == Received::kClosed) gone("The board was unplugged.");
  }
  return fail(ErrorCode::kIo, is_gone_ ? "The board was unplugged."
                                       : "The device on this port does not answer like a 2DIY. Is "
                                         "it this model, and does it have power?");
}

Result<void> PantographDevice::find_home() {
  auto done = set_up();
  is_home_ = done.has_value();
  has_sample_ = false;
  filter_.reset();
  return done;
}

}  // namespace felt::pantograph
