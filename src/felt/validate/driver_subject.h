#pragma once

#include <memory>

#include "felt/validate/test_subject.h"

namespace felt {

/// A driver's device under test, in the frame of the surface.
class DriverSubject final : public TestSubject {
 public:
  /// `driver` must outlive this object. Uses the profile's plane if it was set with the same unit,
  /// otherwise the driver's default plane. Does not use the user's limits.
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
  bool was_seen_;  // so find() can report whether it is connected
  DeviceSetup setup_;
  std::unique_ptr<OpenDevice> device_;
};

}  // namespace felt
