// The part of HapticMasterDevice that the edit thread runs: everything that moves the machine for
// the first time.
#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>

#include "felt/base/constants.h"
#include "felt/devices/hapticmaster/hapticmaster_device.h"
#include "felt/driver/text_writer.h"

namespace felt::hapticmaster {
namespace {

constexpr std::int64_t kEarlyNs = 10 * kMs;  // the guard must not have acted so soon in a trial
constexpr std::int64_t kInitPauseNs = 20 * kMs;
constexpr std::int64_t kInitNs = 60 * kSecond;   // for the machine to find its end stops
constexpr std::int64_t kStillNs = 10 * kSecond;  // it must move more often than this meanwhile
constexpr double kMovedM = 0.001;

constexpr const char* kNoGuard =
    "The second process, which switches the machine off if Feltline cannot, ";

// With a point, whatever the language of the program is.
std::string decimal(double number) {
  std::array<char, kMaxDecimal> room{};
  return {room.data(), append_decimal(room.data(), number)};
}

// Measures time on the edit thread: the time of the clock, or the sum of the pauses if that is
// longer (with the fakes of tests, pauses take no time).
class SearchTime {
 public:
  void paused(std::int64_t ns) noexcept { paused_ns_ += ns; }
  [[nodiscard]] std::int64_t elapsed_ns() const noexcept {
    return std::max(paused_ns_, 2 * kInitNs - until_.left_ns());
  }

 private:
  StreamDeadline until_{2 * kInitNs};
  std::int64_t paused_ns_ = 0;
};

}  // namespace

std::span<const std::byte> last_words(LastWords& room) noexcept {
  const std::size_t first = write_request("set state off", room);
  const std::size_t second = write_request("remove all", std::span(room).subspan(first));
  return std::span<const std::byte>(room).first(first + second);
}

Result<std::string> ask_controller(ControllerLink& link, std::string_view text) {
  const std::string asked = "\"" + std::string(text) + "\"";
  if (!link.send(text, HapticMasterDevice::kAskNs)) {
    return fail(ErrorCode::kIo, "The controller does not accept " + asked + ".");
  }
  const auto answer = link.receive(HapticMasterDevice::kAskNs);
  if (!answer && answer.error() == LinkFault::kBadData) {
    return fail(ErrorCode::kInvalidData,
                "The controller answers " + asked + " in a form that Feltline does not know.");
  }
  if (!answer) return fail(ErrorCode::kIo, "The controller does not answer " + asked + ".");
  std::string said(*answer);
  if (kind_of(said) == AnswerKind::kError) {
    return fail(ErrorCode::kUnsupported, "The controller answers " + asked + ": " + said);
  }
  return said;
}

// An answer that is missing would later be taken for that of another request, so the device is
// disconnected then.
Result<std::string> HapticMasterDevice::ask(std::string_view text) {
  if (mode_ == Mode::kGone) return fail(ErrorCode::kIo, "The controller has been disconnected.");
  Result<std::string> answer = ask_controller(*link_, text);
  if (!answer && answer.error().code != ErrorCode::kUnsupported) lose(answer.error().message, {});
  return answer;
}

Result<void> HapticMasterDevice::tell(std::string_view text) {
  if (guard_) guard_->beat();
  const Result<std::string> answer = ask(text);
  if (!answer) return tl::unexpected(answer.error());
  if (kind_of(*answer) == AnswerKind::kSentence) return {};
  return fail(ErrorCode::kInvalidData, "The controller does not confirm \"" + std::string(text) +
                                           "\", but answers: " + *answer);
}

// Waits, and notices a connection that ends meanwhile.
void HapticMasterDevice::pause(std::int64_t ns) {
  const auto answer = link_->receive(ns);
  if (answer) {
    lose("An answer that nobody asked for", *answer);
  } else if (answer.error() != LinkFault::kTimedOut) {
    lose("The controller closed the connection", {});
  }
}

// Waits for the answers to the requests of the loop.
Result<void> HapticMasterDevice::settle() {
  while (!queue_.empty() && mode_ != Mode::kGone) {
    if (!link_->receive(kAskNs)) lose("The controller does not answer", {});
    static_cast<void>(queue_.answered());
  }
  if (mode_ == Mode::kGone) return fail(ErrorCode::kIo, "The controller has been disconnected.");
  return {};
}

Result<void> HapticMasterDevice::start_guard() {
  guard_.reset();  // switches the machine off
  auto connection = connect_();
  if (!connection) {
    return fail(connection.error().code, std::string(kNoGuard) + "needs a connection of its own: " +
                                             connection.error().message + ".");
  }
  LastWords room;
  if (!(*connection)->keep_guard(last_words(room), kGuardNs)) {
    return fail(ErrorCode::kIo, std::string(kNoGuard) +
                                    "could not be started: this computer has too little memory or "
                                    "too many processes.");
  }
  guard_ = *std::move(connection);
  return {};
}

Result<void> HapticMasterDevice::expect_state(std::string_view expected) {
  const Result<std::string> state = ask("get state");
  if (!state) return tl::unexpected(state.error());
  if (*state == expected) return {};
  const char* const advice = expected == "off" ? "" : " Is its emergency button released?";
  return fail(ErrorCode::kIo, "The machine reports the state \"" + *state + "\" instead of \"" +
                                  std::string(expected) + "\"." + advice);
}

// Gives the guard a reason to act, in this state of the machine. An effect is created, and there is
// no sign of life after that. The effect is not enabled. The trial succeeds only if the effect is
// there until the guard may act, if it is not there 0.1 s later, which a second "create" confirms,
// and if the machine is off then. An error message alone proves nothing.
Result<void> HapticMasterDevice::prove_guard(std::string_view state) {
  const std::string create = "create biasforce " + std::string(text_of(effect_));
  const std::string look = "set " + std::string(text_of(effect_)) + " disable";
  if (auto done = expect_state(state); !done) return done;
  if (auto done = tell(create); !done) return done;
  if (auto done = tell(look); !done) return done;  // the last sign of life
  pause(kEarlyNs);
  const bool was_there = ask(look).has_value();
  pause(kMaxGuardNs - kEarlyNs);
  const bool is_there = ask(look).has_value();
  const bool is_off = expect_state("off").has_value();
  const bool is_created_again = tell(create).has_value();
  if (was_there && !is_there && is_off && is_created_again && guard_->is_guarded()) {
    return tell("remove all");
  }
  return fail(ErrorCode::kIo, std::string(kNoGuard) +
                                  "did not switch it off within 0.1 s in a trial. No force is "
                                  "possible.");
}

Result<void> HapticMasterDevice::calibrate_force() {
  const Result<std::string> has_force = ask("get force_calibrated");
  if (!has_force) return tl::unexpected(has_force.error());
  if (*has_force == "true") return {};
  if (auto done = tell("calibrateforcesensor"); !done) return done;
  const Result<std::string> is_done = ask("get force_calibrated");
  if (!is_done) return tl::unexpected(is_done.error());
  if (*is_done == "true") return {};
  return fail(ErrorCode::kIo, "The machine did not calibrate its force sensor. Do not touch it.");
}

// Gives the guard signs of life while the machine looks for its end stops: at most for kInitNs, and
// only as long as it says that it searches, and moves.
Result<void> HapticMasterDevice::find_end_stops() {
  const Result<std::string> has_position = ask("get position_calibrated");
  if (!has_position) return tl::unexpected(has_position.error());
  if (*has_position == "true") return {};
  if (auto done = tell("set state init"); !done) return done;
  SearchTime time;
  std::optional<Vec3> at_m;
  std::int64_t moved_ns = 0;
  while (mode_ != Mode::kGone && time.elapsed_ns() < kInitNs) {
    guard_->beat();
    pause(kInitPauseNs);
    time.paused(kInitPauseNs);
    const Result<std::string> state = ask("get state"), is_done = ask("get position_calibrated");
    if (state && is_done && *state == "stop" && *is_done == "true") return {};
    if (!state || (*state != "stop" && *state != "init")) break;
    const Result<std::string> answer = ask("get measpos");
    const std::optional<Vec3> now_m = answer ? read_vector(*answer) : std::nullopt;
    if (now_m && (!at_m || norm(*now_m - *at_m) > kMovedM)) {
      at_m = now_m;
      moved_ns = time.elapsed_ns();
    }
    if (time.elapsed_ns() - moved_ns > kStillNs) break;
  }
  return fail(ErrorCode::kIo,
              "The machine did not find its end stops. Is its emergency button released?");
}

// The state `force`, in which the machine follows the hand, and one effect without force.
Result<void> HapticMasterDevice::create_effect() {
  const std::string name(text_of(effect_));
  for (const std::string& text : {std::string("remove all"), "create biasforce " + name,
                                  "set " + name + " force [0.000000,0.000000,0.000000]",
                                  std::string("set state force"), "set " + name + " enable"}) {
    if (auto done = tell(text); !done) return done;
  }
  return expect_state("force");
}

std::string HapticMasterDevice::homing_words() {
  if (mode_ == Mode::kReady) return {};
  return "Read docs/devices/hapticmaster.md before you agree: this machine can push with 250 N, "
         "nobody has tried it with Feltline, and no limit of Feltline has met its motors. It is "
         "switched on, moves to its end stops if it has to, and then follows the hand. Keep its "
         "emergency button in your other hand. Do not touch the handle until it is ready.";
}

Result<void> HapticMasterDevice::prepare() {
  if (auto done = settle(); !done) return done;
  if (auto done = start_guard(); !done) return done;
  for (const char* const text : {"set state off", "remove all"}) {  // whoever used it before
    if (auto done = tell(text); !done) return done;
  }
  effect_ = new_effect_name();
  if (auto done = prove_guard("off"); !done) return done;
  if (auto done = calibrate_force(); !done) return done;
  if (auto done = find_end_stops(); !done) return done;
  for (const std::string& text :
       {"set inertia " + decimal(kInertiaKg), "set coulombfriction " + decimal(kFrictionN),
        std::string("set state force")}) {
    if (auto done = tell(text); !done) return done;
  }
  // The second trial: now the machine is in the state that the guard must end.
  if (auto done = prove_guard("force"); !done) return done;
  return create_effect();
}

// Asks the machine to switch off until it says that it is off. Fails if it has not done so after
// kOffKnownNs, or if the controller does not answer.
Result<void> HapticMasterDevice::ensure_off() {
  static_cast<void>(settle());
  SearchTime time;
  while (mode_ != Mode::kGone && time.elapsed_ns() < kOffKnownNs) {
    static_cast<void>(ask("set state off"));
    const Result<std::string> state = ask("get state");
    if (state && *state == "off") return {};
    if (guard_) guard_->let_guard_speak();
    pause(kOffAskedNs);
    time.paused(kOffAskedNs);
  }
  return fail(ErrorCode::kIo, std::string(kNotOff));
}

Result<void> HapticMasterDevice::shut_down() {
  Result<void> off = ensure_off();
  if (mode_ != Mode::kGone) static_cast<void>(ask("remove all"));
  guard_.reset();
  return off;
}

Result<void> HapticMasterDevice::find_home() {
  if (mode_ == Mode::kReady) {
    static_cast<void>(release());
    mode_ = Mode::kNotReady;
  }
  is_in_force_ = has_sample_ = is_off_pending_ = false;
  report_.clear_stop();
  if (auto done = prepare(); !done) {
    const Result<void> off = shut_down();
    if (mode_ != Mode::kGone) mode_words_ = ShortText(off ? kNotPrepared : kNotOff);
    return off ? done : fail(done.error().code, done.error().message + " " + off.error().message);
  }
  gate_.release();
  is_release_pending_ = is_resting_ = false;
  watch_.restart();
  motion_.restart();
  report_.restart_pace();
  time_.restart();  // the loop begins at any time
  is_in_force_ = true;
  mode_ = Mode::kReady;
  guard_->let_guard_rest();
  return {};
}

}  // namespace felt::hapticmaster
