#pragma once

#include <cstdint>

/// How tests hold the fake of libHD, beside the vendor's 36 functions: one symbol of its own,
/// `fake_hd_control`. Plain C types only: the fake is a library of its own, loaded by the driver
/// with dlopen like the real one.
extern "C" {

/// What the pen is, in the device's axes (mm, mm/s).
struct FakeHdPen {
  double position[3];
  double velocity[3];
  unsigned buttons;
  double axis[3];  ///< along the stylus, of any length; all 0: it stands upright, along y
};

/// What stands behind the device. Results: 0, or 1 + the number of a DeviceFault.
struct FakeHdWorld {
  void* context;
  int (*read)(void* context, std::int64_t now_ns, FakeHdPen* pen);
  int (*write)(void* context, const double* force_n);
  void (*stop)(void* context);
};

/// What is plugged in.
struct FakeHdModel {
  const char* name;  ///< that hdInitDevice() opens it by; null: opened by no name (null) only
  const char* second_name;  ///< likewise; may be null
  int opens_without_name;   ///< hdInitDevice(NULL) works
  const char* type;         ///< "Touch"
  const char* serial;
  double max_force_n, continuous_force_n, stiffness_n_per_mm, damping_n_s_per_mm;
  double usable_mm[6];
  int calibration_style;  ///< bits
  int rate_hz;
  int has_thermometers;  ///< and a measured rate; older libraries do not know these
};

struct FakeHdControl {
  // The machine.
  void (*reset)();  ///< as just loaded, nothing plugged in, virtual clock
  void (*plug_in)(const FakeHdModel* model, const FakeHdWorld* world);
  void (*occupy)(int on);  ///< another program has the device
  /// The scheduler is a thread of its own, at the rate of the model; else whoever calls step().
  void (*use_thread)(int on);

  // The scheduler on a virtual clock.
  void (*step)(std::int64_t now_ns);       ///< a whole tick: all callbacks
  void (*open_tick)(std::int64_t now_ns);  ///< a tick in which the caller is the callback
  void (*close_tick)();

  // What happens to the device.
  void (*push_error)(unsigned code, int internal_code);
  void (*set_safety_switch)(int closed);
  void (*set_inkwell)(int inside);
  void (*set_at_rest)(int at_rest);  ///< in the pose that encoder reset wants
  void (*set_home)(int is_home);     ///< it knows where it is
  void (*set_temperature)(double warmest);
  void (*refuse_scheduler)(unsigned code);  ///< hdStartScheduler() pushes this; 0: no more
  /// Once, while the scheduler is being stopped, its thread begins another call.
  void (*call_while_stopping)();

  // What the fake saw.
  double (*largest_asked_n)();
  const char* (*broken_rule)();  ///< the first; "" if none
  int (*is_enabled)(unsigned capability);
  int (*is_running)();
  int (*callbacks)();  ///< that are scheduled
  int (*open_devices)();
  std::uint64_t (*frames)();  ///< that were ended
  double (*temperature)();
};

const FakeHdControl* fake_hd_control();
}
