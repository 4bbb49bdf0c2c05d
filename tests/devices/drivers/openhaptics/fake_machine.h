#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "felt/devices/openhaptics/hd_abi.h"
#include "tests/devices/drivers/openhaptics/fake_libhd.h"
#include "tests/devices/drivers/openhaptics/standalone_world.h"

/// The state behind the fake's functions: the device that is plugged in, the program that uses it,
/// the scheduler and its ticks, the motors.
namespace felt::fake_libhd {

namespace error = hd::error;
namespace parameter = hd::parameter;
namespace capability = hd::capability;
namespace calibration = hd::calibration;

inline constexpr hd::Handle kHandle = 7;
inline constexpr std::size_t kMaxErrors = 256;
inline constexpr std::size_t kMaxCallbacks = 64;

struct Scheduled {
  hd::CallbackHandle handle;
  hd::Callback call;
  void* data;
  unsigned short priority;
};

struct Frame {
  FakeHdPen pen{};
  bool safety_switch = true;
  bool inkwell = false;
};

struct Fake {
  // The device that is plugged in.
  std::optional<FakeHdModel> model;
  FakeHdWorld world{};
  std::unique_ptr<StandaloneWorld> own_world;
  bool is_occupied = false;
  bool safety_switch = true, inkwell = false, at_rest = false, is_home = true;
  bool calibration_lost = false;  // reported by the world
  double temperature = 0.0;
  bool is_warm = false;
  unsigned refusal = 0;
  bool calls_while_stopping = false;

  // State of the program.
  int open = 0;
  bool is_running = false;
  std::array<hd::ErrorInfo, kMaxErrors> errors{};
  std::size_t error_count = 0;
  std::vector<Scheduled> callbacks;
  hd::CallbackHandle next_callback = 1;
  std::vector<std::pair<hd::Enum, bool>> capabilities;

  // The tick.
  std::int64_t now_ns = 0, last_ns = 0;
  bool tick_is_open = false, frame_is_open = false, frame_was = false;
  int read_result = 0;
  FakeHdPen read_pen{};
  Frame frame;  // from the last begin
  std::array<double, 3> asked{};
  double held_n = 0.0;
  std::thread::id servo;

  // Records for tests.
  double largest_n = 0.0;
  const char* rule = "";
  std::uint64_t frames = 0;

  // The scheduler's thread.
  bool uses_thread = true;  // until a test says otherwise
  std::thread thread;
  std::atomic<bool> stop_thread{false};
  std::recursive_mutex mutex;
};

Fake& fake();

/// Locks only if the scheduler is a second thread; in virtual time a tick must not even lock.
class Guard {
 public:
  Guard() : locks_(fake().uses_thread) {
    if (locks_) fake().mutex.lock();
  }
  ~Guard() {
    if (locks_) fake().mutex.unlock();
  }
  Guard(const Guard&) = delete;
  Guard& operator=(const Guard&) = delete;

 private:
  bool locks_;
};

/// Returns the vendor's error for the result of reading the world (`read_result`).
hd::Enum error_of(int result);
/// Pushes an error onto the vendor's error stack.
void push(hd::Enum code, int internal = 0);
/// Stores the first broken rule of the vendor, and pushes its error.
void broken(const char* rule, hd::Enum code = 0);
/// Returns true if this capability is enabled.
bool has(hd::Enum what);
/// Sets the capabilities of a device that was just opened.
void start_capabilities();
/// Returns true if the call comes from within the servo loop.
bool is_in_tick();
/// Sets the force of the motors to zero.
void release();
/// Sends the force to the motors at the end of a frame.
void send();
/// Plugs in a simulated Touch if no test plugs anything in, so that users can try the driver.
void plug_in_own();
/// Resets to the state after loading, on a virtual clock.
void reset();

// The scheduler.
void open_tick(std::int64_t now_ns);
void close_tick();
void step(std::int64_t now_ns);  ///< a whole tick: all callbacks
void run_thread();
void stop_running();

}  // namespace felt::fake_libhd
