#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "tests/devices/drivers/driver_bench.h"

namespace felt {

/// What goes wrong (docs/design/devices.md#faults), beside the device itself.
enum class Happening : std::uint8_t {
  kDeviceFault,  ///< one of injected_faults()
  kStall,        ///< no tick for 3..500 ms
  kDoubleTicks,  ///< the same time twice
  kMissedTicks,  ///< a burst of late and missing ones
  kClockStep,    ///< the clock is set, an hour on or back
  kSuspend,      ///< the machine sleeps for ten minutes, the device is gone for a while after that
  kEditSilent,   ///< the edit side hangs: no heartbeat, no new force, nobody takes the samples
  kUndo,         ///< the gesture in work is taken back
  kOtherTool,    ///< another tool is chosen meanwhile
  kMaterial,     ///< the sheet becomes another one under the pen
  kBadForce,     ///< a force model asks for 10^9 N, to and fro, or for what is no number
  kLetGo,        ///< nobody holds the stylus any more
  kOtherModel,   ///< unplugged, and another model plugged in
  kCount
};

/// What the pen does then.
enum class PenState : std::uint8_t {
  kFree,      ///< in the air, forces engaged
  kEngaging,  ///< presses while forces still grow
  kContact,   ///< rests on the sheet
  kDragging,  ///< in the middle of a gesture
  kSnapped,   ///< near its end, where lines attract and tools pull
  kCount
};

/// One fault, chosen by a seed: neighbouring seeds go through the faults that the bench shows, then
/// the tools, then the states of the pen; moments and amounts are random.
struct FaultCase {
  std::uint64_t seed = 0;
  Happening happening = Happening::kDeviceFault;
  InjectedFault fault = InjectedFault::kUnplugged;  ///< of kDeviceFault
  std::string tool;
  PenState state = PenState::kFree;
  std::int64_t at_ns = 0;
  std::int64_t lasts_ns = 0;
  double amount = 0.0;
};
FaultCase make_fault_case(const DriverBench& bench, std::uint64_t seed);

/// "unplugged for 43 ms at 912 ms, pencil, dragging".
std::string text_of(const FaultCase& fault);
/// "unplugged", "stall".
std::string_view kind_of(const FaultCase& fault) noexcept;

/// When the pen comes down, for the first time, in a case with this state.
std::int64_t landing_ns(PenState state) noexcept;

}  // namespace felt
