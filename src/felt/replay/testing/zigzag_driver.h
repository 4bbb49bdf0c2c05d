#pragma once

#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "felt/driver/driver.h"

/// A driver for tests. Its only device draws by itself and can be lost or become unresponsive.
namespace felt {

/// State shared by a driver and its devices. The loop's thread also writes it.
struct ZigzagWorld {
  std::atomic<int> opened{0};
  std::atomic<int> looks{0};
  std::atomic<double> largest_n{0.0};
  std::atomic<bool> is_gone{false};
  std::atomic<bool> hangs{false};
  std::atomic<int> stops{0};
  int gone_after_reads = 400;  ///< calls of read() on the first opened device
  int hangs_after_reads = 1 << 30;
  bool never_comes_back = false;
  std::atomic<int> refusals{0};  ///< number of times that open() fails after the first success
  std::atomic<int> refused{0};   ///< failures so far
  ErrorCode refusal = ErrorCode::kIo;
  /// Moves up and down without jumps, because jumps would latch the safety chain.
  bool is_calm = false;
};

/// A pen that draws zigzags into the plane by itself, 0.2 s down and 0.1 s up, in real time.
class ZigzagDevice final : public DriverDevice {
 public:
  ZigzagDevice(ZigzagWorld& world, DeviceDescriptor descriptor, bool fails)
      : world_(world), descriptor_(std::move(descriptor)), fails_(fails) {}

  [[nodiscard]] std::string_view name() const noexcept override { return "zigzag"; }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return descriptor_.capabilities;
  }
  [[nodiscard]] const DeviceDescriptor& descriptor() const noexcept override { return descriptor_; }
  [[nodiscard]] DeviceStatus status() noexcept override {
    DeviceStatus status;
    if (is_gone_) {
      status.fault = status.last_fault = DeviceFault::kDisconnected;
      status.vendor_words = ShortText("cable error 17");
    }
    return status;
  }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override {
    if (fails_ && ++reads_ > world_.gone_after_reads) is_gone_ = true;
    if (reads_ == world_.hangs_after_reads) world_.hangs = true;
    while (world_.hangs) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (is_gone_) world_.is_gone = true;
    if (is_gone_) return tl::unexpected(DeviceFault::kDisconnected);
    const double t = 1e-9 * static_cast<double>(now_ns);
    const double phase = std::fmod(t, 0.3);
    PenSample sample;
    sample.time_ns = now_ns;
    // Each stroke has its own position, because strokes that meet may be joined.
    const double row = std::fmod(std::floor(t / 0.3), 16.0);
    sample.position = {50.0 * phase + 40.0 * world_.opened,
                       12.0 * row + 2.0 * std::sin(20.0 * phase), phase < 0.2 ? -1.0 : 2.0};
    if (world_.is_calm) {
      sample.position = {20.0 + 10.0 * std::sin(3.0 * t), 10.0, 0.5 - 1.5 * std::sin(8.0 * t)};
    }
    return sample;
  }
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override {
    if (norm(force) > world_.largest_n.load()) world_.largest_n.store(norm(force));
    return {};
  }
  void stop() noexcept override { ++world_.stops; }

 private:
  ZigzagWorld& world_;
  DeviceDescriptor descriptor_;
  bool fails_;
  int reads_ = 0;
  std::atomic<bool> is_gone_{false};
};

class ZigzagDriver final : public Driver {
 public:
  explicit ZigzagDriver(ZigzagWorld& world) : world_(world) {
    device_.id = "zigzag:1";
    device_.driver = "zigzag";
    device_.label = "Zigzag";
    device_.has_own_frame = false;
    device_.capabilities.max_force_n = 3.0;
    device_.capabilities.continuous_force_n = 1.0;
    device_.capabilities.max_stiffness_n_per_m = 400.0;
    device_.capabilities.max_damping_n_s_per_m = 4.0;
  }
  [[nodiscard]] std::string_view name() const noexcept override { return "zigzag"; }
  [[nodiscard]] std::string_view label() const noexcept override { return "Zigzag"; }
  std::vector<DeviceDescriptor> find() override {
    if (world_.never_comes_back || ++world_.looks < 2) return {};
    return {device_};
  }
  Result<std::unique_ptr<DriverDevice>> open(const DeviceDescriptor&, const OpenOptions&) override {
    if (world_.opened > 0 && world_.refused < world_.refusals) {
      ++world_.refused;
      return fail(world_.refusal, "not now");
    }
    const bool is_first = world_.opened++ == 0;
    DeviceDescriptor open = device_;
    open.serial = serial_once_open_;
    return std::unique_ptr<DriverDevice>(std::make_unique<ZigzagDevice>(world_, open, is_first));
  }
  std::vector<Finding> diagnose(const SystemView&) override { return {}; }
  [[nodiscard]] const DeviceDescriptor& device() const noexcept { return device_; }
  void give_own_frame() { device_.has_own_frame = true; }
  void report_serial_once_open(std::string serial) { serial_once_open_ = std::move(serial); }

 private:
  ZigzagWorld& world_;
  DeviceDescriptor device_;
  std::string serial_once_open_;
};

}  // namespace felt
