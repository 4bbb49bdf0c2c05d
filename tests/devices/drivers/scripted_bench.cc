#include "tests/devices/drivers/scripted_bench.h"

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace felt {
namespace {

constexpr std::string_view kModel = "touch";
constexpr std::int64_t kPatienceNs = 20'000'000;
constexpr std::string_view kPremiumModel = "premium";

PlaneCalibration leaning_table() {
  const double c = std::cos(0.436), s = std::sin(0.436);
  return *PlaneCalibration::from({Vec3{0, 1, 0}, Vec3{c, 0, s}, Vec3{-s, 0, c}}, {20, -10, 3});
}

// The fake that the driver talks to: the world, in a frame of its own.
class OtherSide {
 public:
  OtherSide(std::string_view model, std::vector<FaultWindow> faults)
      : faults_(faults), world_(*find_stylus_preset(model), std::move(faults)) {}

  [[nodiscard]] FakeWorld& world() noexcept { return world_; }
  [[nodiscard]] const std::vector<FaultWindow>& faults() const noexcept { return faults_; }
  void tick(std::int64_t now_ns) noexcept { now_ns_ = now_ns; }

  tl::expected<PenSample, DeviceFault> ask() noexcept {
    auto sample = world_.device().read(now_ns_);
    if (sample) {
      sample->position = plane_.to_device(sample->position);
      sample->velocity = plane_.turn_to_device(sample->velocity);
    }
    return sample;
  }
  tl::expected<void, DeviceFault> push(const Force& force) noexcept {
    const double size = norm(force);
    largest_n_ = std::max(largest_n_, is_finite(force) ? size : HUGE_VAL);
    const Vec3 turned = plane_.turn_to_page(Vec3{force.x, force.y, force.z});
    return world_.device().write({turned.x, turned.y, turned.z});
  }
  void release() noexcept { world_.device().stop(); }
  void forbid() noexcept { rule_ = "a forbidden call"; }

  [[nodiscard]] double largest_n() const noexcept { return largest_n_; }
  [[nodiscard]] std::string_view rule() const noexcept { return rule_; }
  [[nodiscard]] const PlaneCalibration& plane() const noexcept { return plane_; }

 private:
  std::vector<FaultWindow> faults_;
  FakeWorld world_;
  PlaneCalibration plane_ = leaning_table();
  std::int64_t now_ns_ = 0;
  double largest_n_ = 0.0;
  std::string_view rule_;
};

class ScriptedDriverDevice final : public DriverDevice {
 public:
  ScriptedDriverDevice(OtherSide& side, DeviceDescriptor descriptor, BadDriver bad, int opened)
      : side_(side), descriptor_(std::move(descriptor)), bad_(bad), opened_(opened) {}
  ~ScriptedDriverDevice() override { side_.release(); }

  [[nodiscard]] std::string_view name() const noexcept override { return "scripted"; }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return descriptor_.capabilities;
  }
  [[nodiscard]] const DeviceDescriptor& descriptor() const noexcept override { return descriptor_; }
  [[nodiscard]] DeviceStatus status() noexcept override { return status_; }

  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override {
    if (is_gone_) return failed(DeviceFault::kDisconnected);
    auto sample = side_.ask();
    ++reads_;
    if (!sample) {
      is_gone_ = sample.error() == DeviceFault::kDisconnected && bad_ != BadDriver::kDiesOnce;
      return failed(sample.error());
    }
    if (bad_ == BadDriver::kDiesOfHeat && status_.last_fault == DeviceFault::kOverheated) {
      return failed(DeviceFault::kDisconnected);
    }
    if (!is_finite(sample->position) || !is_finite(sample->velocity)) {
      return failed(DeviceFault::kBadData);
    }
    // If the same sample returns again and again, the device no longer answers.
    if (sample->time_ns != answered_ns_) {
      answered_ns_ = sample->time_ns;
      received_ns_ = now_ns;
    } else if (now_ns - received_ns_ > kPatienceNs) {
      return failed(DeviceFault::kOther);
    }
    sample->time_ns = now_ns;
    spoil(*sample);
    status_.fault.reset();
    ++status_.reads;
    last_ = *sample;
    return sample;
  }

  tl::expected<void, DeviceFault> write(const Force& asked) noexcept override {
    if (bad_ == BadDriver::kHangsOn && status_.fault) return tl::unexpected(*status_.fault);
    Force force = asked;
    const bool is_number = is_finite(force);
    if (!is_number && bad_ != BadDriver::kHandsOnNan) force = {};
    const Capabilities& can = descriptor_.capabilities;
    const double largest = std::min(can.advised_force_n, 0.9 * can.max_force_n);
    const double size = norm(force);
    if (size > largest && bad_ != BadDriver::kClampsNothing) force = (largest / size) * force;
    if (bad_ == BadDriver::kWrongForceSign) force = -force;
    if (bad_ == BadDriver::kMirrored) force.x = -force.x;
    if (bad_ == BadDriver::kKicks && opened_ > 1 && reads_ < 50) force = {0.5, 0.0, 0.0};
    const auto done = side_.push(force);
    if (!done) {
      note(done.error());
      return done;
    }
    if (!is_number) {
      note(DeviceFault::kBadData);
      return tl::unexpected(DeviceFault::kBadData);
    }
    return {};
  }

  void stop() noexcept override {
    if (bad_ == BadDriver::kHangsOn && status_.fault) return;
    side_.release();
  }

 private:
  void note(DeviceFault fault) noexcept {
    status_.fault = status_.last_fault = fault;
    ++status_.faults;
    status_.vendor_words = ShortText(describe(fault));
  }
  tl::unexpected<DeviceFault> failed(DeviceFault fault) noexcept {
    note(fault);
    return tl::unexpected(fault);
  }
  void spoil(PenSample& sample) noexcept {
    switch (bad_) {
      case BadDriver::kMirrored:
        sample.position.x = -sample.position.x;
        sample.velocity.x = -sample.velocity.x;
        break;
      case BadDriver::kForgetsSamples:
        if (reads_ % 40 < 25) sample.position = last_.position;
        break;
      case BadDriver::kWrongUnits:
        sample.position = 0.99 * sample.position;
        break;
      case BadDriver::kSaysNan:
        if (reads_ % 500 == 499) sample.position.y = std::numeric_limits<double>::quiet_NaN();
        break;
      case BadDriver::kBreaksRule:
        if (reads_ == 300) side_.forbid();
        break;
      case BadDriver::kAllocates:
        word_ = std::make_unique<int>(static_cast<int>(reads_));
        break;
      case BadDriver::kRemembers: {
        static std::uint64_t ever = 0;
        sample.position.x += 1e-6 * static_cast<double>(++ever % 1000);
        break;
      }
      default:
        break;
    }
  }

  OtherSide& side_;
  DeviceDescriptor descriptor_;
  BadDriver bad_;
  int opened_;
  DeviceStatus status_;
  bool is_gone_ = false;
  std::int64_t answered_ns_ = -1, received_ns_ = 0;
  std::uint64_t reads_ = 0;
  PenSample last_;
  std::unique_ptr<int> word_;
};

class ScriptedDriver final : public Driver {
 public:
  ScriptedDriver(std::unique_ptr<OtherSide>& side, BadDriver bad) : side_(side), bad_(bad) {}

  [[nodiscard]] std::string_view name() const noexcept override { return "scripted"; }
  [[nodiscard]] std::string_view label() const noexcept override { return "A script"; }
  std::vector<DeviceDescriptor> find() override {
    DeviceDescriptor found;
    const StylusPreset& preset = side_->world().preset();
    found.id = "scripted:" + std::string(preset.name);
    found.driver = "scripted";
    found.label = preset.label;
    found.model = preset.name;
    found.capabilities = preset.capabilities;
    // In the frame of the driver.
    const PlaneCalibration& plane = side_->plane();
    const Vec3 a = plane.to_device(preset.capabilities.workspace_min);
    const Vec3 b = plane.to_device(preset.capabilities.workspace_max);
    found.capabilities.workspace_min = {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
    found.capabilities.workspace_max = {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
    return {found};
  }
  Result<std::unique_ptr<DriverDevice>> open(const DeviceDescriptor& device,
                                             const OpenOptions&) override {
    if (const auto sample = side_->ask(); !sample) {
      return fail(ErrorCode::kNotFound, std::string(describe(sample.error())));
    }
    return std::make_unique<ScriptedDriverDevice>(*side_, device, bad_, ++opened_);
  }
  std::vector<Finding> diagnose(const SystemView&) override { return {}; }

 private:
  std::unique_ptr<OtherSide>& side_;
  BadDriver bad_;
  int opened_ = 0;
};

class ScriptedBench final : public DriverBench {
 public:
  ScriptedBench(BadDriver bad, std::vector<FaultWindow> faults)
      : side_(std::make_unique<OtherSide>(kModel, std::move(faults))), driver_(side_, bad) {
    (void)reconnect();
  }

  [[nodiscard]] std::string_view name() const noexcept override { return "scripted"; }
  [[nodiscard]] DriverDevice* device() noexcept override { return device_.get(); }
  [[nodiscard]] PlaneCalibration plane() const noexcept override { return side_->plane(); }
  [[nodiscard]] HandInput& hand() noexcept override { return side_->world().stylus(); }
  [[nodiscard]] FakeWorld& world() noexcept override { return side_->world(); }
  void before_tick(std::int64_t now_ns) noexcept override { side_->tick(now_ns); }
  [[nodiscard]] bool shows(InjectedFault fault) const noexcept override {
    return !is_of_a_service(fault);
  }
  Result<void> reconnect() override {
    device_.reset();
    const std::vector<DeviceDescriptor> found = driver_.find();
    Result<std::unique_ptr<DriverDevice>> opened = driver_.open(found.front(), {});
    if (!opened) return tl::unexpected(opened.error());
    device_ = *std::move(opened);
    return {};
  }
  [[nodiscard]] double largest_asked_n() const noexcept override { return side_->largest_n(); }
  [[nodiscard]] std::string_view broken_rule() const noexcept override { return side_->rule(); }
  /// The driver reports the same values as the world, except for the rounding of two rotations:
  /// some 1e-15 N, which occasionally changes whether the hand goes one step of the sensor (0.055
  /// mm) further. Then each fit may use the tolerance of the pencil, 0.15 mm, in another way; a
  /// circle that closes differs most, by 0.19 mm.
  [[nodiscard]] double tolerance_mm() const noexcept override { return 0.2; }
  [[nodiscard]] std::vector<std::string_view> other_models() const override {
    return {kPremiumModel};
  }
  Result<void> reconnect_as(std::string_view model) override {
    device_.reset();
    side_ = std::make_unique<OtherSide>(model, side_->faults());
    return reconnect();
  }

 private:
  std::unique_ptr<OtherSide> side_;
  ScriptedDriver driver_;
  std::unique_ptr<DriverDevice> device_;
};

constexpr std::array kBad{
    BadDriverName{BadDriver::kClampsNothing, "clamps-nothing"},
    BadDriverName{BadDriver::kHandsOnNan, "hands-on-nan"},
    BadDriverName{BadDriver::kWrongForceSign, "wrong-force-sign"},
    BadDriverName{BadDriver::kMirrored, "mirrored"},
    BadDriverName{BadDriver::kHangsOn, "hangs-on"},
    BadDriverName{BadDriver::kForgetsSamples, "forgets-samples"},
    BadDriverName{BadDriver::kWrongUnits, "wrong-units"},
    BadDriverName{BadDriver::kSaysNan, "says-nan"},
    BadDriverName{BadDriver::kDiesOnce, "dies-once"},
    BadDriverName{BadDriver::kDiesOfHeat, "dies-of-heat"},
    BadDriverName{BadDriver::kKicks, "kicks"},
    BadDriverName{BadDriver::kBreaksRule, "breaks-rule"},
    BadDriverName{BadDriver::kAllocates, "allocates"},
    BadDriverName{BadDriver::kRemembers, "remembers"},
};

}  // namespace

std::span<const BadDriverName> bad_drivers() noexcept {
  return kBad;
}

std::unique_ptr<DriverBench> make_scripted_bench(std::vector<FaultWindow> faults) {
  return make_bad_bench(BadDriver::kNone, std::move(faults));
}

std::unique_ptr<DriverBench> make_bad_bench(BadDriver bad, std::vector<FaultWindow> faults) {
  return std::make_unique<ScriptedBench>(bad, std::move(faults));
}

}  // namespace felt
