#include "felt/replay/record_run.h"

#include <algorithm>
#include <thread>
#include <utility>

namespace felt {
namespace {

constexpr std::chrono::milliseconds kTurn{4};
constexpr std::chrono::milliseconds kLook{500};

const char* fault_words(SafetyFault fault) {
  switch (fault) {
    case SafetyFault::kNone:
      return "";
    case SafetyFault::kLateTick:
    case SafetyFault::kVeryLateTick:
      return "the loop was late, because this computer is busy or does not permit real time";
    case SafetyFault::kTooFast:
      return "the pen was too fast";
    case SafetyFault::kEditSilent:
      return "the program did not respond for a while";
    case SafetyFault::kNotFinite:
      return "the device reported something that is not a number";
    case SafetyFault::kDeviceError:
      return "the device reported an error";
    case SafetyFault::kPositionJump:
      return "the pen's position jumped";
    case SafetyFault::kTooManyFaults:
      return "too many faults occurred";
    case SafetyFault::kSelfTest:
      return "invalid safety limits";
  }
  return "";
}

std::string vendor_words(const DeviceStatus& status) {
  const std::string words(status.vendor_words.view());
  return words.empty() ? "" : " Its message: " + words;
}

}  // namespace

RecordRun::RecordRun(const RealDevice& device, Session& session, RecordOptions options)
    : device_(device),
      session_(session),
      options_(std::move(options)),
      wants_forces_(options_.forces),
      has_agreed_(options_.forces || options_.has_agreed) {}

Result<void> RecordRun::begin() {
  Result<std::unique_ptr<LiveLoop>> loop =
      LiveLoop::start(device_, options_.page, options_.force_limit_n, options_.may_move);
  if (!loop) return tl::unexpected(loop.error());
  loop_ = *std::move(loop);
  reported_faults_ = 0;
  reported_cuts_ = 0;
  reported_device_fault_.reset();
  reported_notice_.reset();
  offset_ns_ = last_ns_ - loop_->thread().now_ns();
  if (last_ns_ == 0) offset_ns_ = 0;
  notice(describe(loop_->thread().status()));
  const UseDevice device{with_force_limit(loop_->device().capabilities(), options_.force_limit_n)};
  if (Result<void> reported = session_.apply({last_ns_, device}); !reported) return reported;
  loop_->servo().set_session_offset(offset_ns_);
  loop_->servo().publish(session_.force());
  if (wants_forces_) loop_->servo().arm();
  return {};
}

std::int64_t RecordRun::elapsed_ns() const {
  return std::chrono::nanoseconds(Clock::now() - start_).count();
}

bool RecordRun::is_over() const {
  if (options_.is_over && options_.is_over()) return true;
  return options_.seconds && static_cast<double>(elapsed_ns()) > 1e9 * *options_.seconds;
}

Result<void> RecordRun::draw() {
  Result<void> done;
  start_ = Clock::now();
  while (done && !hangs_ && !is_over()) {
    std::this_thread::sleep_for(kTurn);
    done = turn();
    if (done && options_.wants_pause && options_.wants_pause()) done = pause();
    if (options_.keep) options_.keep(session_);
  }
  end_loop();
  Result<void> finished = session_.finish();
  if (!done) return done;
  if (!finished || !hangs_) return finished;
  return fail(ErrorCode::kIo, device_.found.label +
                                  " stopped responding and was disconnected; the ink was kept. "
                                  "Unplug it, plug it in again, and record again");
}

/// Stops the device, because the program and its loop are suspended and no force may remain. Forces
/// stay off afterwards.
Result<void> RecordRun::pause() {
  if (!loop_) return {};
  wants_forces_ = false;
  if (Result<void> finished = session_.finish(); !finished) return finished;
  if (!loop_->stop()) {
    hangs_ = true;
    loop_.reset();
    return {};
  }
  options_.pause();
  if (Result<void> started = loop_->go_on(); !started) return reconnect(started.error().message);
  notice("Forces are off. Press Enter to allow them again.");
  return {};
}

void RecordRun::end_loop() {
  if (loop_ && !loop_->stop()) hangs_ = true;
  loop_.reset();
}

Result<void> RecordRun::turn() {
  Servo& servo = loop_->servo();
  servo.heartbeat(loop_->thread().now_ns());
  for (PenSample sample; servo.for_edit().pop(sample);) {
    sample.time_ns = last_ns_ = std::max(last_ns_, sample.time_ns + offset_ns_);
    if (Result<void> reported = session_.sample(sample); !reported) {
      if (reported.error().code != ErrorCode::kLimitExceeded) return reported;
      notice("This gesture changes nothing: " + reported.error().message + ".");
    }
  }
  servo.publish(session_.force());
  const TickReport& report = servo.latest();
  if (Result<void> noted = report_tick(report); !noted) return noted;
  report_faults(report);
  report_status(report);
  handle_enter();
  const DeviceStatus status = loop_->device().status();
  if (status.fault == DeviceFault::kDisconnected) {
    return reconnect(std::string(describe(*status.fault)) + vendor_words(status));
  }
  if (loop_->thread().status().is_silent) {
    return reconnect("The device stopped responding.");
  }
  return {};
}

Result<void> RecordRun::report_tick(const TickReport& report) {
  if (!options_.on_tick || !report.sample_ok) return {};
  const std::int64_t time_ns = report.sample.time_ns + offset_ns_;
  if (time_ns <= last_tick_ns_) return {};
  last_tick_ns_ = time_ns;
  TickReport shifted = report;
  shifted.sample.time_ns = time_ns;
  return options_.on_tick(shifted);
}

void RecordRun::report_faults(const TickReport& report) {
  const DeviceStatus status = loop_->device().status();
  if (status.fault != reported_device_fault_) {
    reported_device_fault_ = status.fault;
    if (status.fault) {
      notice(std::string(describe(*status.fault)) + vendor_words(status) +
             " The ink so far is kept.");
    }
  }
  // The notice from opening the device was reported already.
  if (reported_notice_.value_or(status.notice) != status.notice && !status.notice.empty()) {
    notice(std::string(status.notice.view()));
  }
  reported_notice_ = status.notice;
  if (report.ink_cuts > reported_cuts_) {
    notice(
        "The device reported impossible positions. The stroke ended there; anything you drew until "
        "the positions were plausible again is missing.");
  }
  reported_cuts_ = report.ink_cuts;
  const SafetyReport& safety = report.safety;
  const std::uint32_t faults = safety.soft_faults + safety.hard_faults;
  if (faults == reported_faults_) return;
  reported_faults_ = faults;
  const bool is_off = safety.state == SafetyState::kLatched;
  notice(std::string(is_off ? "forces off: " : "forces fade out and start again: ") +
         fault_words(safety.fault) + "." + (is_off ? " Press Enter to allow them again." : ""));
}

void RecordRun::report_status(const TickReport& report) const {
  if (!options_.on_status) return;
  options_.on_status({.rate_hz = loop_->thread().stats().rate_hz(),
                      .sent_n = norm(report.sent),
                      .state = report.safety.state,
                      .strokes = session_.document().stroke_count(),
                      .wants_forces = wants_forces_});
}

void RecordRun::notice(const std::string& words) const {
  if (options_.on_notice) options_.on_notice(words);
}

void RecordRun::handle_enter() {
  if (!is_enter_pressed()) return;
  if (!has_agreed_) {
    if (options_.ask_consent) options_.ask_consent();
    has_agreed_ = true;
    return;
  }
  const bool is_latched = loop_->servo().latest().safety.state == SafetyState::kLatched;
  wants_forces_ = is_latched || !wants_forces_;
  wants_forces_ ? loop_->servo().arm() : loop_->servo().disarm();
}

Result<void> RecordRun::reconnect(const std::string& why) {
  notice(why +
         " The ink so far is kept. Connect the device again to continue; Ctrl-C saves and ends.");
  // The loss of the device is a fault that latches: only the user can switch forces on again.
  const bool had_forces = std::exchange(wants_forces_, false);
  if (Result<void> finished = session_.finish(); !finished) return finished;
  end_loop();
  const Clock::time_point lost = Clock::now();
  const std::int64_t lost_ns = last_ns_;
  std::optional<Error> refusal;
  while (!hangs_ && !is_over()) {
    std::this_thread::sleep_for(kLook);
    if (options_.wants_pause && options_.wants_pause()) options_.pause();  // no device, no force
    if (!is_back()) {
      refusal.reset();  // retried after it is plugged in again
      continue;
    }
    last_ns_ = lost_ns + std::chrono::nanoseconds(Clock::now() - lost).count();
    if (!tries_again(refusal)) continue;
    notice(std::string("The device is back.") +
           (had_forces ? " Its forces are off. Press Enter to allow them again." : ""));
    return {};
  }
  return {};
}

/// Opens the device again. Returns false if that failed. The reason is reported once. If the user
/// refused, waits for the user; if a port is not free yet, tries again later.
bool RecordRun::tries_again(std::optional<Error>& refusal) {
  const auto waits = [](const Error& error) { return error.code == ErrorCode::kUnsupported; };
  const bool has_waited = refusal && waits(*refusal);
  if (has_waited && !is_enter_pressed()) return false;
  const Result<void> begun = begin();
  if (begun) return true;
  const bool is_reported = refusal && !has_waited && refusal->message == begun.error().message;
  refusal = begun.error();
  if (!is_reported) {
    notice(refusal->message + (waits(*refusal)
                                   ? ". Press Enter or plug the device in again to retry."
                                   : ". Retrying."));
  }
  return false;
}

bool RecordRun::is_back() const {
  const std::vector<DeviceDescriptor> found = device_.driver->find();
  return std::any_of(found.begin(), found.end(),
                     [this](const auto& device) { return device.id == device_.found.id; });
}

bool RecordRun::is_enter_pressed() const {
  return options_.enter_pressed && options_.enter_pressed();
}

}  // namespace felt
