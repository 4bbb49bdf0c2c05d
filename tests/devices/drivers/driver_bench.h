#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "felt/driver/driver.h"
#include "felt/driver/open_device.h"
#include "tests/devices/drivers/fake_world.h"

namespace felt {

/// A driver that is connected to fake hardware or a fake vendor library, on a virtual clock. Whole
/// drawing sessions run through the driver's real code. Each driver has one bench, in
/// tests/devices/drivers/NAME_bench.cc. tests/devices/drivers/README.md says how to add a bench and
/// what the suites require of it.
///
///   auto bench = make_driver_bench("haply", {});
///   OpenDevice device(*bench->device(), bench->plane());    // in the frame of the surface
///   ...  bench->hand().aim(...);  bench->before_tick(now_ns);  servo.step(now_ns);
///
/// Call all functions from one thread. Two benches may exist at the same time. The same calls give
/// the same bytes. A bench uses no wall clock and never sleeps.
class DriverBench {
 public:
  DriverBench() = default;
  DriverBench(const DriverBench&) = delete;
  DriverBench& operator=(const DriverBench&) = delete;
  virtual ~DriverBench() = default;

  /// Returns the driver's name.
  [[nodiscard]] virtual std::string_view name() const noexcept = 0;
  /// Returns the device, opened through Driver::find and Driver::open, and homed. Returns null
  /// after a reconnect() that failed.
  [[nodiscard]] virtual DriverDevice* device() noexcept = 0;
  /// Returns the position of the page in front of the device. It is not the identity if the driver
  /// has a frame of its own.
  [[nodiscard]] virtual PlaneCalibration plane() const noexcept = 0;
  /// Returns the simulated user's hand behind the fake.
  [[nodiscard]] virtual HandInput& hand() noexcept = 0;
  [[nodiscard]] virtual FakeWorld& world() noexcept = 0;
  /// Advances the virtual clock to the tick at this time. Call it before each read(), write() and
  /// stop() of that tick. If the vendor's own loop serves the device, this call is its tick. Times
  /// may be far apart (a stall), repeat, or run backwards (a clock that was set).
  virtual void before_tick(std::int64_t now_ns) noexcept = 0;
  /// Returns true if this fault can happen to this device and the fake simulates it.
  [[nodiscard]] virtual bool shows(InjectedFault fault) const noexcept = 0;
  /// Recovers from a permanent fault: closes the open device and opens again the device that
  /// Driver::find() reports. The world behind the fake stays the same. Fails if find() or open()
  /// fails; device() is null then.
  virtual Result<void> reconnect() = 0;
  /// Returns the largest force, in N, that the driver ever requested from the fake, in any
  /// direction and before any limit of the fake; infinity if a request was not a number.
  [[nodiscard]] virtual double largest_asked_n() const noexcept = 0;
  /// Returns the first rule of the vendor that the driver broke, or an empty string.
  [[nodiscard]] virtual std::string_view broken_rule() const noexcept = 0;
  /// Returns the largest accepted distance, in mm, between ink drawn through the driver and ink
  /// drawn with the plain simulated device. Each bench explains why it is not zero.
  [[nodiscard]] virtual double tolerance_mm() const noexcept = 0;

  // Only some devices need these functions.

  /// Returns the sample that this device would report for a pen with the sample `pen`. Both are in
  /// the frame of the surface. A planar device omits z and reports contact by a button or key. The
  /// plain simulated device that the ink is compared with reports the same.
  [[nodiscard]] virtual PenSample as_said(const PenSample& pen) const noexcept { return pen; }
  /// Returns the longest delay between a fault and its report by read() or write(), because the
  /// driver receives messages only once a period. If the fault takes the motors' force away, the
  /// motors release immediately.
  [[nodiscard]] virtual std::int64_t notice_ns() const noexcept { return 0; }
  /// Returns the time without a message after which the device releases the motors; 0 means never.
  [[nodiscard]] virtual std::int64_t watchdog_ns() const noexcept { return 0; }
  /// Returns the force of the newest message to the device, in the frame of the surface, or nullopt
  /// if the fake does not record it. Exact to 10^-5 N.
  [[nodiscard]] virtual std::optional<Force> last_asked() const { return std::nullopt; }
  /// Returns how long a device still refuses forces after this fault is over, even though it can be
  /// read again.
  [[nodiscard]] virtual std::int64_t stays_off_ns(InjectedFault) const noexcept { return 0; }
  /// Returns true while the service or board is stalled: every command, including stop(), waits
  /// until it continues. Meanwhile only its watchdog can release the motors.
  [[nodiscard]] virtual bool stands_still() const noexcept { return false; }
  /// Returns other models of the same vendor that can be plugged in instead. reconnect_as() unplugs
  /// the present model, plugs in the other one and opens it. From then on, world(), hand() and
  /// plane() belong to the new model.
  [[nodiscard]] virtual std::vector<std::string_view> other_models() const { return {}; }
  virtual Result<void> reconnect_as(std::string_view model) {
    return fail(ErrorCode::kUnsupported, "no other model: " + std::string(model));
  }
};

/// Makes a new bench each time a suite calls it.
using BenchMaker = std::function<std::unique_ptr<DriverBench>(std::vector<FaultWindow> faults)>;

/// Returns the names of all benches, in the order of the list.
std::vector<std::string_view> driver_bench_names();
/// Makes a bench with scheduled faults. Returns null if no bench has this name.
std::unique_ptr<DriverBench> make_driver_bench(std::string_view name,
                                               std::vector<FaultWindow> faults);

}  // namespace felt
