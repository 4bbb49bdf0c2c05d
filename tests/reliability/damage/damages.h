#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace felt::damage {

/// One damage of a file. The bytes before `first` are unchanged. The bytes from `last` on are
/// unchanged too if the file kept its length.
struct Damage {
  std::string name;  ///< description that identifies the damage, like "flip 7 of byte 1024"
  std::size_t first = 0, last = 0;
  bool keeps_places = true;  ///< the bytes after the damage keep their positions
  std::string bytes;
};

/// Calls `use` for damages of each kind, spread evenly over the file: truncated, one bit flipped, a
/// sector of zeros, a sector of 0xff, a sector repeated, a sector missing, two sectors exchanged.
/// The environment variable FELT_DAMAGES sets the approximate number of each kind (default: 400).
void for_each_damage(std::string_view whole, const std::function<void(const Damage&)>& use);

/// Return the CPU time of this process in s and its peak memory in bytes.
double cpu_seconds();
std::size_t peak_bytes();

}  // namespace felt::damage
