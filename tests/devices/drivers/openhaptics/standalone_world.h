#pragma once

#include <memory>

#include "tests/devices/drivers/openhaptics/fake_libhd.h"

namespace felt {

/// The device that the fake library plugs in if no test does: a simulated Touch, so that users
/// without hardware can try the driver (FELT_OPENHAPTICS_LIBRARY=.../fake_libhd.so feltline
/// devices). Its hand holds it still in the air, or draws circles (FAKE_LIBHD_HAND=circles).
class StandaloneWorld {
 public:
  virtual ~StandaloneWorld() = default;
  [[nodiscard]] virtual FakeHdModel model() const = 0;
  [[nodiscard]] virtual FakeHdWorld world() = 0;
};

std::unique_ptr<StandaloneWorld> make_standalone_world();

}  // namespace felt
