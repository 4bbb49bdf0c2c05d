#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "felt/driver/byte_stream.h"
#include "felt/driver/plane_calibration.h"
#include "tests/devices/drivers/fake_world.h"

namespace felt::hapticmaster {

/// Options of the faked controller.
struct FakeControllerOptions {
  bool is_force_calibrated = true;
  bool is_position_calibrated = true;
  int init_looks = 5;            ///< `get state` requests until the machine has found its end stops
  bool has_emergency = false;    ///< its emergency button is pressed: it does not leave `off`
  std::size_t piece = 0;         ///< answers arrive in pieces of this size; 0: whole
  bool quotes = true;            ///< answers `"force"` instead of `force;`
  bool ignores_guard = false;    ///< the guard's connection is dead, but stays open
  bool refuses_guard = false;    ///< no guard process can be started
  bool gives_up_force = false;   ///< leaves the state `force` for `off` after a while
  bool creates_twice = false;    ///< confirms that it has created an effect that exists already
  bool keeps_effects = false;    ///< confirms `remove all`, but does not carry it out
  int ignored_offs = 0;          ///< confirms so many requests to switch off without doing it
  int ignored_offs_in_init = 0;  ///< the same, but only while it looks for its end stops
  int max_connections = 8;
  /// The guard also acts if no tick comes for its patience. The suites of all drivers let time
  /// stand still, and expect that a device can be read afterwards; this machine must be homed
  /// again.
  bool guard_watches_ticks = false;
  std::string workspace_r = "[-0.18,0.6,0.18]";
};

/// The controller of a HapticMASTER as public clients use it
/// (docs/design/devices.md#hapticmaster-protocol), with a simulated machine behind it: requests
/// with their headers, states, calibration, effects with names, and connections. It enforces the
/// rules and stores the first one that the driver breaks. Never allocates within a tick. Use it
/// from one thread only.
///
/// It also plays the guard process: a connection for which keep_guard() was called sends its last
/// words after the time without a sign of life, on the virtual clock or while the driver waits.
class FakeController {
 public:
  FakeController(FakeWorld& world, std::vector<FaultWindow> faults, const PlaneCalibration& plane,
                 FakeControllerOptions options = {});
  ~FakeController();

  void tick(std::int64_t now_ns);
  /// For HapticMasterOptions::connect.
  Result<std::unique_ptr<ByteStream>> connect(const std::string& host, std::uint16_t port);

  // Faults that only a controller has.
  /// Sends this text instead of `count` answers to requests that begin with `request`, after `skip`
  /// right ones. The requests are carried out all the same.
  void say_instead(std::string text, std::string request, int count = 1, int skip = 0);
  /// Sends an answer that belongs to no request to all connections.
  void say_unasked(std::string_view text);
  /// Sends these bytes to all connections, without a header.
  void babble(std::string_view bytes);
  /// From now on, the requests of the driver stay in its socket. Those of its guard do not.
  void stall() noexcept { is_stalled_ = true; }
  void be_silent(bool is_silent) noexcept { is_silent_ = is_silent; }
  /// Cannot see which connection belongs to a guard, because that is another process. From now on,
  /// counts each removal of an existing effect over another connection than the first one as an act
  /// of the guard.
  void count_every_guard() noexcept { has_remote_guard_ = true; }
  void set_state(std::string_view state) { enter(state); }
  /// Ends the connections of the driver, or that of the guard.
  void hang_up() noexcept;
  void hang_up_guard() noexcept;
  /// Makes sends time out, as if the socket were full.
  void refuse_requests(int count) noexcept { refusals_ = count; }

  [[nodiscard]] FakeControllerOptions& options() noexcept { return options_; }
  [[nodiscard]] std::string_view state() const noexcept { return state_; }
  [[nodiscard]] int effects() const noexcept;
  [[nodiscard]] double largest_asked_n() const noexcept { return largest_n_; }
  [[nodiscard]] std::string_view broken_rule() const noexcept { return rule_; }
  /// Returns the force of the newest request that sets one, or zero after one that takes all forces
  /// away, in the machine's axes, N.
  [[nodiscard]] const Force& newest_force() const noexcept { return newest_; }
  /// Returns the largest number of requests that waited at the same time.
  [[nodiscard]] std::size_t max_waiting() const noexcept { return max_waiting_; }
  [[nodiscard]] bool stands_still() const noexcept { return !waiting_.empty(); }
  [[nodiscard]] int guard_acts() const noexcept { return guard_acts_; }
  [[nodiscard]] int requests() const noexcept { return requests_; }
  [[nodiscard]] double inertia_kg() const noexcept { return inertia_kg_; }
  [[nodiscard]] double friction_n() const noexcept { return friction_n_; }

  class Port;  ///< one connection, with both ends

 private:
  friend class Port;
  friend class FakeStream;
  struct Effect {
    std::array<char, 24> name{};
    bool exists = false;
    bool is_enabled = false;
    Force force;
  };
  struct Waiting {
    Port* port = nullptr;
    std::array<char, 256> text{};
    std::size_t size = 0;
    std::int64_t done_ns = 0;
    bool bears_force = false;
  };

  void accept(Port& port, std::string_view text);
  void handle(Port& port, std::string_view text);
  std::string_view answer_to(std::string_view text);
  std::string_view answer_to_get(std::string_view what);
  std::string_view answer_to_set(std::string_view what);
  std::string_view set_effect(std::string_view name, std::string_view what);
  std::string_view set_bias(Effect& effect, std::string_view vector);
  std::string_view vector_text(const Vec3& v);
  void enter(std::string_view state);
  std::string_view create(std::string_view what);
  Effect* find(std::string_view name) noexcept;
  void remove_all() noexcept;
  bool apply();
  void work_until(std::int64_t until_ns);
  void pass_time(std::int64_t ns);
  void watch_guards();
  [[nodiscard]] std::int64_t done_at() noexcept;
  [[nodiscard]] const FaultWindow* window_of(InjectedFault fault) const noexcept;
  [[nodiscard]] bool is_active(InjectedFault fault) const noexcept {
    return window_of(fault) != nullptr;
  }
  void break_rule(std::string_view rule) {
    if (rule_.empty()) rule_ = rule;
  }

  FakeWorld& world_;
  std::vector<FaultWindow> faults_;
  PlaneCalibration plane_;
  FakeControllerOptions options_;
  std::vector<Port*> ports_;
  std::vector<Waiting> waiting_;
  std::array<Effect, 4> effects_{};
  std::int64_t now_ns_ = 0;
  std::int64_t idle_ns_ = 0;  // time in which the driver waited since the last tick
  tl::expected<PenSample, DeviceFault> pen_;
  std::string state_ = "off", instead_, instead_of_, rule_;
  std::array<char, 128> room_{};
  int insteads_ = 0, skips_ = 0;
  Force newest_;
  double largest_n_ = 0.0;
  double inertia_kg_ = 0.0, friction_n_ = 0.0;
  std::size_t max_waiting_ = 0;
  std::int64_t busy_until_ns_ = 0;
  std::int64_t late_window_ns_ = -1;  // the window of the late answer that was already simulated
  bool owes_answer_ = false;
  bool has_remote_guard_ = false;
  bool is_there_ = true;
  bool was_stopped_ = false;  // by the fault kForcesOff
  bool is_silent_ = false, is_stalled_ = false;
  int looks_ = 0;
  int refusals_ = 0;
  int guard_acts_ = 0;
  int requests_ = 0;
};

/// One connection. A driver's end is a ByteStream that refers to it.
class FakeController::Port {
 public:
  explicit Port(FakeController& controller);
  ~Port();
  Port(const Port&) = delete;
  Port& operator=(const Port&) = delete;

  /// Accepts bytes from the client. Returns false if the connection was ended.
  bool take(std::span<const std::byte> bytes);
  /// Returns the bytes that the client has not read yet; the client erases them from the front.
  [[nodiscard]] std::string& out() noexcept { return out_; }
  [[nodiscard]] bool is_open() const noexcept { return is_open_; }
  void say(std::string_view text);  ///< sends an answer with its header

 private:
  friend class FakeController;
  friend class FakeStream;
  void act_as_guard();

  FakeController* controller_;
  bool is_open_ = true;
  std::string in_, out_, held_;  // held_: answers that the fault kNoAnswer holds back
  std::string last_words_;       // of a guard; empty if this connection has none
  std::int64_t patience_ns_ = 0;
  std::int64_t beat_ns_ = 0;
  bool has_beaten_ = false;
  bool is_guard_alive_ = false;
};

}  // namespace felt::hapticmaster
