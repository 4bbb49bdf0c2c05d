#pragma once

#include <cstdint>

/// The control of the fake libHD by tests, beside the vendor's 36 functions: the library exports
/// one additional symbol, `fake_hd_control`. It uses plain C types only, because the fake is a
/// separate library that the driver loads with dlopen like the real one.
extern "C" {

/// The state of the pen, in the device's axes (mm, mm/s).
struct FakeHdPen {
  double position[3];
  double velocity[3];
  unsigned buttons;
  double axis[3];  ///< along the stylus, of any length; if all are 0, it stands upright, along y
};

/// The world behind the device. Functions return 0, or 1 + the number of a DeviceFault.
struct FakeHdWorld {
  void* context;
  int (*read)(void* context, std::int64_t now_ns, FakeHdPen* pen);
  int (*write)(void* context, const double* force_n);
  void (*stop)(void* context);
};

/// The model that is plugged in.
struct FakeHdModel {
  const char* name;         ///< name for hdInitDevice(); if null, only the null name opens it
  const char* second_name;  ///< a second name; may be null
  int opens_without_name;   ///< hdInitDevice(NULL) works
  const char* type;         ///< "Touch"
  const char* serial;
  double max_force_n, continuous_force_n, stiffness_n_per_mm, damping_n_s_per_mm;
  double usable_mm[6];
  int calibration_style;  ///< bits
  int rate_hz;
  int has_thermometers;  ///< and a measured rate; older libraries do not have these
};

struct FakeHdControl {
  // The machine.
  void (*reset)();  ///< resets to the state after loading: nothing plugged in, virtual clock
  void (*plug_in)(const FakeHdModel* model, const FakeHdWorld* world);
  void (*occupy)(int on);  ///< another program uses the device
  /// Selects whether the scheduler is a separate thread at the rate of the model. Otherwise the
  /// caller of step() is the scheduler.
  void (*use_thread)(int on);

  // The scheduler on a virtual clock.
  void (*step)(std::int64_t now_ns);       ///< a whole tick: all callbacks
  void (*open_tick)(std::int64_t now_ns);  ///< a tick in which the caller is the callback
  void (*close_tick)();

  // Events of the device.
  void (*push_error)(unsigned code, int internal_code);
  void (*set_safety_switch)(int closed);
  void (*set_inkwell)(int inside);
  void (*set_at_rest)(int at_rest);  ///< in the pose that encoder reset requires
  void (*set_home)(int is_home);     ///< it has found its home position
  void (*set_temperature)(double warmest);
  /// hdStartScheduler() fails with this code; 0 ends this
  void (*refuse_scheduler)(unsigned code);
  /// Makes the scheduler's thread begin one more call while the scheduler is being stopped.
  void (*call_while_stopping)();

  // Records of the fake.
  double (*largest_asked_n)();
  const char* (*broken_rule)();  ///< the first broken rule; "" if none was broken
  int (*is_enabled)(unsigned capability);
  int (*is_running)();
  int (*callbacks)();  ///< number of scheduled callbacks
  int (*open_devices)();
  std::uint64_t (*frames)();  ///< number of ended frames
  double (*temperature)();
};

const FakeHdControl* fake_hd_control();
}
