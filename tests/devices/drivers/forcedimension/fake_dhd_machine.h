#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tests/devices/drivers/forcedimension/fake_libdrd.h"

/// The state behind the fake's functions: the devices that are plugged in, with their modes, guards
/// and rules. Functions for a single device neither allocate nor lock.
namespace felt::fake_dhd {

inline constexpr int kComError = 2, kNoDevice = 5, kNotAvailable = 6, kTimeout = 7, kExpertMode = 9,
                     kNotReady = 12, kInvalidIndex = 15, kNull = 17, kInUse = 20, kInvalid = 21;

struct Device {
  Model model;
  Port* port = nullptr;  // null if not plugged in
  State state;
  unsigned short serial = 0;
  std::int64_t fed_ns = 0;  // time of the last force command
  std::array<double, 3> asked{};
  Port::Sense said;  // the last sample that was read
  bool has_said = false;
  std::int64_t said_ns = 0;
};

/// Stores an error for this thread, as the vendor does, and returns -1.
int failed(int error) noexcept;
/// Returns the newest error of this thread.
int newest_error() noexcept;
/// Stores the first broken rule.
void break_rule(Device& d, const char* rule, const char* function = "");
/// Returns the device with the number that a function received. If no device has it, sets the
/// vendor's error and returns null.
Device* device_of(char id, const char* function);
/// Switches forces off and the brakes on, and stores the vendor's cause.
void switch_off(Device& d, int cause) noexcept;
/// Runs the checks of the device's own firmware: watchdog, speed, cable.
void look(Device& d) noexcept;
/// Reads a new sample from the device. Returns 1 if it is too soon for one.
int ask(Device& d) noexcept;
/// Sends a force to the motors and returns the result of the vendor's functions.
int command(Device& d, const std::array<double, 3>& f) noexcept;
/// Returns true and records a broken rule if the expert mode is off.
bool needs_expert_mode(Device& d, const char* function);
void change_expert_mode(int by) noexcept;
/// Returns the numbers of the devices that answer, in the order in which they were plugged in.
std::vector<int> listed();
int open_index(char index);
int close_device(char id, const char* function);
Bench& the_bench() noexcept;

}  // namespace felt::fake_dhd
