// hapticmaster_server SECONDS: a fake controller on a TCP port of this computer, with a hand that
// holds the handle of its machine, to try `feltline doctor`, `device-test` and `record` by hand:
//   build/dev/bin/hapticmaster_server 60 &
//   FELT_HAPTICMASTER_ADDRESS=127.0.0.1:PORT feltline doctor
// Prints the port, and at the end the state, the largest force and the first broken rule.
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "felt/base/constants.h"
#include "felt/driver/device_models.h"
#include "tests/devices/drivers/hapticmaster/fake_server.h"

int main(int argc, char** argv) {
  using namespace felt;
  const double seconds = argc > 1 ? std::atof(argv[1]) : 60.0;
  StylusPreset preset{.name = "hapticmaster",
                      .label = "Moog HapticMASTER",
                      .source = "a test",
                      .mechanics = {.mass_kg = 3.0, .friction_n = 0.05},
                      .capabilities = find_device_model("hapticmaster")->capabilities};
  preset.capabilities.position_step_mm = 0.012;
  FakeWorld world(preset);
  hapticmaster::FakeController controller(world, {}, {});
  controller.count_every_guard();
  hapticmaster::FakeServer server(controller);
  std::printf("%u\n", static_cast<unsigned>(server.port()));
  std::fflush(stdout);
  while (1e-9 * static_cast<double>(server.now_ns()) < seconds) {
    world.stylus().aim({0.0, 0.0, 10.0}, {}, 0);
    server.serve();
  }
  std::printf("state %s, %d effects, %d requests, %.3f N asked at most, rule: %s\n",
              std::string(controller.state()).c_str(), controller.effects(), controller.requests(),
              controller.largest_asked_n(), std::string(controller.broken_rule()).c_str());
}
