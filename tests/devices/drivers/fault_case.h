#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "tests/devices/drivers/driver_bench.h"

namespace felt {

/// The fault that is injected (docs/design/devices.md#faults), besides those of the device itself.
enum class Happening : std::uint8_t {
  kDeviceFault,  ///< one of injected_faults()
  kStall,        ///< no tick for 3..500 ms
  kDoubleTicks,  ///< the same time twice
  kMissedTicks,  ///< a burst of late and missing ticks
  kClockStep,    ///< the clock is set an hour forwards or back
  /// the machine sleeps for ten minutes, and the device is missing for a while after that
  kSuspend,
  kEditSilent,  ///< the edit side hangs: no heartbeat, no new force, the samples are not read
  kUndo,        ///< the gesture in progress is undone
  kOtherTool,   ///< the user chooses another tool during the fault
  kMaterial,    ///< the surface changes under the pen
  kBadForce,    ///< a force model requests 10^9 N in alternating directions, or NaN
  kLetGo,       ///< the user releases the stylus
  kOtherModel,  ///< unplugged, and another model plugged in
  kCount
};

/// State of the pen when the fault happens.
enum class PenState : std::uint8_t {
  kFree,      ///< above the surface, forces engaged
  kEngaging,  ///< presses while forces still grow
  kContact,   ///< rests on the surface
  kDragging,  ///< in the middle of a gesture
  kSnapped,   ///< near the end of a line, where lines attract and tools pull
  kCount
};

/// One fault, chosen by a seed. Successive seeds go through the faults that the bench simulates,
/// then the tools, then the states of the pen; times and amounts are random.
struct FaultCase {
  std::uint64_t seed = 0;
  Happening happening = Happening::kDeviceFault;
  InjectedFault fault = InjectedFault::kUnplugged;  ///< if the happening is kDeviceFault
  std::string tool;
  PenState state = PenState::kFree;
  std::int64_t at_ns = 0;
  std::int64_t lasts_ns = 0;
  double amount = 0.0;
};
FaultCase make_fault_case(DriverBench& bench, std::uint64_t seed);

/// Describes a fault, for example "unplugged for 43 ms at 912 ms, pencil, dragging".
std::string text_of(const FaultCase& fault);
/// Returns the kind of a fault, for example "unplugged" or "stall".
std::string_view kind_of(const FaultCase& fault) noexcept;

/// Returns the time of the first pen contact in a case with this state.
std::int64_t landing_ns(PenState state) noexcept;

}  // namespace felt
