// The driver, its guard process and the controller as three processes with real connections.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <string>

#include "felt/base/constants.h"
#include "felt/devices/hapticmaster/controller_address.h"
#include "felt/devices/hapticmaster/hapticmaster_device.h"
#include "felt/devices/hapticmaster/hapticmaster_driver.h"
#include "felt/driver/device_models.h"
#include "felt/driver/testing/fake_system.h"
#include "tests/devices/drivers/hapticmaster/fake_server.h"

namespace felt::hapticmaster::guard_process_test {
namespace {

constexpr std::int64_t kLongNs = 20 * kSecond;  // an upper bound; no test waits that long

StylusPreset table_preset() {
  return {.name = "hapticmaster",
          .label = "Moog HapticMASTER",
          .source = "a test",
          .mechanics = {.mass_kg = HapticMasterDevice::kInertiaKg},
          .capabilities = find_device_model("hapticmaster")->capabilities};
}

// Uses the driver as a program does: prepares the machine, then pushes, until it is killed.
[[noreturn]] void be_the_program(std::uint16_t port) {
  FakeSystem system;
  system.set_environment(kAddressVariable, "127.0.0.1:" + std::to_string(port));
  HapticMasterOptions options;
  options.system = &system;
  const auto driver = make_hapticmaster_driver(options);
  auto device = driver->open(driver->find().at(0), {});
  if (!device || !(*device)->find_home()) _exit(1);
  for (std::int64_t now_ns = 0;; now_ns += 4 * kMs) {
    static_cast<void>((*device)->read(now_ns));
    static_cast<void>((*device)->write({0, 0, 2.0}));
    usleep(4000);
  }
}

class Program {
 public:
  Program() : world_(table_preset()), controller_(world_, {}, {}), server_(controller_) {
    controller_.count_every_guard();
    process_ = ::fork();
    if (process_ == 0) be_the_program(server_.port());
  }
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program() { end(); }

  void end() {
    ::kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  /// Serves until the machine holds the whole force. Returns false if that takes too long.
  bool serve_until_it_pushes() {
    return serve_until([this] { return norm(world_.held_force()) > 1.99; });
  }
  /// Sends the program a signal, and serves until no effect is left and the machine is off. Returns
  /// the time from the signal on, or a long time.
  std::int64_t off_after_ns(int signal) {
    const std::int64_t begin_ns = server_.now_ns();
    ::kill(process_, signal);
    const bool is_off = serve_until([this] {
      return controller_.effects() == 0 && controller_.state() == "off" &&
             world_.held_force() == Force{};
    });
    return is_off ? server_.now_ns() - begin_ns : kLongNs;
  }
  [[nodiscard]] std::string_view broken_rule() const { return controller_.broken_rule(); }

 private:
  template <class Done>
  bool serve_until(const Done& done) {
    const std::int64_t end_ns = server_.now_ns() + kLongNs;
    while (!done() && server_.now_ns() < end_ns) server_.serve();
    return done();
  }

  FakeWorld world_;
  FakeController controller_;
  FakeServer server_;
  pid_t process_ = -1;
};

// Prints the delay, which docs/figures.md reports.
void expect_off_in_time(Program& program, int signal) {
  ASSERT_TRUE(program.serve_until_it_pushes());
  const std::int64_t delay_ns = program.off_after_ns(signal);
  std::printf("after signal %d: off after %.2f ms\n", signal, 1e-6 * static_cast<double>(delay_ns));
  EXPECT_LT(delay_ns, HapticMasterDevice::kMaxGuardNs);
  EXPECT_EQ(program.broken_rule(), "");
}

TEST(HapticMasterGuard, R49_TakesEveryEffectAwayAfterTheProgramWasKilled) {
  Program program;
  expect_off_in_time(program, SIGKILL);
}

TEST(HapticMasterGuard, R49_TakesEveryEffectAwayWhileTheProgramIsStopped) {
  Program program;
  expect_off_in_time(program, SIGSTOP);
}

}  // namespace
}  // namespace felt::hapticmaster::guard_process_test
