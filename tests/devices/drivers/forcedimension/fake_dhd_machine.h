#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tests/devices/drivers/forcedimension/fake_libdrd.h"

/// What stands behind the fake's functions: the devices that are plugged in, their modes, guards
/// and rules. Functions of one device neither allocate nor lock.
namespace felt::fake_dhd {

inline constexpr int kComError = 2, kNoDevice = 5, kNotAvailable = 6, kTimeout = 7, kExpertMode = 9,
                     kNotReady = 12, kInvalidIndex = 15, kNull = 17, kInUse = 20, kInvalid = 21;

struct Device {
  Model model;
  Port* port = nullptr;  // null: not plugged in
  State state;
  unsigned short serial = 0;
  std::int64_t fed_ns = 0;  // last force command
  std::array<double, 3> asked{};
  Port::Sense said;  // what was read last
  bool has_said = false;
  std::int64_t said_ns = 0;
};

/// Remembers an error for this thread, as the vendor does, and returns -1.
int failed(int error) noexcept;
/// The newest of this thread.
int newest_error() noexcept;
/// The first rule that was broken is remembered.
void break_rule(Device& d, const char* rule, const char* function = "");
/// The device of a number that a function was given; null, and the vendor's error, where there is
/// none.
Device* device_of(char id, const char* function);
/// Forces off, and the brakes on, with the vendor's cause.
void switch_off(Device& d, int cause) noexcept;
/// What the device's own firmware notices: a watchdog, a speed, a cable.
void look(Device& d) noexcept;
/// A transfer from the device: a new sense, or (1) too soon for one.
int ask(Device& d) noexcept;
/// A force for the motors, as the vendor's functions answer it.
int command(Device& d, const std::array<double, 3>& f) noexcept;
/// True, and a broken rule, outside of the expert mode.
bool needs_expert_mode(Device& d, const char* function);
void change_expert_mode(int by) noexcept;
/// The numbers of what answers, in the order in which it was plugged in.
std::vector<int> listed();
int open_index(char index);
int close_device(char id, const char* function);
Bench& the_bench() noexcept;

}  // namespace felt::fake_dhd
