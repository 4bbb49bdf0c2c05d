// The part of HapticMasterDevice that the edit thread runs: everything that moves the machine for
// the first time.
#include <span>
#include <string>

#include "felt/base/constants.h"
#include "felt/devices/hapticmaster/hapticmaster_device.h"

namespace felt::hapticmaster {
namespace {

constexpr std::int64_t kPauseNs = 10 * kMs;  // between two looks while the guard is to speak
constexpr std::int64_t kInitPauseNs = 20 * kMs;
constexpr int kInitTries = 3000;  // a minute for the machine to find its end stops

constexpr const char* kNoGuard =
    "The second process, which switches the machine off if Feltline cannot, ";

std::string create_text() {
  return "create biasforce " + std::string(kEffect);
}
std::string effect_text(std::string_view what) {
  return "set " + std::string(kEffect) + " " + std::string(what);
}

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
  if (is_gone_) return fail(ErrorCode::kIo, "The controller has been disconnected.");
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
  while (!queue_.empty() && !is_gone_) {
    if (!link_->receive(kAskNs)) lose("The controller does not answer", {});
    static_cast<void>(queue_.answered());
  }
  if (is_gone_) return fail(ErrorCode::kIo, "The controller has been disconnected.");
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

// Creates the effect, gives no sign of life, and expects that the guard removes the effect and
// switches the machine off. The effect is not enabled.
Result<void> HapticMasterDevice::prove_guard() {
  if (auto done = tell(create_text()); !done) return done;
  for (std::int64_t ns = 0; ns < kMaxGuardNs && !is_gone_; ns += kPauseNs) {
    pause(kPauseNs);
    const Result<std::string> answer = ask(effect_text("disable"));
    if (answer || is_gone_) continue;  // the effect is still there
    const Result<std::string> state = ask("get state");
    if (state && *state == "off" && guard_->is_guarded()) return {};
    break;
  }
  return fail(ErrorCode::kIo, std::string(kNoGuard) +
                                  "did not switch it off within 0.1 s in a trial. No force is "
                                  "possible.");
}

// Lets the machine find its end stops and its zero force, if it has not done so since it was
// started.
Result<void> HapticMasterDevice::calibrate() {
  const Result<std::string> has_force = ask("get force_calibrated");
  if (!has_force) return tl::unexpected(has_force.error());
  if (*has_force != "true") {
    if (auto done = tell("calibrateforcesensor"); !done) return done;
    const Result<std::string> is_done = ask("get force_calibrated");
    if (!is_done) return tl::unexpected(is_done.error());
    if (*is_done != "true") {
      return fail(ErrorCode::kIo,
                  "The machine did not calibrate its force sensor. Do not touch it.");
    }
  }
  const Result<std::string> has_position = ask("get position_calibrated");
  if (!has_position) return tl::unexpected(has_position.error());
  if (*has_position == "true") return {};
  if (auto done = tell("set state init"); !done) return done;
  for (int i = 0; i < kInitTries && !is_gone_; ++i) {
    guard_->beat();
    pause(kInitPauseNs);
    const Result<std::string> state = ask("get state"), is_done = ask("get position_calibrated");
    if (state && is_done && *state == "stop" && *is_done == "true") return {};
    if (state && *state == "off") break;
  }
  return fail(ErrorCode::kIo,
              "The machine did not find its end stops. Is its emergency button released?");
}

// The state `force`, in which the machine follows the hand, and one effect without force.
Result<void> HapticMasterDevice::create_effect() {
  for (const std::string& text :
       {std::string("remove all"), create_text(), effect_text("force [0.000000,0.000000,0.000000]"),
        std::string("set state force"), effect_text("enable")}) {
    if (auto done = tell(text); !done) return done;
  }
  const Result<std::string> state = ask("get state");
  if (!state) return tl::unexpected(state.error());
  if (*state != "force") {
    return fail(ErrorCode::kIo, "The machine reports the state \"" + *state +
                                    "\" instead of \"force\". Is its emergency button released?");
  }
  return {};
}

std::string HapticMasterDevice::homing_words() {
  if (is_home_) return {};
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
  if (auto done = prove_guard(); !done) return done;
  if (auto done = calibrate(); !done) return done;
  for (const std::string& text :
       {"set inertia " + std::to_string(kInertiaKg), std::string("set coulombfriction 0.0"),
        std::string("set state force")}) {
    if (auto done = tell(text); !done) return done;
  }
  // The second trial: now the machine is in the state that the guard must end.
  if (auto done = prove_guard(); !done) return done;
  return create_effect();
}

void HapticMasterDevice::switch_off() {
  if (!is_gone_) {
    static_cast<void>(ask("set state off"));
    static_cast<void>(ask("remove all"));
  }
  guard_.reset();
}

Result<void> HapticMasterDevice::find_home() {
  is_home_ = is_in_force_ = has_sample_ = false;
  force_stopped_.reset();
  release();
  if (auto done = prepare(); !done) {
    switch_off();
    return done;
  }
  gate_.release();
  positions_ = 0;
  pace_ = ServicePace(descriptor_.capabilities.period_ns);
  pace_words_.reset();
  is_in_force_ = is_home_ = true;
  guard_->let_guard_rest();  // the loop begins at any time
  return {};
}

}  // namespace felt::hapticmaster
