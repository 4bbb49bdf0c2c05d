// The list of all benches: a new one is an include and a line here, and a line in CMakeLists.txt.
#include <array>
#include <utility>

#include "tests/devices/drivers/driver_bench.h"
#include "tests/devices/drivers/evdev_bench.h"
#include "tests/devices/drivers/forcedimension_bench.h"
#include "tests/devices/drivers/haply_bench.h"
#include "tests/devices/drivers/hapticmaster_bench.h"
#include "tests/devices/drivers/openhaptics_bench.h"
#include "tests/devices/drivers/pantograph_bench.h"
#include "tests/devices/drivers/scripted_bench.h"

namespace felt {
namespace {

struct Maker {
  std::string_view name;
  std::unique_ptr<DriverBench> (*make)(std::vector<FaultWindow> faults);
};

constexpr std::array kMakers{
    Maker{"scripted", make_scripted_bench},
    Maker{"openhaptics", make_openhaptics_bench},
    Maker{"forcedimension", make_forcedimension_bench},
    Maker{"haply", make_haply_bench},
    Maker{"pantograph", make_pantograph_bench},
    Maker{"evdev", make_evdev_bench},
    Maker{"hapticmaster", make_hapticmaster_bench},
};

}  // namespace

std::vector<std::string_view> driver_bench_names() {
  std::vector<std::string_view> names;
  for (const Maker& maker : kMakers) names.push_back(maker.name);
  return names;
}

std::unique_ptr<DriverBench> make_driver_bench(std::string_view name,
                                               std::vector<FaultWindow> faults) {
  for (const Maker& maker : kMakers) {
    if (maker.name == name) return maker.make(std::move(faults));
  }
  return nullptr;
}

}  // namespace felt
