#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <string>

namespace felt::fake_dhd {

/// What the person and the arm behind a faked device are: the one who plugs it in answers. Metres,
/// m/s, newtons, in the device's own axes (x towards the person, y right, z up).
class Port {
 public:
  struct Sense {
    std::array<double, 3> position_m{};
    unsigned buttons = 0;
    double speed_m_per_s = 0.0;  ///< what the arm really does, for the guard of the controller
    int error = 0;               ///< of the transfer: the vendor's number, or 0
    bool is_home = true;
  };
  static constexpr int kTaken = 1000;  ///< of push(): the person took the forces with the button

  virtual ~Port() = default;
  /// The virtual clock.
  [[nodiscard]] virtual std::int64_t now_ns() const noexcept = 0;
  /// As it was at the last tick. Must not move anything.
  [[nodiscard]] virtual const Sense& sense() const noexcept = 0;
  /// The motors hold this now. 0, the vendor's error number, or kTaken.
  virtual int push(const std::array<double, 3>& force_n) noexcept = 0;
  /// The motors hold nothing any more.
  virtual void let_go() noexcept = 0;
};

/// A device that can be plugged in.
struct Model {
  int type = 33;
  const char* name = "omega.3";
  bool has_serial = true;
  bool is_home = true;       ///< false: as after power on, it must find home
  bool has_watchdog = true;  ///< firmware 3.0 and later
  bool drd_knows_it = true;  ///< drdIsSupported
  double saturates_above_n = 1e9;
  double guard_m_per_s = 3.0;  ///< the factory's velocity threshold
};

/// What a faked device is asked and does, as nobody but a test may see it.
struct State {
  enum class Mode : std::uint8_t { kReset, kIdle, kForce, kBrake };

  Mode mode = Mode::kBrake;
  int cause = 0;  ///< why forces are off
  bool is_open = false;
  bool is_open_elsewhere = false;  ///< another program has it: set by tests
  bool is_home = true;
  bool was_told_lost = false;      ///< the status that was asked for last said so
  bool is_regulated = false;       ///< DRD's own thread holds the arm
  bool person_has_forces = false;  ///< taken by the force button
  bool taken_by_world = false;     ///< that person is the fault of a FakeWorld
  unsigned char watchdog = 0;
  bool gravity = true;
  double effector_kg = 0.2;
  int auto_inits = 0;  ///< how often the arm moved by itself
  int opens = 0;
  int enables = 0;  ///< how often forces were switched on
  int status_asked = 0;
  double gripper_n = 0.0;  ///< as asked last, or NaN: never
  std::array<double, 3> torque_nm{};
  double largest_asked_n = 0.0;  ///< infinite: once it was no number
  std::string broken_rule;       ///< the first one
};

/// The other side of the fake library: what is plugged in. Where the vendor's functions stand, so
/// stands `felt_fake_dhd`, which gives this.
class Bench {
 public:
  virtual ~Bench() = default;
  /// From now on it is in the list. Returns its number. `port` must outlive unplug().
  virtual int plug(const Model& model, Port& port) = 0;
  /// Gone, for ever; a program that has it open hears of it.
  virtual void unplug(int number) noexcept = 0;
  /// Time has passed: watchdog and guard look.
  virtual void tick(int number) noexcept = 0;
  /// The force button, pressed: off, or on again.
  virtual void press_force_button(int number) noexcept = 0;
  [[nodiscard]] virtual State& state(int number) noexcept = 0;
  /// Serial number that it will say.
  [[nodiscard]] virtual unsigned short serial(int number) const noexcept = 0;
};

using GetBench = Bench*();

}  // namespace felt::fake_dhd
