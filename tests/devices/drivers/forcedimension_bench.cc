#include "tests/devices/drivers/forcedimension_bench.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "felt/base/check.h"
#include "felt/base/constants.h"
#include "felt/devices/forcedimension/forcedimension.h"
#include "felt/devices/simulated/held_body.h"
#include "felt/driver/device_models.h"
#include "felt/driver/dynamic_library.h"

namespace felt {
namespace {

// The vendor's error numbers.
constexpr int kErrorCom = 2, kErrorTimeout = 7;

std::string path_of(FakeLibrary library) {
  return library == FakeLibrary::kDrd ? FELT_FAKE_LIBDRD : FELT_FAKE_LIBDHD;
}

// Returns the control of the fake, from the same file that the driver will load.
fake_dhd::Bench* fake_in(const std::string& path) {
  auto library =
      DynamicLibrary::open(std::vector<std::string>{path}, LibraryLife::kAsLongAsProgram);
  FELT_CHECK(library.has_value());  // it is built with this test
  fake_dhd::GetBench* get = nullptr;
  SymbolLoader(*library).require(get, "felt_fake_dhd");
  FELT_CHECK(get != nullptr);
  return get();
}

// Returns the simulated device of a model: mechanics of the nearest simulated model, figures of the
// model's row, upright before the user like the driver's default plane.
StylusPreset delta_preset(std::string_view model) {
  StylusPreset preset = *find_stylus_preset(model == "falcon" ? "falcon" : "omega");
  if (model == "omega.3" || model == "falcon") return preset;
  preset.name = model;
  preset.label = model;
  preset.source = "mechanics as the omega's: estimate";
  const Capabilities& row = find_device_model(model)->capabilities;
  const Vec3 size = row.workspace_max - row.workspace_min;
  preset.capabilities = row;
  preset.capabilities.workspace_min = {-10.0, -10.0, -0.5 * size.x};
  preset.capabilities.workspace_max =
      preset.capabilities.workspace_min + Vec3{size.y, size.z, size.x};
  return preset;
}

fake_dhd::Model faked(std::string_view model) {
  if (model == "delta.3") return {.type = 63, .name = "delta.3"};
  if (model == "falcon") return {.type = 60, .name = "Falcon", .has_serial = false};
  if (model == "sigma.7") return {.type = 104, .name = "sigma.7"};
  return {};
}

std::array<double, 3> in_metres(const Vec3& v) {
  return {v.x / kMmPerM, v.y / kMmPerM, v.z / kMmPerM};
}

int vendor_error(DeviceFault fault) {
  return fault == DeviceFault::kDisconnected ? kErrorCom : kErrorTimeout;
}

}  // namespace

FakeArm::FakeArm(const StylusPreset& preset, std::vector<FaultWindow> faults)
    : world_(preset, std::move(faults)) {
  const Capabilities& can = preset.capabilities;
  const Vec3 middle = 0.5 * (can.workspace_min + can.workspace_max);
  plane_ = *PlaneCalibration::from({Vec3{0, 1, 0}, Vec3{0, 0, -1}, Vec3{1, 0, 0}}, middle);
}

void FakeArm::move_to(std::int64_t now_ns) noexcept {
  now_ns_ = now_ns;
  const auto sample = world_.device().read(now_ns);
  sense_.is_home = sample || sample.error() != DeviceFault::kNotCalibrated;
  sense_.error = 0;
  if (!sample) {
    if (sense_.is_home) sense_.error = vendor_error(sample.error());
    return;
  }
  // If the sample has another time, the transfer has timed out.
  if (sample->time_ns != now_ns) sense_.error = kErrorTimeout;
  sense_.position_m = in_metres(plane_.to_device(sample->position));
  sense_.speed_m_per_s = norm(world_.stylus().body().velocity()) / kMmPerM;
  sense_.buttons = sample->buttons;
}

int FakeArm::push(const std::array<double, 3>& force_n) noexcept {
  if (sense_.error == kErrorTimeout) return kErrorTimeout;
  const Vec3 f = plane_.turn_to_page(Vec3{force_n[0], force_n[1], force_n[2]});
  const auto done = world_.device().write({f.x, f.y, f.z});
  if (done) return 0;
  return done.error() == DeviceFault::kForcesOff ? kTaken : vendor_error(done.error());
}

ForceDimensionBench::ForceDimensionBench(std::vector<FaultWindow> faults)
    : ForceDimensionBench("omega.3", std::move(faults), faked("omega.3"), FakeLibrary::kDrd) {}

ForceDimensionBench::ForceDimensionBench(std::string_view model, std::vector<FaultWindow> faults,
                                         const fake_dhd::Model& faked, FakeLibrary library,
                                         bool is_opened)
    : faults_(std::move(faults)),
      fake_(fake_in(path_of(library))),
      driver_(make_forcedimension_driver({.library = path_of(library), .pen_mass_kg = {}})) {
  plug(model, faked);
  if (is_opened) FELT_CHECK(reconnect().has_value());
}

ForceDimensionBench::~ForceDimensionBench() {
  device_.reset();
  unplug();
}

void ForceDimensionBench::plug(std::string_view model, const fake_dhd::Model& faked) {
  arm_ = std::make_unique<FakeArm>(delta_preset(model), faults_);
  number_ = fake_->plug(faked, *arm_);
  FELT_CHECK(number_ >= 0);
}

void ForceDimensionBench::unplug() {
  largest_before_n_ = largest_asked_n();
  broken_before_ = broken_rule();
  fake_->unplug(number_);
}

void ForceDimensionBench::before_tick(std::int64_t now_ns) noexcept {
  arm_->move_to(now_ns);
  fake_->tick(number_);
}

bool ForceDimensionBench::shows(InjectedFault fault) const noexcept {
  // The library reports neither times nor temperatures, and the driver does not read velocities.
  return fault != InjectedFault::kTimeBackwards && fault != InjectedFault::kWarmMotors &&
         fault != InjectedFault::kInfinite && !is_of_a_service(fault);
}

DeviceDescriptor ForceDimensionBench::found() {
  const std::string serial = std::to_string(fake_->serial(number_));
  DeviceDescriptor other;
  for (const DeviceDescriptor& device : driver_->find()) {
    if (device.serial == serial) return device;
    if (device.serial.empty()) other = device;
  }
  return other;
}

Result<void> ForceDimensionBench::open() {
  device_.reset();
  const DeviceDescriptor there = found();
  if (there.id.empty()) return fail(ErrorCode::kNotFound, "it is not in the list");
  auto opened = driver_->open(there, {});
  if (!opened) return tl::unexpected(opened.error());
  device_ = *std::move(opened);
  return {};
}

Result<void> ForceDimensionBench::reconnect() {
  if (auto opened = open(); !opened) return opened;
  if (auto home = device_->find_home(); !home) {
    device_.reset();
    return home;
  }
  return {};
}

double ForceDimensionBench::largest_asked_n() const noexcept {
  return std::max(largest_before_n_, state().largest_asked_n);
}

std::string_view ForceDimensionBench::broken_rule() const noexcept {
  return broken_before_.empty() ? state().broken_rule : broken_before_;
}

// Positions are rounded twice, to the device's steps and to metres. Samples that differ by a
// rounding may be fitted with other joints, each curve and width within 0.15 mm of its samples.
double ForceDimensionBench::tolerance_mm() const noexcept {
  return 2 * 0.15;
}

PenSample ForceDimensionBench::as_said(const PenSample& pen) const noexcept {
  PenSample said = pen;
  said.pressure.reset();
  return said;
}

std::int64_t ForceDimensionBench::notice_ns() const noexcept {
  return 2 * arm_->world().preset().capabilities.period_ns;
}

std::vector<std::string_view> ForceDimensionBench::other_models() const {
  return {"delta.3", "falcon", "sigma.7"};
}

Result<void> ForceDimensionBench::reconnect_as(std::string_view model) {
  device_.reset();
  unplug();
  plug(model, faked(model));
  return reconnect();
}

std::unique_ptr<DriverBench> make_forcedimension_bench(std::vector<FaultWindow> faults) {
  return std::make_unique<ForceDimensionBench>(std::move(faults));
}

}  // namespace felt
