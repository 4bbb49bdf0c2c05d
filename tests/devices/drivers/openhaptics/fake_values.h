#pragma once

#include <array>
#include <cstddef>

#include "felt/devices/openhaptics/hd_abi.h"

/// What the fake can be asked for by hdGet...v(), and of which type each of it is.
namespace felt::fake_libhd {

enum class Kind { kBoolean, kInteger, kReal, kText, kLong };

struct Value {
  hd::Enum what;
  Kind kind;
  std::size_t count;
};

/// The value of this name if a device is open, has it, and it is asked for by its type; null, and
/// the vendor's error, otherwise.
const Value* find_value(hd::Enum what, Kind kind);
/// As of the last frame; inside of one that is this one.
std::array<double, 16> reals(hd::Enum what);
int integer(hd::Enum what);

}  // namespace felt::fake_libhd
