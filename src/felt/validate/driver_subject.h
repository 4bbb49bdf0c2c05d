#pragma once

#include <memory>

#include "felt/validate/test_subject.h"

namespace felt {

/// A device under test that a driver opens, with positions in the frame of the surface.
class DriverSubject final : public TestSubject {
 public:
  /// `driver` must outlive this object. Uses the plane of the profile. If the profile has no plane,
  /// or was made with another unit of the same model (is_of()), uses the driver's default plane.
  /// Ignores the user's limits.
  DriverSubject(Driver& driver, DeviceDescriptor found, const OpenOptions& options,
                DeviceProfile profile = {});

  [[nodiscard]] const DeviceDescriptor& descriptor() const noexcept override;
  Result<void> open() override;
  void close() noexcept override { device_.reset(); }
  [[nodiscard]] OpenDevice* device() noexcept override { return device_.get(); }
  bool is_connected() override;

 private:
  Driver& driver_;
  DeviceDescriptor found_;
  bool was_seen_;  // find() reported it as connected, so such reports can be trusted
  DeviceSetup setup_;
  std::unique_ptr<OpenDevice> device_;
};

}  // namespace felt
