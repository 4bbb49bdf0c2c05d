// The driver, its guard process and the controller as three processes with real connections.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
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

constexpr int kTrials = 20;
constexpr std::int64_t kLongNs = 20 * kSecond;  // an upper bound; no test waits that long

StylusPreset table_preset() {
  return {.name = "hapticmaster",
          .label = "Moog HapticMASTER",
          .source = "a test",
          .mechanics = {.mass_kg = HapticMasterDevice::kInertiaKg},
          .capabilities = find_device_model("hapticmaster")->capabilities};
}

volatile std::sig_atomic_t must_stop = 0;

// Uses the driver as a program does: prepares the machine, then pushes, until it is killed. After
// SIGUSR1, it stops its loop. A trial of the guard fails if this computer is too busy, so there are
// several.
[[noreturn]] void be_the_program(std::uint16_t port) {
  FakeSystem system;
  system.set_environment(kAddressVariable, "127.0.0.1:" + std::to_string(port));
  HapticMasterOptions options;
  options.system = &system;
  const auto driver = make_hapticmaster_driver(options);
  auto device = driver->open(driver->find().at(0), {});
  if (!device) _exit(1);
  ::signal(SIGUSR1, [](int) { must_stop = 1; });
  for (int i = 0; i < kTrials && !(*device)->find_home(); ++i) {
  }
  for (std::int64_t now_ns = 0; must_stop == 0; now_ns += 4 * kMs) {
    static_cast<void>((*device)->read(now_ns));
    static_cast<void>((*device)->write({0, 0, 2.0}));
    usleep(4000);
  }
  (*device)->stop();
  for (;;) pause();
}

// Returns a child of this process (proc_pid_stat(5), field 4), or 0 if it has none.
pid_t child_of(pid_t parent) {
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    std::ifstream stat(entry.path() / "stat");
    std::string line, state;
    if (!std::getline(stat, line)) continue;
    std::istringstream rest(line.substr(line.rfind(')') + 1));
    pid_t its_parent = 0;
    if (rest >> state >> its_parent && its_parent == parent) {
      return static_cast<pid_t>(std::stol(entry.path().filename().string()));
    }
  }
  return 0;
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
    if (guard_ > 0) ::kill(guard_, SIGCONT);
    ::kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  void signal(int number) const { ::kill(process_, number); }
  void signal_guard(int number) {
    guard_ = child_of(process_);
    ASSERT_GT(guard_, 0);
    ::kill(guard_, number);
    if (number == SIGKILL) guard_ = -1;
  }
  [[nodiscard]] FakeServer& server() { return server_; }
  [[nodiscard]] FakeController& controller() { return controller_; }
  [[nodiscard]] double held_n() const { return norm(world_.held_force()); }
  /// Serves until no force is left. Returns false if that takes too long.
  bool serve_until_it_lets_go() {
    return serve_until([this] { return held_n() == 0.0; });
  }
  bool serve_until_it_is_off() {
    return serve_until([this] {
      return controller_.effects() == 0 && controller_.state() == "off" && held_n() == 0.0;
    });
  }
  void serve_for(std::int64_t ns) {
    const std::int64_t end_ns = server_.now_ns() + ns;
    serve_until([&] { return server_.now_ns() >= end_ns; });
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
    return serve_until_it_is_off() ? server_.now_ns() - begin_ns : kLongNs;
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
  pid_t guard_ = -1;
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

// Without a guard, no force is sent.
TEST(HapticMasterGuard, R49_ThereIsNoForceAfterTheGuardWasKilled) {
  Program program;
  ASSERT_TRUE(program.serve_until_it_pushes());
  program.signal_guard(SIGKILL);
  EXPECT_TRUE(program.serve_until_it_lets_go());
  program.serve_for(100 * kMs);
  EXPECT_EQ(program.held_n(), 0.0);
  EXPECT_EQ(program.broken_rule(), "");
}

// A guard that is stopped still accepts signs of life, but would not act.
TEST(HapticMasterGuard, R49_ThereIsNoForceWhileTheGuardIsStopped) {
  Program program;
  ASSERT_TRUE(program.serve_until_it_pushes());
  program.signal_guard(SIGSTOP);
  const std::int64_t begin_ns = program.server().now_ns();
  EXPECT_TRUE(program.serve_until_it_lets_go());
  std::printf("no force %.2f ms after the guard was stopped\n",
              1e-6 * static_cast<double>(program.server().now_ns() - begin_ns));
  program.serve_for(100 * kMs);
  EXPECT_EQ(program.held_n(), 0.0);
  EXPECT_EQ(program.broken_rule(), "");
}

// The connection of the program stands still, with the force in its socket. That of the guard
// works.
TEST(HapticMasterGuard, R49_SwitchesOffOverItsOwnConnectionWhileTheOtherStandsStill) {
  Program program;
  ASSERT_TRUE(program.serve_until_it_pushes());
  program.server().stall_first();
  EXPECT_TRUE(program.serve_until_it_is_off());
  EXPECT_EQ(program.broken_rule(), "");
}

TEST(HapticMasterGuard, R49_SwitchesOffAfterAStopThatIsNotConfirmed) {
  Program program;
  ASSERT_TRUE(program.serve_until_it_pushes());
  program.server().stall_first();
  program.signal(SIGUSR1);
  EXPECT_TRUE(program.serve_until_it_is_off()) << "no tick follows";
}

TEST(HapticMasterGuard, RestsAfterAStopThatIsConfirmed) {
  Program program;
  ASSERT_TRUE(program.serve_until_it_pushes());
  program.signal(SIGUSR1);
  EXPECT_TRUE(program.serve_until_it_lets_go());
  program.serve_for(200 * kMs);
  EXPECT_EQ(program.controller().state(), "force");
  program.end();
  EXPECT_TRUE(program.serve_until_it_is_off()) << "the end of the program is not a rest";
}

}  // namespace
}  // namespace felt::hapticmaster::guard_process_test
