#pragma once

#include <span>
#include <string_view>

namespace felt::rt_test {

/// A forbidden action that a test plants in a tick to check that it is detected.
struct Plant {
  std::string_view name;
  void (*prepare)();          ///< runs before the first tick; may be null
  void (*commit)() noexcept;  ///< runs in the tick and does the forbidden action
};

/// Returns all plants.
std::span<const Plant> plants() noexcept;

}  // namespace felt::rt_test
