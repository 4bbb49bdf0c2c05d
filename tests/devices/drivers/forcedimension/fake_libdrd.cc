// A library with the names and rules of Force Dimension's C functions, for devices that a test
// plugs in (fake_libdrd.h, fake_dhd_machine.h). The numbers are copied again from the vendor's
// tables, so that a mistake in the driver's declarations is found. With FAKE_WITHOUT_DRD it is the
// smaller library, libdhd.so.
#include "tests/devices/drivers/forcedimension/fake_libdrd.h"

#include <algorithm>

#include "tests/devices/drivers/forcedimension/fake_dhd_machine.h"

#define FAKE_EXPORT extern "C" __attribute__((visibility("default")))

using namespace felt::fake_dhd;  // the vendor's names below are in the global namespace

FAKE_EXPORT Bench* felt_fake_dhd() {
  return &the_bench();
}

FAKE_EXPORT int dhdErrorGetLast() {
  return newest_error();
}

FAKE_EXPORT const char* dhdErrorGetStr(int error) {
  switch (error) {
    case 0:
      return "no error";
    case kComError:
      return "communication error between the host and the device";
    case kNoDevice:
      return "no device found";
    case kNotAvailable:
      return "feature not available";
    case kTimeout:
      return "timeout";
    case kExpertMode:
      return "expert mode disabled";
    case kNotReady:
      return "device not ready";
    case kInUse:
      return "device already in use";
    default:
      return "error";
  }
}

FAKE_EXPORT const char* dhdErrorGetLastStr() {
  return dhdErrorGetStr(newest_error());
}

FAKE_EXPORT void dhdGetSDKVersion(int* major, int* minor, int* release, int* revision) {
  *major = 3, *minor = 17, *release = 5, *revision = 1;
}

FAKE_EXPORT int dhdGetDeviceCount() {
  return static_cast<int>(listed().size());
}

FAKE_EXPORT int dhdOpenID(char index) {
  return open_index(index);
}

FAKE_EXPORT int dhdClose(char id) {
  return close_device(id, "dhdClose");
}

FAKE_EXPORT int dhdGetSystemType(char id) {
  const Device* d = device_of(id, "dhdGetSystemType");
  return d != nullptr ? d->model.type : -1;
}

FAKE_EXPORT const char* dhdGetSystemName(char id) {
  const Device* d = device_of(id, "dhdGetSystemName");
  return d != nullptr ? d->model.name : nullptr;
}

FAKE_EXPORT int dhdGetSerialNumber(unsigned short* serial, char id) {
  const Device* d = device_of(id, "dhdGetSerialNumber");
  if (d == nullptr) return -1;
  if (serial == nullptr) return failed(kNull);
  if (!d->model.has_serial) return failed(kNotAvailable);
  *serial = the_bench().serial(id);
  return 0;
}

FAKE_EXPORT int dhdGetStatus(int* status, char id) {
  Device* d = device_of(id, "dhdGetStatus");
  if (d == nullptr) return -1;
  look(*d);
  if (const int error = d->port->sense().error; error != 0) return failed(error);
  ++d->state.status_asked;
  d->state.was_reported_lost = !d->state.is_home;
  std::fill_n(status, 17, 0);
  status[0] = status[1] = status[2] = 1;  // power, connected, started
  status[3] = d->state.mode == State::Mode::kReset;
  status[4] = d->state.mode == State::Mode::kIdle;
  status[5] = d->state.mode == State::Mode::kForce;
  status[6] = d->state.mode == State::Mode::kBrake;
  status[10] = d->state.gravity;
  status[11] = 1;
  status[14] = d->state.mode == State::Mode::kForce ? 0 : d->state.cause;
  return 0;
}

FAKE_EXPORT int dhdEnableExpertMode() {
  change_expert_mode(1);
  return 0;
}

FAKE_EXPORT int dhdDisableExpertMode() {
  change_expert_mode(-1);
  return 0;
}

FAKE_EXPORT int dhdEnableForce(unsigned char on, char id) {
  Device* d = device_of(id, "dhdEnableForce");
  if (d == nullptr) return -1;
  if (on == 0) {
    switch_off(*d, 4);
    return 0;
  }
  if (d->state.mode == State::Mode::kReset) return failed(kNotReady);
  if (d->state.person_has_forces) {
    break_rule(*d, "forces that a person had switched off were switched on");
  }
  if (d->model.has_watchdog && (d->state.watchdog == 0 || d->state.watchdog > 248)) {
    break_rule(*d, "forces without a watchdog of at most 31 ms");
  }
  d->state.mode = State::Mode::kForce;
  d->state.cause = 0;
  d->fed_ns = d->port->now_ns();
  ++d->state.enables;
  d->port->push(d->asked);  // the newest command
  return 0;
}

FAKE_EXPORT int dhdStop(char id) {
  Device* d = device_of(id, "dhdStop");
  if (d == nullptr) return -1;
  d->port->release();
  switch_off(*d, 4);
  const int error = d->port->sense().error;
  return error == 0 ? 0 : failed(error);
}

FAKE_EXPORT int dhdSetBrakes(int on, char id) {
  Device* d = device_of(id, "dhdSetBrakes");
  if (d == nullptr) return -1;
  switch_off(*d, 4);
  if (on == 0 && d->state.mode == State::Mode::kBrake) d->state.mode = State::Mode::kIdle;
  return 0;
}

FAKE_EXPORT int dhdGetPosition(double* x, double* y, double* z, char id) {
  Device* d = device_of(id, "dhdGetPosition");
  if (d == nullptr) return -1;
  const int answer = ask(*d);
  if (answer < 0) return answer;
  *x = d->said.position_m[0], *y = d->said.position_m[1], *z = d->said.position_m[2];
  return answer;
}

FAKE_EXPORT unsigned dhdGetButtonMask(char id) {
  const Device* d = device_of(id, "dhdGetButtonMask");
  return d != nullptr ? d->said.buttons : 0;
}

FAKE_EXPORT int dhdGetButton(int index, char id) {
  const Device* d = device_of(id, "dhdGetButton");
  if (d == nullptr) return -1;
  if (index < 0 || index >= 32) return failed(kInvalidIndex);
  return static_cast<int>((d->said.buttons >> index) & 1U);
}

FAKE_EXPORT int dhdSetForce(double x, double y, double z, char id) {
  Device* d = device_of(id, "dhdSetForce");
  return d != nullptr ? command(*d, {x, y, z}) : -1;
}

FAKE_EXPORT int dhdSetForceAndGripperForce(double x, double y, double z, double gripper, char id) {
  Device* d = device_of(id, "dhdSetForceAndGripperForce");
  if (d == nullptr) return -1;
  d->state.gripper_n = gripper;
  return command(*d, {x, y, z});
}

FAKE_EXPORT int dhdSetForceAndTorqueAndGripperForce(double x, double y, double z, double tx,
                                                    double ty, double tz, double gripper, char id) {
  Device* d = device_of(id, "dhdSetForceAndTorqueAndGripperForce");
  if (d == nullptr) return -1;
  d->state.gripper_n = gripper;
  d->state.torque_nm = {tx, ty, tz};
  return command(*d, {x, y, z});
}

FAKE_EXPORT int dhdSetGravityCompensation(int on, char id) {
  Device* d = device_of(id, "dhdSetGravityCompensation");
  if (d == nullptr) return -1;
  d->state.gravity = on != 0;
  return 0;
}

FAKE_EXPORT int dhdSetEffectorMass(double kg, char id) {
  Device* d = device_of(id, "dhdSetEffectorMass");
  if (d == nullptr) return -1;
  d->state.effector_kg = kg;
  return 0;
}

FAKE_EXPORT int dhdSetWatchdog(unsigned char units, char id) {
  Device* d = device_of(id, "dhdSetWatchdog");
  if (d == nullptr || needs_expert_mode(*d, "dhdSetWatchdog")) return -1;
  if (!d->model.has_watchdog) return failed(kNotAvailable);
  d->state.watchdog = units;
  return 0;
}

FAKE_EXPORT int dhdGetWatchdog(unsigned char* units, char id) {
  const Device* d = device_of(id, "dhdGetWatchdog");
  if (d == nullptr) return -1;
  if (!d->model.has_watchdog) return failed(kNotAvailable);
  *units = d->state.watchdog;
  return 0;
}

FAKE_EXPORT int dhdSetVelocityThreshold(unsigned, char id) {
  Device* d = device_of(id, "dhdSetVelocityThreshold");
  if (d == nullptr) return -1;
  break_rule(*d, "the factory's velocity threshold was changed");
  return 0;
}

FAKE_EXPORT int dhdSetTimeGuard(int, char id) {
  Device* d = device_of(id, "dhdSetTimeGuard");
  if (d == nullptr) return -1;
  break_rule(*d, "the time guard was changed");
  return 0;
}

FAKE_EXPORT double dhdGetComFreq(char id) {
  return device_of(id, "dhdGetComFreq") != nullptr ? 3.9 : -1.0;  // kHz
}

FAKE_EXPORT int dhdReset(char id) {
  Device* d = device_of(id, "dhdReset");
  if (d == nullptr) return -1;
  d->port->release();
  d->state.is_home = false;
  d->state.mode = State::Mode::kReset;
  return 0;
}

// The user holds it in its rest pose as soon as the arm is at rest there: within 5 mm of the point
// that is farthest from the user.
FAKE_EXPORT int dhdWaitForReset(int, char id) {
  Device* d = device_of(id, "dhdWaitForReset");
  if (d == nullptr) return -1;
  if (d->port->sense().position_m[0] > -0.05) return failed(kTimeout);
  d->state.is_home = true;
  d->model.is_home = true;
  d->state.mode = State::Mode::kBrake;
  return 0;
}

#ifndef FAKE_WITHOUT_DRD
FAKE_EXPORT int drdOpenID(char index) {
  return open_index(index);
}

FAKE_EXPORT int drdClose(char id) {
  return close_device(id, "drdClose");
}

FAKE_EXPORT bool drdIsSupported(char id) {
  const Device* d = device_of(id, "drdIsSupported");
  return d != nullptr && d->model.drd_knows_it;
}

FAKE_EXPORT bool drdIsInitialized(char id) {
  const Device* d = device_of(id, "drdIsInitialized");
  return d != nullptr && d->state.is_home;
}

FAKE_EXPORT int drdAutoInit(char id) {
  Device* d = device_of(id, "drdAutoInit");
  if (d == nullptr) return -1;
  if (!d->model.drd_knows_it) return failed(kNotAvailable);
  ++d->state.auto_inits;
  d->state.is_regulated = true;
  if (d->port->sense().error != 0) return failed(d->port->sense().error);
  d->state.is_home = true;
  d->model.is_home = true;
  d->state.mode = State::Mode::kForce;
  return 0;
}

FAKE_EXPORT int drdStop(bool force_on, char id) {
  Device* d = device_of(id, "drdStop");
  if (d == nullptr) return -1;
  d->state.is_regulated = false;
  d->fed_ns = d->port->now_ns();
  if (d->state.mode == State::Mode::kReset) return 0;
  if (!force_on) switch_off(*d, 4);
  return 0;
}
#endif
