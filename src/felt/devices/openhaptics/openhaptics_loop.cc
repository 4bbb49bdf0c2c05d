// The functions of the device outside of ticks: its loop, homing and destructor. They run on the
// edit thread, except serve().
#include <chrono>
#include <thread>
#include <utility>

#include "felt/devices/openhaptics/hd_faults.h"
#include "felt/devices/openhaptics/openhaptics_device.h"

namespace felt {
namespace {

using std::chrono::milliseconds;

constexpr int kMaxHomingMs = 4000;
constexpr int kHomingStepMs = 10;
constexpr int kMaxWaitMs = 1000;  // wait for a call that is in progress when the scheduler stops

// Returns the texts of all errors except force errors, which are handled in the ticks.
std::string hindrances(const HdFunctions& call) {
  std::string words;
  drain_errors(call, 64, [&](const hd::ErrorInfo& error) {
    const DeviceFault fault = fault_of(error.code);
    if (fault == DeviceFault::kForcesOff || fault == DeviceFault::kOverheated) return;
    const char* text = call.error_words(error.code);
    words += (words.empty() ? "" : "; ") + std::string(text != nullptr ? text : "no message");
  });
  return words;
}

}  // namespace

OpenHapticsDevice::OpenHapticsDevice(std::shared_ptr<HdLibrary> library, hd::Handle handle,
                                     DeviceDescriptor descriptor)
    : library_(std::move(library)),
      call_(library_->call()),
      handle_(handle),
      descriptor_(std::move(descriptor)),
      senses_(find_senses()),
      gate_(descriptor_.capabilities),
      warmth_(gate_.max_n(), descriptor_.capabilities.continuous_force_n) {
  PlainNumbers::prepare();
  statuses_.publish(status_);
}

OpenHapticsDevice::~OpenHapticsDevice() {
  const PlainNumbers plain;
  OpenHapticsDevice::stop_loop();
  // If a call hangs in the library, it still uses this object, so the destructor must wait for it.
  // A caller that must not wait abandons the device without destroying it (RealtimeThread::stop).
  while (is_in_callback_.load()) std::this_thread::sleep_for(milliseconds(1));
  call_.disable(hd::capability::kForceOutput);
  call_.disable_device(handle_);
  static_cast<void>(hindrances(call_));  // so that the next device does not see these errors
  library_->give_back();
}

// Finds out which sensors exist. Outside of a frame the library returns the values of the last
// frame, which is enough to see whether it supports the parameter.
OpenHapticsDevice::Senses OpenHapticsDevice::find_senses() const noexcept {
  const auto knows = [this](auto ask) {
    drain_errors(call_, 64, [](const hd::ErrorInfo&) {});
    ask();
    return drain_errors(call_, 64, [](const hd::ErrorInfo&) {}) == 0;
  };
  Senses senses;
  senses.temperature = knows([this] {
    std::array<double, 6> warm{};
    call_.get_doubles(hd::parameter::kMotorTemperature, warm.data());
  });
  unsigned char state = hd::kFalse;
  senses.safety_switch = knows([&] { call_.get_booleans(hd::parameter::kSafetySwitch, &state); });
  senses.inkwell = knows([&] { call_.get_booleans(hd::parameter::kInkwell, &state); });
  int hz = 0;
  senses.rate = knows([&] { call_.get_integers(hd::parameter::kMeasuredUpdateRate, &hz); });
  senses.attitude = knows([this] {
    std::array<double, 16> transform{};
    call_.get_doubles(hd::parameter::kTransform, transform.data());
  });
  return senses;
}

DeviceStatus OpenHapticsDevice::status() noexcept {
  statuses_.update();
  return statuses_.get();
}

unsigned OpenHapticsDevice::serve(void* self) {
  return static_cast<OpenHapticsDevice*>(self)->serve();
}

unsigned OpenHapticsDevice::serve() noexcept {
  is_in_callback_.store(true);
  const bool is_serving = is_serving_.load();
  if (is_serving) {
    if (!is_greeted_) PlainNumbers::keep();
    is_greeted_ = true;
    begin_tick();
    tick_(context_);
    end_tick();
  }
  is_in_callback_.store(false);
  return hd::kCallbackContinue;
}

Result<void> OpenHapticsDevice::start_loop(Tick tick, void* context) {
  if (loop_runs_)
    return fail(ErrorCode::kInvalidArgument, "the loop of the device is already running");
  const PlainNumbers plain;
  static_cast<void>(hindrances(call_));
  tick_ = tick;
  context_ = context;
  is_greeted_ = false;
  is_serving_.store(true);
  callback_ = call_.schedule(&OpenHapticsDevice::serve, this, hd::kFirst);
  std::string words = hindrances(call_);
  if (words.empty()) {
    call_.enable(hd::capability::kForceOutput);
    is_output_on_ = true;
    call_.start_scheduler();
    loop_runs_ = true;
    words = hindrances(call_);
    if (words.empty()) return {};
    stop_loop();
  }
  is_serving_.store(false);
  return fail(ErrorCode::kIo, "OpenHaptics could not start the loop of the device: " + words);
}

void OpenHapticsDevice::stop_loop() noexcept {
  if (!std::exchange(loop_runs_, false)) return;
  // This must come first, so that a call that begins now does nothing: serve() sets is_in_callback_
  // before it reads is_serving_, and this function writes is_serving_ before it reads
  // is_in_callback_ (all sequentially consistent).
  is_serving_.store(false);
  call_.stop_scheduler();
  for (int i = 0; i < kMaxWaitMs && is_in_callback_.load(); ++i) {
    std::this_thread::sleep_for(milliseconds(1));
  }
  call_.unschedule(callback_);
  drain_errors(call_, 64, [](const hd::ErrorInfo&) {});
  publish();  // safe, because the scheduler's thread does not publish now
}

hd::Enum OpenHapticsDevice::style() const noexcept {
  int styles = 0;
  call_.get_integers(hd::parameter::kCalibrationStyle, &styles);
  const auto bits = static_cast<hd::Enum>(styles);
  // Prefers the calibration style with which the user has to do least.
  if ((bits & hd::calibration::kAuto) != 0) return hd::calibration::kAuto;
  if ((bits & hd::calibration::kInkwell) != 0) return hd::calibration::kInkwell;
  return hd::calibration::kEncoderReset;
}

Homing OpenHapticsDevice::homing() noexcept {
  const PlainNumbers plain;
  const hd::Enum how = style();
  hd::Enum state = call_.check_calibration();
  if (state == hd::calibration::kNeedsUpdate) {  // the library has all the data for it
    call_.update_calibration(how);
    state = call_.check_calibration();
  }
  drain_errors(call_, 64, [](const hd::ErrorInfo&) {});
  if (state == hd::calibration::kOk) return Homing::kNone;
  return how == hd::calibration::kInkwell ? Homing::kInkwell : Homing::kRestPose;
}

std::string OpenHapticsDevice::homing_words() {
  if (homing() == Homing::kNone) return {};
  switch (style()) {
    case hd::calibration::kInkwell:
      return "Put the stylus into its inkwell, all the way in, and leave it there for a moment.";
    case hd::calibration::kAuto:
      return "Move the stylus slowly through its whole range, so that the device can calibrate "
             "itself.";
    default:
      return "Bring the arm to its rest pose, all joints at right angles, and hold it still.";
  }
}

Result<void> OpenHapticsDevice::find_home() {
  if (loop_runs_) return fail(ErrorCode::kInvalidArgument, "the loop of the device is running");
  const PlainNumbers plain;
  const hd::Enum how = style();
  call_.disable(hd::capability::kForceOutput);
  call_.start_scheduler();  // the library checks its joints only while the scheduler runs
  std::string words = hindrances(call_);
  bool is_home = false;
  for (int ms = 0; words.empty() && !is_home && ms < kMaxHomingMs; ms += kHomingStepMs) {
    if (call_.check_calibration() != hd::calibration::kOk) {
      call_.update_calibration(how);
    }
    is_home = call_.check_calibration() == hd::calibration::kOk;
    words = hindrances(call_);
    if (!is_home) std::this_thread::sleep_for(milliseconds(kHomingStepMs));
  }
  call_.stop_scheduler();
  drain_errors(call_, 64, [](const hd::ErrorInfo&) {});
  if (is_home) return {};
  if (words.empty()) {
    words = "it did not reach the calibration position within " +
            std::to_string(kMaxHomingMs / 1000) + " s";
  }
  return fail(ErrorCode::kIo, "The device is not calibrated: " + words + ". " + homing_words() +
                                  " Then try again.");
}

}  // namespace felt
