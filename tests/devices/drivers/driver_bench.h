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

/// A driver with a fake of its other side, on a virtual clock: whole drawing sessions run through
/// the driver's real code. One per driver, in tests/devices/drivers/NAME_bench.cc;
/// tests/devices/drivers/README.md says how to add it, and what the suites ask of it.
///
///   auto bench = make_driver_bench("haply", {});
///   OpenDevice device(*bench->device(), bench->plane());    // in the sheet's frame
///   ...  bench->hand().aim(...);  bench->before_tick(now_ns);  servo.step(now_ns);
///
/// One thread calls all of it. Two benches may live at the same time. The same calls give the same
/// bytes. No wall clock, no sleep.
class DriverBench {
 public:
  DriverBench() = default;
  DriverBench(const DriverBench&) = delete;
  DriverBench& operator=(const DriverBench&) = delete;
  virtual ~DriverBench() = default;

  /// The driver's name.
  [[nodiscard]] virtual std::string_view name() const noexcept = 0;
  /// Opened through Driver::find and Driver::open, homed. Null after a reconnect() that failed.
  [[nodiscard]] virtual DriverDevice* device() noexcept = 0;
  /// Where the sheet lies in front of it: not the identity, for a driver with a frame of its own.
  [[nodiscard]] virtual PlaneCalibration plane() const noexcept = 0;
  /// The person behind the fake.
  [[nodiscard]] virtual HandInput& hand() noexcept = 0;
  [[nodiscard]] virtual FakeWorld& world() noexcept = 0;
  /// The virtual clock goes on to the tick at this time: before each read(), write() and stop() of
  /// that tick. Where the maker's own loop serves the device this is its tick. Times may be far
  /// apart (a stall), the same again, or run backwards (a clock that was set).
  virtual void before_tick(std::int64_t now_ns) noexcept = 0;
  /// Can this fault happen to this device, and does the fake show it?
  [[nodiscard]] virtual bool shows(InjectedFault fault) const noexcept = 0;
  /// After a fault for ever: closes what is open and opens anew what Driver::find() sees. The world
  /// behind the fake stays what it is. Error: what find() or open() said; device() is null then.
  virtual Result<void> reconnect() = 0;
  /// The largest force, N, that the other side was ever asked for, in any direction, before any
  /// limit of the fake's own; infinity where it was asked for what is no number. And whether a rule
  /// of the vendor was ever broken (empty: no).
  [[nodiscard]] virtual double largest_asked_n() const noexcept = 0;
  [[nodiscard]] virtual std::string_view broken_rule() const noexcept = 0;
  /// How far ink drawn through it may lie from ink drawn with the plain simulated device, mm, and
  /// why that is not zero.
  [[nodiscard]] virtual double tolerance_mm() const noexcept = 0;

  // What not every device needs.

  /// What this device would say of a pen that is there, both in the sheet's frame: a planar one
  /// leaves z out and tells contact in its own way (a button, a key). The plain simulated device
  /// that the ink is compared with speaks like this.
  [[nodiscard]] virtual PenSample as_said(const PenSample& pen) const noexcept { return pen; }
  /// How much later than it happens a fault can be told by read() or write(), because the other
  /// side is heard once a period only. The motors let go at once all the same, where the fault is
  /// one that takes their force away.
  [[nodiscard]] virtual std::int64_t notice_ns() const noexcept { return 0; }
  /// The other side lets go of the motors by itself when it hears nothing for so long; 0: never.
  [[nodiscard]] virtual std::int64_t watchdog_ns() const noexcept { return 0; }
  /// The force, in the sheet's frame, that the newest message to the other side asked for; nullopt
  /// if the fake does not record it. Exact to 10^-5 N.
  [[nodiscard]] virtual std::optional<Force> last_asked() const { return std::nullopt; }
  /// How long a device takes no force after this fault is over, though it is read again.
  [[nodiscard]] virtual std::int64_t stays_off_ns(InjectedFault) const noexcept { return 0; }
  /// The other side stands still: what it is told, a stop() too, waits until it goes on; meanwhile
  /// only its watchdog lets go.
  [[nodiscard]] virtual bool stands_still() const noexcept { return false; }
  /// Other models of the same maker, which can be plugged in instead: reconnect_as() unplugs what
  /// is there, plugs this one in and opens it. From then on world(), hand() and plane() are its.
  [[nodiscard]] virtual std::vector<std::string_view> other_models() const { return {}; }
  virtual Result<void> reconnect_as(std::string_view model) {
    return fail(ErrorCode::kUnsupported, "no other model: " + std::string(model));
  }
};

/// Makes the bench of a suite, as often as it wants one.
using BenchMaker = std::function<std::unique_ptr<DriverBench>(std::vector<FaultWindow> faults)>;

/// Names of all benches, in order.
std::vector<std::string_view> driver_bench_names();
/// With faults that come on schedule. Null: no bench has this name.
std::unique_ptr<DriverBench> make_driver_bench(std::string_view name,
                                               std::vector<FaultWindow> faults);

}  // namespace felt
