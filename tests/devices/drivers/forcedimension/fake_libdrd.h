#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <string>

namespace felt::fake_dhd {

/// The user and the arm behind a faked device; the test that plugs it in implements this. In
/// metres, m/s and newtons, in the device's own axes (x towards the user, y right, z up).
class Port {
 public:
  struct Sense {
    std::array<double, 3> position_m{};
    unsigned buttons = 0;
    double speed_m_per_s = 0.0;  ///< real speed of the arm, for the guard of the controller
    int error = 0;               ///< the vendor's error number of the transfer, or 0
    bool is_home = true;
  };
  /// result of push(): the user switched the forces off with the button
  static constexpr int kTaken = 1000;

  virtual ~Port() = default;
  /// Returns the time of the virtual clock.
  [[nodiscard]] virtual std::int64_t now_ns() const noexcept = 0;
  /// Returns the sample of the last tick. Must not move anything.
  [[nodiscard]] virtual const Sense& sense() const noexcept = 0;
  /// Sets the force of the motors. Returns 0, the vendor's error number, or kTaken.
  virtual int push(const std::array<double, 3>& force_n) noexcept = 0;
  /// Sets the force of the motors to zero.
  virtual void release() noexcept = 0;
};

/// A device that can be plugged in.
struct Model {
  int type = 33;
  const char* name = "omega.3";
  bool has_serial = true;
  bool is_home = true;       ///< if false, it must find home, as after power on
  bool has_watchdog = true;  ///< firmware 3.0 and later
  bool drd_knows_it = true;  ///< drdIsSupported
  double saturates_above_n = 1e9;
  double guard_m_per_s = 3.0;  ///< the factory's velocity threshold
};

/// The requests to a faked device and its state; only visible to tests.
struct State {
  enum class Mode : std::uint8_t { kReset, kIdle, kForce, kBrake };

  Mode mode = Mode::kBrake;
  int cause = 0;  ///< why forces are off
  bool is_open = false;
  bool is_open_elsewhere = false;  ///< another program uses it; set by tests
  bool is_home = true;
  bool was_reported_lost = false;  ///< the last status that was requested reported this
  bool is_regulated = false;       ///< DRD's own thread holds the arm
  bool person_has_forces = false;  ///< switched off with the force button
  bool taken_by_world = false;     ///< the fault of a FakeWorld pressed the force button
  unsigned char watchdog = 0;
  bool gravity = true;
  double effector_kg = 0.2;
  int auto_inits = 0;  ///< how often the arm moved by itself
  int opens = 0;
  int enables = 0;  ///< how often forces were switched on
  int status_asked = 0;
  double gripper_n = 0.0;  ///< the last request, or NaN if never requested
  std::array<double, 3> torque_nm{};
  double largest_asked_n = 0.0;  ///< infinite if a request was ever not a number
  std::string broken_rule;       ///< the first broken rule
};

/// The control of the fake library: the devices that are plugged in. The library exports
/// `felt_fake_dhd`, which returns this, beside the vendor's functions.
class Bench {
 public:
  virtual ~Bench() = default;
  /// Adds a device to the list and returns its number. `port` must outlive unplug().
  virtual int plug(const Model& model, Port& port) = 0;
  /// Removes a device permanently. A program that has it open gets an error.
  virtual void unplug(int number) noexcept = 0;
  /// Lets watchdog and guard check the new time.
  virtual void tick(int number) noexcept = 0;
  /// Presses the force button, which switches forces off, or on again.
  virtual void press_force_button(int number) noexcept = 0;
  [[nodiscard]] virtual State& state(int number) noexcept = 0;
  /// Returns the serial number that the device reports.
  [[nodiscard]] virtual unsigned short serial(int number) const noexcept = 0;
};

using GetBench = Bench*();

}  // namespace felt::fake_dhd
