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

/// What kind of service is faked.
struct FakeServiceOptions {
  std::string version = "3.4.2.0";
  std::string key = "values";  ///< the only name under which it takes a force
  std::string device_id = "049D";
  std::string type = "inverse3";
  std::string grip_family = "verse_grip";
  bool is_calibrated = true;
  int calibrates_after = 20;  ///< messages, when it is not
  bool has_power = true;
  bool has_gravity_compensation = true;
  bool has_events = true;
  bool shows_force = true;    ///< in current_cursor_force
  bool fragments = false;     ///< sends its messages in pieces, with pings between
  bool answers_once = false;  ///< one state for all messages that waited while it stood still
  /// How long a force holds when nothing comes. Of the real one only "returns to idle" is known.
  std::int64_t watchdog_ns = 20'000'000;
};

/// The Inverse Service as its pages describe it, with a simulated device behind: HTTP, the
/// WebSocket with one state for each message, forces that hold for one message, the events. It
/// enforces what the pages demand; the first rule that a client breaks is kept. One thread.
///
/// tick() reads the world, outside of the client's own tick; a message within it acts on the motors
/// at once, allocates nothing, and is answered with the state of that tick. Forces that come within
/// one tick add up. While it stands still (kNoAnswer) messages wait, as in a socket; the first tick
/// after that takes all of them, and their forces add up too. A service that is slow (kSlowAnswers)
/// takes one message after the other, each for so long; its force acts, and its answer goes, at the
/// end of that. One that works in bursts takes all that wait at once. An answer that is ready
/// within the time for which a client waits reaches it in the same tick.
class FakeService {
 public:
  FakeService(FakeWorld& world, std::vector<FaultWindow> faults, const PlaneCalibration& plane,
              FakeServiceOptions options = {});
  ~FakeService();

  void tick(std::int64_t now_ns);
  /// A connection to a port of it (10001 or 10020): for HaplyOptions::connect.
  Result<std::unique_ptr<ByteStream>> connect(const std::string& host, std::uint16_t port);
  /// An event for all who listen.
  void tell(std::string_view event);
  /// Ends all connections, as when the service is restarted.
  void hang_up();
  /// Says this in the place of states, until it is empty again.
  void say_instead(std::string text) { instead_ = std::move(text); }
  /// Takes messages, and says nothing.
  void be_silent(bool is_silent) { is_silent_ = is_silent; }

  [[nodiscard]] FakeServiceOptions& options() noexcept { return options_; }
  [[nodiscard]] double largest_asked_n() const noexcept { return largest_n_; }
  [[nodiscard]] std::string_view broken_rule() const noexcept { return rule_; }
  /// The last force of a message, in the service's axes, N.
  [[nodiscard]] const Force& asked() const noexcept { return asked_; }
  [[nodiscard]] int messages() const noexcept { return messages_; }
  [[nodiscard]] int ignored_forces() const noexcept { return ignored_; }
  /// Of the first message of the newest session; empty: none.
  [[nodiscard]] const std::string& profile() const noexcept { return profile_; }
  [[nodiscard]] const std::string& preset() const noexcept { return preset_; }
  [[nodiscard]] bool is_connected() const noexcept;
  /// The force of the newest message that has come, taken or not, in the service's axes, N.
  [[nodiscard]] const Force& newest_force() const noexcept { return newest_; }
  /// The largest number of messages that waited at one time, of those that were not taken yet.
  [[nodiscard]] std::size_t most_waiting() const noexcept { return most_waiting_; }
  /// The largest rise from one message to the next, N.
  [[nodiscard]] double largest_rise_n() const noexcept { return largest_rise_n_; }
  /// A client waits this long for an answer.
  void wait(std::int64_t within_ns) { work_until(now_ns_ + within_ns); }
  /// Messages wait: a force that was told to go may still act.
  [[nodiscard]] bool stands_still() const noexcept {
    return is_active(InjectedFault::kNoAnswer) || !waiting_.empty();
  }

  class Port;  ///< one connection, seen from this side

 private:
  friend class Port;
  std::string inventory();
  std::string answer_to(std::string_view path);
  /// The state that answers a message; false: none.
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
  std::int64_t heard_ns_ = 0;
  std::string state_, instead_;
  std::string profile_, preset_;
  std::string rule_;
  Force asked_, applied_;
  Force sum_;  // of the messages since the last tick
  struct Waiting {
    Port* port;
    Force force;
    std::int64_t done_ns;  // when it is answered; INT64_MAX: the service stands still
    bool is_taken;         // the service works on it
  };
  std::vector<Waiting> waiting_;
  double largest_n_ = 0.0;
  Force newest_;
  std::size_t most_waiting_ = 0;
  double largest_rise_n_ = 0.0;
  std::int64_t busy_until_ns_ = 0;
  std::int64_t late_window_ns_ = -1;  // the window of the late answer that has been
  bool owes_answer_ = false;          // of every second message
  int messages_ = 0, ignored_ = 0;
  bool is_there_ = true;  // the device, for the service
  bool is_silent_ = false;
  bool brakes_ = false;
};

/// What a client and the fake exchange: the server's half of a connection, without transport.
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

  /// Bytes of the client. False: the connection was ended.
  bool take(std::span<const std::byte> bytes);
  /// What the client has not taken yet; erased from the front.
  [[nodiscard]] std::string& out() noexcept { return out_; }
  [[nodiscard]] bool is_open() const noexcept { return is_open_; }
  [[nodiscard]] bool is_events() const noexcept { return is_events_; }
  [[nodiscard]] bool is_socket() const noexcept { return is_socket_; }
  /// It was a plain request, and its answer is all that comes.
  [[nodiscard]] bool is_answered() const noexcept { return is_answered_; }
  void end() noexcept { is_open_ = false; }
  void say(std::string_view text);  ///< a text message

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
  bool was_set_up_ = false;  // its first message has come
  std::string in_, out_;
};

}  // namespace felt::haply
