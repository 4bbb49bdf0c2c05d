#pragma once

#include <span>
#include <string_view>

namespace felt::rt_test {

/// A forbidden action that is planted in a tick, to test that it is caught.
struct Plant {
  std::string_view name;
  void (*prepare)();  ///< before any tick, or null
  void (*commit)() noexcept;
};

std::span<const Plant> plants() noexcept;

}  // namespace felt::rt_test
