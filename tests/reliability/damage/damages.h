#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace felt::damage {

/// What befell a file. Bytes before `first` are as they were, and those from `last` on where the
/// file did not change its length.
struct Damage {
  std::string name;  ///< "flip 7 of byte 1024": repeats it
  std::size_t first = 0, last = 0;
  bool keeps_places = true;  ///< what lies behind the damage is where it was
  std::string bytes;
};

/// All kinds, evenly over the file: cut off, one bit flipped, a sector of zeros, a sector of 0xff,
/// a sector that is there twice, a sector missing, two sectors exchanged. FELT_DAMAGES says how
/// many of each kind at most (400 without it).
void for_each_damage(std::string_view whole, const std::function<void(const Damage&)>& use);

/// CPU time of this process, and the most memory it had.
double cpu_seconds();
std::size_t peak_bytes();

}  // namespace felt::damage
