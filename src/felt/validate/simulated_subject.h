#pragma once

#include <cstdint>
#include <optional>

#include "felt/validate/test_subject.h"

namespace felt {

struct SimulatedSubjectOptions {
  /// Timeout of the simulated watchdog. Most devices have a watchdog in their firmware: after this
  /// time without communication, the force becomes zero. 0 = no watchdog.
  std::int64_t watchdog_ns = 32'000'000;
};

/// A simulated device under test and the simulated person who holds it. The person agrees to
/// everything and immediately does what the test asks. Requires a VirtualTestLoop that calls
/// before_tick() of this object.
class SimulatedSubject final : public TestSubject, public TestPerson {
 public:
  /// `device` and `hand` (usually the same object) must outlive this object.
  SimulatedSubject(Device& device, HandInput& hand, DeviceDescriptor descriptor,
                   const SimulatedSubjectOptions& options = {});

  void before_tick(std::int64_t now_ns);

  // TestSubject
  [[nodiscard]] const DeviceDescriptor& descriptor() const noexcept override { return descriptor_; }
  Result<void> open() override;
  void close() noexcept override;
  [[nodiscard]] OpenDevice* device() noexcept override { return is_open_ ? &device_ : nullptr; }
  bool is_connected() override { return !unplugged_; }

  // TestPerson
  bool does(PersonTask task, const std::string& words) override;

 private:
  /// The device with its cable and the watchdog of its firmware.
  class Plug final : public Device {
   public:
    Plug(Device& device, std::int64_t watchdog_ns) : device_(device), watchdog_ns_(watchdog_ns) {}
    [[nodiscard]] std::string_view name() const noexcept override { return device_.name(); }
    [[nodiscard]] const Capabilities& capabilities() const noexcept override {
      return device_.capabilities();
    }
    tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override;
    tl::expected<void, DeviceFault> write(const Force& force) noexcept override;
    void stop() noexcept override { device_.stop(); }
    void pull() noexcept;
    void plug_in() noexcept { is_gone_ = false; }

   private:
    Device& device_;
    std::int64_t watchdog_ns_;
    std::optional<std::int64_t> last_ns_;
    bool is_gone_ = false;
  };

  HandInput& hand_;
  DeviceDescriptor descriptor_;
  Plug plug_;
  OpenDevice device_{plug_};
  Vec3 middle_;
  PersonTask task_ = PersonTask::kLeaveAlone;
  std::int64_t now_ns_ = 0;
  std::int64_t since_ns_ = 0;  // when task_ began
  bool unplugged_ = false;
  bool is_open_ = false;
};

}  // namespace felt
