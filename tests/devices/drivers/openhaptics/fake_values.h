#pragma once

#include <array>
#include <cstddef>

#include "felt/devices/openhaptics/hd_abi.h"

/// The values that hdGet...v() of the fake can return, with their types.
namespace felt::fake_libhd {

enum class Kind { kBoolean, kInteger, kReal, kText, kLong };

struct Value {
  hd::Enum what;
  Kind kind;
  std::size_t count;
};

/// Returns the value with this name if a device is open and has it with this type. Otherwise sets
/// the vendor's error and returns null.
const Value* find_value(hd::Enum what, Kind kind);
/// Returns the values of the last frame, or of the current frame if one is open.
std::array<double, 16> reals(hd::Enum what);
int integer(hd::Enum what);

}  // namespace felt::fake_libhd
