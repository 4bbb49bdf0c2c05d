#pragma once

#include <memory>

#include "felt/validate/test_subject.h"

namespace felt {

/// A driver's device under test, seen in the frame of the page.
class DriverSubject final : public TestSubject {
 public:
  /// `driver` must outlive this. Uses the profile's plane if it was set with this very unit, the
  /// driver's default plane otherwise; not the user's limits.
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
  bool was_seen_;  // find() can tell whether it is connected
  DeviceSetup setup_;
  std::unique_ptr<OpenDevice> device_;
};

}  // namespace felt
