#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "felt/driver/byte_stream.h"
#include "felt/driver/plane_calibration.h"
#include "tests/devices/drivers/fake_world.h"

namespace felt::haply {

/// Options of the faked service.
struct FakeServiceOptions {
  std::string version = "3.4.2.0";
  std::string key = "values";  ///< the only key under which it accepts a force
  std::string device_id = "049D";
  std::string type = "inverse3";
  std::string grip_family = "verse_grip";
  bool is_calibrated = true;
  int calibrates_after = 20;  ///< messages until it is calibrated, if it is not
  bool has_power = true;
  bool has_gravity_compensation = true;
  bool has_events = true;
  bool shows_force = true;    ///< in current_cursor_force
  bool fragments = false;     ///< sends its messages in pieces, with pings between
  bool answers_once = false;  ///< one state for all messages that waited while it stood still
  /// How long a force lasts without another message. The real service is only documented as
  /// "returns to idle".
  std::int64_t watchdog_ns = 20'000'000;
};

/// The Inverse Service as its pages describe it, with a simulated device behind it: HTTP, the
/// WebSocket with one state for each message, forces that last for one message, the events. It
/// enforces the rules on the pages and stores the first rule that a client breaks. Use it from one
/// thread only.
///
/// tick() reads the world, outside of the client's own tick. A message within the tick acts on the
/// motors immediately, allocates nothing, and is answered with the state of that tick. Forces that
/// arrive within one tick add up. While the service is stalled (kNoAnswer), messages wait, as in a
/// socket; the first tick after the stall accepts all of them, and their forces add up too. A slow
/// service (kSlowAnswers) handles messages one after the other, each for the same time; the force
/// acts and the answer is sent at the end of that time. A service that works in bursts accepts all
/// waiting messages together. If an answer is ready while the client still waits for it, the client
/// receives it in the same tick.
class FakeService {
 public:
  FakeService(FakeWorld& world, std::vector<FaultWindow> faults, const PlaneCalibration& plane,
              FakeServiceOptions options = {});
  ~FakeService();

  void tick(std::int64_t now_ns);
  /// Connects to one of its ports (10001 or 10020). For HaplyOptions::connect.
  Result<std::unique_ptr<ByteStream>> connect(const std::string& host, std::uint16_t port);
  /// Sends an event to all listeners.
  void report(std::string_view event);
  /// Ends all connections, as when the service is restarted.
  void hang_up();
  /// Sends this text instead of states, until it is set to an empty text.
  void say_instead(std::string text) { instead_ = std::move(text); }
  /// Accepts messages, but sends nothing.
  void be_silent(bool is_silent) { is_silent_ = is_silent; }

  [[nodiscard]] FakeServiceOptions& options() noexcept { return options_; }
  [[nodiscard]] double largest_asked_n() const noexcept { return largest_n_; }
  [[nodiscard]] std::string_view broken_rule() const noexcept { return rule_; }
  /// Returns the requested force of the newest handled message, in the service's axes, in N. If
  /// waiting messages were handled together, returns the sum of their forces.
  [[nodiscard]] const Force& asked() const noexcept { return asked_; }
  [[nodiscard]] int messages() const noexcept { return messages_; }
  [[nodiscard]] int ignored_forces() const noexcept { return ignored_; }
  /// Returns the profile of the first message of the newest session; empty if it had none.
  [[nodiscard]] const std::string& profile() const noexcept { return profile_; }
  [[nodiscard]] const std::string& preset() const noexcept { return preset_; }
  [[nodiscard]] bool is_connected() const noexcept;
  /// Returns the force of the newest message, accepted or not, in the service's axes, in N.
  [[nodiscard]] const Force& newest_force() const noexcept { return newest_; }
  /// Returns the largest number of messages that waited at the same time before they were accepted.
  [[nodiscard]] std::size_t max_waiting() const noexcept { return max_waiting_; }
  /// Returns the largest rise of the force from one message to the next, in N.
  [[nodiscard]] double largest_rise_n() const noexcept { return largest_rise_n_; }
  /// Simulates a client that waits this long for an answer.
  void wait(std::int64_t within_ns) { work_until(now_ns_ + within_ns); }
  /// Returns true if messages wait, because a force that should end may still act.
  [[nodiscard]] bool stands_still() const noexcept {
    return is_active(InjectedFault::kNoAnswer) || !waiting_.empty();
  }

  class Port;  ///< one connection, from the side of the service

 private:
  friend class Port;
  std::string inventory();
  std::string answer_to(std::string_view path);
  /// Handles a message. Returns false if no answer follows yet.
  bool take_message(Port& port, std::string_view text);
  void take_setup(std::string_view text);
  void take_force(const Force& force);
  bool comes_to_wait(Port& port, std::string_view text);
  void check_newest(const Force& force);
  [[nodiscard]] const FaultWindow* window_of(InjectedFault fault) const noexcept;
  [[nodiscard]] std::int64_t done_at(std::int64_t from_ns) noexcept;
  void work_until(std::int64_t until_ns);
  void take_first();
  void take_waiting();
  void apply(const Force& force);
  void break_rule(std::string_view rule) {
    if (rule_.empty()) rule_ = rule;
  }
  [[nodiscard]] bool is_active(InjectedFault fault) const noexcept;
  void write_state(const tl::expected<PenSample, DeviceFault>& pen);
  void add_arm(const PenSample& shown, bool is_calibrated);
  void add_grip(const PenSample& shown);

  FakeWorld& world_;
  std::vector<FaultWindow> faults_;
  PlaneCalibration plane_;
  FakeServiceOptions options_;
  std::vector<Port*> ports_;
  std::int64_t now_ns_ = 0;
  std::int64_t received_ns_ = 0;
  std::string state_, instead_;
  std::string profile_, preset_;
  std::string rule_;
  Force asked_, applied_;
  Force sum_;  // sum over the messages since the last tick
  struct Waiting {
    Port* port;
    Force force;
    std::int64_t done_ns;  // time of the answer; INT64_MAX while the service is stalled
    bool is_taken;         // the service is working on it
  };
  std::vector<Waiting> waiting_;
  double largest_n_ = 0.0;
  Force newest_;
  std::size_t max_waiting_ = 0;
  double largest_rise_n_ = 0.0;
  std::int64_t busy_until_ns_ = 0;
  std::int64_t late_window_ns_ = -1;  // the window of the late answer that was already simulated
  bool owes_answer_ = false;          // for every second message
  int messages_ = 0, ignored_ = 0;
  bool is_there_ = true;  // the service sees the device
  bool is_silent_ = false;
  bool brakes_ = false;
};

/// The server's half of a connection to a client, without transport.
class FakeService::Port {
 public:
  Port(FakeService& service, bool is_events) : service_(&service), is_events_(is_events) {
    out_.reserve(kRoom);
    in_.reserve(kRoom);
    service.ports_.push_back(this);
  }
  ~Port();
  Port(const Port&) = delete;
  Port& operator=(const Port&) = delete;

  /// Accepts bytes from the client. Returns false if the connection was ended.
  bool take(std::span<const std::byte> bytes);
  /// Returns the bytes that the client has not read yet; the client erases them from the front.
  [[nodiscard]] std::string& out() noexcept { return out_; }
  [[nodiscard]] bool is_open() const noexcept { return is_open_; }
  [[nodiscard]] bool is_events() const noexcept { return is_events_; }
  [[nodiscard]] bool is_socket() const noexcept { return is_socket_; }
  /// Returns true if the request was a plain one and its answer is complete.
  [[nodiscard]] bool is_answered() const noexcept { return is_answered_; }
  void end() noexcept { is_open_ = false; }
  void say(std::string_view text);  ///< sends a text message

 private:
  friend class FakeService;
  static constexpr std::size_t kRoom = std::size_t{1} << 18;

  void take_request();
  bool take_frame();
  void take_payload(std::uint8_t opcode, std::string_view payload);
  void frame(std::uint8_t first, std::string_view payload);

  FakeService* service_;
  bool is_events_;
  bool is_open_ = true;
  bool is_socket_ = false;
  bool is_answered_ = false;
  bool was_set_up_ = false;  // its first message has arrived
  std::string in_, out_;
};

}  // namespace felt::haply
