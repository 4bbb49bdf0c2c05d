// A libHD of our own for tests: the vendor's names, types and rules
// (docs/design/devices.md#openhaptics; OpenHaptics reference), with a simulated stylus behind it
// (fake_machine.h). If a program makes a forbidden call, the library returns the vendor's error and
// stores the broken rule.
#include "tests/devices/drivers/openhaptics/fake_libhd.h"

#include <locale.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "felt/rt/device.h"
#include "tests/devices/drivers/openhaptics/fake_machine.h"
#include "tests/devices/drivers/openhaptics/fake_values.h"

namespace felt::fake_libhd {
namespace {

template <class Number>
void get_reals(hd::Enum what, Number* out) {
  const Guard guard;
  const Value* value = find_value(what, Kind::kReal);
  if (value == nullptr) return;
  const std::array<double, 16> all = reals(what);
  for (std::size_t i = 0; i < value->count; ++i) out[i] = static_cast<Number>(all[i]);
}

template <class Number>
void set_reals(hd::Enum what, const Number* in) {
  const Guard guard;
  Fake& f = fake();
  if (what != parameter::kForce) {
    broken("set what cannot be set", error::kInvalidEnum);
    return;
  }
  if (!f.frame_is_open || !is_in_tick()) {
    broken("a force was set outside of a frame", error::kFrameError);
    return;
  }
  for (std::size_t i = 0; i < 3; ++i) f.asked[i] = static_cast<double>(in[i]);
}

constexpr FakeHdControl kControl{
    .reset = reset,
    .plug_in =
        [](const FakeHdModel* model, const FakeHdWorld* world) {
          fake().model = *model;
          fake().world = *world;
        },
    .occupy = [](int on) { fake().is_occupied = on != 0; },
    .use_thread = [](int on) { fake().uses_thread = on != 0; },
    .step = step,
    .open_tick = open_tick,
    .close_tick = close_tick,
    .push_error =
        [](unsigned code, int internal_code) {
          const Guard guard;
          push(code, internal_code);
        },
    .set_safety_switch = [](int closed) { fake().safety_switch = closed != 0; },
    .set_inkwell = [](int inside) { fake().inkwell = inside != 0; },
    .set_at_rest = [](int at_rest) { fake().at_rest = at_rest != 0; },
    .set_home = [](int is_home) { fake().is_home = is_home != 0; },
    .set_temperature = [](double warmest) { fake().temperature = warmest; },
    .refuse_scheduler = [](unsigned code) { fake().refusal = code; },
    .call_while_stopping = [] { fake().calls_while_stopping = true; },
    .largest_asked_n = [] { return fake().largest_n; },
    .broken_rule = [] { return fake().rule; },
    .is_enabled = [](unsigned what) { return has(what) ? 1 : 0; },
    .is_running = [] { return fake().is_running ? 1 : 0; },
    .callbacks = [] { return static_cast<int>(fake().callbacks.size()); },
    .open_devices = [] { return fake().open; },
    .frames = [] { return fake().frames; },
    .temperature = [] { return fake().temperature; },
};

}  // namespace
}  // namespace felt::fake_libhd

// ------------------------------------------------------------------------- the vendor's functions

#define FAKE_HD extern "C" __attribute__((visibility("default")))

using namespace felt;
using namespace felt::fake_libhd;

FAKE_HD const FakeHdControl* fake_hd_control() {
  return &kControl;
}

FAKE_HD hd::Handle hdInitDevice(const char* name) {
  const Guard guard;
  Fake& f = fake();
  if (f.capabilities.empty()) start_capabilities();
  if (uselocale(nullptr) == LC_GLOBAL_LOCALE) {
    broken("a device was opened with the program's decimal point");
  }
  plug_in_own();
  const auto is_called = [name](const char* it) {
    return it != nullptr && name != nullptr && std::strcmp(name, it) == 0;
  };
  if (!f.model ||
      !(name == nullptr ? f.model->opens_without_name != 0
                        : is_called(f.model->name) || is_called(f.model->second_name))) {
    push(error::kDeviceFault, 1);
    return hd::kNoHandle;
  }
  if (f.is_occupied || f.open > 0) {
    if (f.open > 0) broken("a device was opened twice");
    push(error::kAlreadyInUse);
    return hd::kNoHandle;
  }
  FakeHdPen pen{};
  if (f.world.read(f.world.context, f.now_ns, &pen) ==
      1 + static_cast<int>(DeviceFault::kDisconnected)) {
    push(error::kCommunication, 2);
    return hd::kNoHandle;
  }
  f.open = 1;
  start_capabilities();
  f.frame = {};
  f.asked = {};
  f.held_n = 0.0;
  return kHandle;
}

FAKE_HD void hdDisableDevice(hd::Handle handle) {
  const Guard guard;
  Fake& f = fake();
  if (handle != kHandle || f.open == 0) return broken("closed what is not open", error::kBadHandle);
  if (f.is_running) broken("a device was closed while the scheduler ran");
  release();
  f.open = 0;
}

FAKE_HD hd::Handle hdGetCurrentDevice() {
  return fake().open > 0 ? kHandle : hd::kNoHandle;
}

FAKE_HD void hdMakeCurrentDevice(hd::Handle handle) {
  const Guard guard;
  if (handle != kHandle) push(error::kBadHandle);
}

FAKE_HD void hdBeginFrame(hd::Handle handle) {
  const Guard guard;
  Fake& f = fake();
  if (handle != kHandle || f.open == 0) return broken("a frame of no device", error::kBadHandle);
  if (!is_in_tick()) return broken("a frame outside of the servo loop", error::kIllegalBegin);
  if (f.frame_is_open) return broken("a frame in a frame", error::kIllegalBegin);
  if (f.frame_was && has(capability::kOneFrameLimit)) {
    return broken("a second frame in one tick", error::kIllegalBegin);
  }
  if (f.uses_thread && uselocale(nullptr) == LC_GLOBAL_LOCALE) {
    broken("a frame under the program's decimal point");
  }
  f.frame_is_open = true;
  f.asked = {};
  if (f.read_result == 0) {
    f.frame.pen = f.read_pen;
  } else if (!f.calibration_lost) {
    push(error_of(f.read_result), f.read_result);
  }
  f.frame.safety_switch = f.safety_switch;
  f.frame.inkwell = f.inkwell;
}

FAKE_HD void hdEndFrame(hd::Handle handle) {
  const Guard guard;
  Fake& f = fake();
  if (handle != kHandle || f.open == 0) return broken("a frame of no device", error::kBadHandle);
  if (!f.frame_is_open || !is_in_tick()) {
    return broken("the end of a frame that did not begin", error::kIllegalEnd);
  }
  f.frame_is_open = false;
  f.frame_was = true;
  ++f.frames;
  send();
}

FAKE_HD hd::ErrorInfo hdGetError() {
  const Guard guard;
  Fake& f = fake();
  if (f.error_count == 0) return {error::kNone, 0, hd::kNoHandle};
  return f.errors[--f.error_count];
}

FAKE_HD const char* hdGetErrorString(hd::Enum code) {
  switch (code) {
    case error::kNone:
      return "No error";
    case error::kWarmMotors:
      return "Fake: motors are warm";
    case error::kTooMuchForce:
      return "Fake: maximum force exceeded";
    case error::kTooFast:
      return "Fake: maximum velocity exceeded";
    case error::kForceError:
      return "Fake: force error";
    case error::kDeviceFault:
      return "Fake: device fault";
    case error::kAlreadyInUse:
      return "Fake: device already initiated";
    case error::kCommunication:
      return "Fake: communication error";
    case error::kTimer:
      return "Fake: timer error";
    case error::kSchedulerFull:
      return "Fake: scheduler full";
    default:
      return "Fake: other error";
  }
}

namespace {
void set_capability(hd::Enum what, bool on) {
  const Guard guard;
  if (fake().open == 0) return broken("switched without a device", error::kBadHandle);
  for (auto& [known, state] : fake().capabilities) {
    if (known != what) continue;
    state = on;
    if (what == capability::kForceOutput && !on) release();
    return;
  }
  broken("switched what there is not", error::kInvalidEnum);
}
}  // namespace

FAKE_HD void hdEnable(hd::Enum what) {
  set_capability(what, true);
}
FAKE_HD void hdDisable(hd::Enum what) {
  set_capability(what, false);
}
FAKE_HD unsigned char hdIsEnabled(hd::Enum what) {
  const Guard guard;
  return has(what) ? hd::kTrue : hd::kFalse;
}

FAKE_HD void hdGetBooleanv(hd::Enum what, unsigned char* out) {
  const Guard guard;
  if (find_value(what, Kind::kBoolean) == nullptr) return;
  const bool state =
      what == parameter::kSafetySwitch ? fake().frame.safety_switch : fake().frame.inkwell;
  *out = state ? hd::kTrue : hd::kFalse;
}
FAKE_HD void hdGetIntegerv(hd::Enum what, int* out) {
  const Guard guard;
  if (find_value(what, Kind::kInteger) != nullptr) *out = integer(what);
}
FAKE_HD void hdGetFloatv(hd::Enum what, float* out) {
  get_reals(what, out);
}
FAKE_HD void hdGetDoublev(hd::Enum what, double* out) {
  get_reals(what, out);
}
FAKE_HD void hdGetLongv(hd::Enum what, long* out) {
  const Guard guard;
  const Value* value = find_value(what, Kind::kLong);
  if (value == nullptr) return;
  for (std::size_t i = 0; i < value->count; ++i) {  // 0.01 mm each, without a gimbal
    out[i] = i < 3 ? std::lround(100.0 * fake().frame.pen.position[i]) : 0;
  }
}
FAKE_HD const char* hdGetString(hd::Enum what) {
  const Guard guard;
  if (find_value(what, Kind::kText) == nullptr) return nullptr;
  switch (what) {
    case parameter::kModelType:
      return fake().model->type;
    case parameter::kSerialNumber:
      return fake().model->serial;
    case parameter::kVendor:
      return "Feltline's fake";
    default:
      return "fake 3.4";
  }
}

FAKE_HD void hdSetDoublev(hd::Enum what, const double* in) {
  set_reals(what, in);
}
FAKE_HD void hdSetFloatv(hd::Enum what, const float* in) {
  set_reals(what, in);
}
FAKE_HD void hdSetBooleanv(hd::Enum, const unsigned char*) {
  broken("set what cannot be set", error::kInvalidInputType);
}
FAKE_HD void hdSetIntegerv(hd::Enum, const int*) {
  broken("set what cannot be set", error::kInvalidInputType);
}
FAKE_HD void hdSetLongv(hd::Enum, const long*) {
  broken("set what cannot be set", error::kInvalidInputType);
}

FAKE_HD hd::Enum hdCheckCalibration() {
  const Guard guard;
  const Fake& f = fake();
  if (f.open == 0) {
    broken("asked without a device", error::kBadHandle);
    return calibration::kNeedsPerson;
  }
  if (f.calibration_lost) return calibration::kNeedsPerson;
  if (f.is_home) return calibration::kOk;
  const auto style = static_cast<hd::Enum>(f.model->calibration_style);
  const bool can_now = ((style & calibration::kInkwell) != 0 && f.inkwell) ||
                       ((style & calibration::kAuto) != 0 && f.at_rest);
  return can_now ? calibration::kNeedsUpdate : calibration::kNeedsPerson;
}
FAKE_HD hd::Enum hdCheckCalibrationStyle() {
  return fake().model ? static_cast<hd::Enum>(fake().model->calibration_style) : 0;
}
FAKE_HD void hdUpdateCalibration(hd::Enum style) {
  const Guard guard;
  Fake& f = fake();
  if (f.open == 0 || (style & static_cast<hd::Enum>(f.model->calibration_style)) == 0) {
    return broken("a calibration that this device does not have", error::kInvalidValue);
  }
  f.is_home = f.is_home || (style == calibration::kInkwell ? f.inkwell : f.at_rest);
}
FAKE_HD void hdUpdateCalibrationMessage(hd::Enum) {}
FAKE_HD void hdScaleGimbalAngles(double, double, double, double*) {}

FAKE_HD void hdStartScheduler() {
  Fake& f = fake();
  const Guard guard;
  if (f.refusal != 0) return push(f.refusal);
  if (f.open == 0 || f.is_running) {
    return broken("a scheduler was started twice, or without a device", error::kInvalidOperation);
  }
  f.is_running = true;
  if (!f.uses_thread) return;
  f.stop_thread.store(false);
  f.thread = std::thread(run_thread);
}
FAKE_HD void hdStopScheduler() {
  Fake& f = fake();
  if (!f.is_running) return push(error::kInvalidOperation);  // harmless after a start that failed
  if (f.uses_thread && f.thread.get_id() == std::this_thread::get_id()) {
    return broken("the scheduler was stopped from within");
  }
  if (std::exchange(f.calls_while_stopping, false)) step(f.now_ns);
  stop_running();
}
FAKE_HD void hdSetSchedulerRate(unsigned long hz) {
  const Guard guard;
  if (hz != 500 && hz != 1000 && hz != 1600)
    push(error::kInvalidValue);
  else if (fake().model)
    fake().model->rate_hz = static_cast<int>(hz);
}

FAKE_HD hd::CallbackHandle hdScheduleAsynchronous(hd::Callback call, void* data,
                                                  unsigned short priority) {
  const Guard guard;
  Fake& f = fake();
  if (f.callbacks.size() == kMaxCallbacks) {
    push(error::kSchedulerFull);
    return 0;
  }
  const Scheduled added{f.next_callback++, call, data, priority};
  const auto after = std::find_if(f.callbacks.begin(), f.callbacks.end(),
                                  [&](const Scheduled& c) { return c.priority < priority; });
  f.callbacks.insert(after, added);
  return added.handle;
}
FAKE_HD void hdScheduleSynchronous(hd::Callback call, void* data, unsigned short) {
  static_cast<void>(call(data));
}
FAKE_HD void hdUnschedule(hd::CallbackHandle handle) {
  const Guard guard;
  if (std::erase_if(fake().callbacks, [&](const Scheduled& c) { return c.handle == handle; }) ==
      0) {
    broken("unscheduled what is not scheduled", error::kInvalidOperation);
  }
}
FAKE_HD unsigned char hdWaitForCompletion(hd::CallbackHandle, unsigned) {
  return hd::kFalse;
}
FAKE_HD double hdGetSchedulerTimeStamp() {
  return 0.0;
}
FAKE_HD unsigned char hdDeploymentLicense(const char*, const char*, const char*) {
  return hd::kTrue;
}
