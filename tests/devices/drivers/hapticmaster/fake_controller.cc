#include "tests/devices/drivers/hapticmaster/fake_controller.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "felt/base/constants.h"
#include "tests/devices/drivers/hapticmaster/fake_stream.h"

namespace felt::hapticmaster {
namespace {

constexpr std::size_t kHeader = 8;
constexpr std::size_t kRoom = std::size_t{1} << 16;
// Requests that may be unanswered at the same time: those of the loop, and two when it is closed.
constexpr std::size_t kMaxWaiting = 8;
constexpr double kMaxN = 250.0;
constexpr std::string_view kNoSuch = "--- ERROR: unknown effect";
constexpr std::string_view kUnknown = "--- ERROR: unknown command";

bool take_word(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return false;
  text.remove_prefix(word.size());
  return true;
}

std::optional<Vec3> vector_of(std::string_view text) {
  std::array<double, 3> v{};
  if (!take_word(text, "[") || text.find(' ') != std::string_view::npos) return std::nullopt;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), v[i]);
    if (error != std::errc{}) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (!take_word(text, i < 2 ? "," : "]")) return std::nullopt;
  }
  if (!text.empty()) return std::nullopt;
  return Vec3{v[0], v[1], v[2]};
}

}  // namespace

FakeController::Port::Port(FakeController& controller) : controller_(&controller) {
  in_.reserve(kRoom);
  out_.reserve(kRoom);
  held_.reserve(kRoom);
  controller.ports_.push_back(this);
}

FakeController::Port::~Port() {
  if (controller_ == nullptr) return;
  std::erase(controller_->ports_, this);
  std::erase_if(controller_->waiting_, [this](const Waiting& w) { return w.port == this; });
}

void FakeController::Port::say(std::string_view text) {
  if (!is_open_ || controller_ == nullptr) return;
  std::string& to = controller_->is_active(InjectedFault::kNoAnswer) ? held_ : out_;
  if (to.size() + text.size() + kHeader + 4 > kRoom) return;
  const bool quotes = controller_->options_.quotes;
  const std::size_t size = text.size() + (quotes ? 2 : 1);
  const std::array<char, kHeader> header{
      0, 0, static_cast<char>(size >> 8), static_cast<char>(size & 0xFF), 1, 0, 0, 0};
  to.append(header.data(), header.size());
  if (quotes) to += '"';
  to.append(text);
  to += quotes ? '"' : ';';
}

// Returns false if the connection was ended.
bool FakeController::Port::take(std::span<const std::byte> bytes) {
  in_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  while (is_open_ && controller_ != nullptr && in_.size() >= kHeader) {
    const auto size = static_cast<std::size_t>(static_cast<unsigned char>(in_[3]));
    for (std::size_t i = 0; i < kHeader; ++i) {
      if (i != 3 && in_[i] != 0) {
        controller_->break_rule("a header that is not a length and zeros");
      }
    }
    if (in_.size() < kHeader + size) break;
    std::array<char, 256> text{};
    std::copy_n(in_.begin() + kHeader, size, text.begin());
    in_.erase(0, kHeader + size);
    controller_->accept(*this, {text.data(), size});
  }
  return is_open_;
}

void FakeController::Port::act_as_guard() {
  has_beaten_ = false;
  if (controller_ == nullptr || !is_open_ || controller_->options_.ignores_guard) return;
  ++controller_->guard_acts_;
  take(std::as_bytes(std::span(last_words_)));
  out_.clear();  // the guard discards the answers
}

FakeController::FakeController(FakeWorld& world, std::vector<FaultWindow> faults,
                               const PlaneCalibration& plane, FakeControllerOptions options)
    : world_(world), faults_(std::move(faults)), plane_(plane), options_(std::move(options)) {
  ports_.reserve(16);
  waiting_.reserve(64);
  state_.reserve(32);
  tick(0);
}

FakeController::~FakeController() {
  for (Port* const port : ports_) {
    port->controller_ = nullptr;
    port->is_open_ = false;
  }
}

Result<std::unique_ptr<ByteStream>> FakeController::connect(const std::string& host,
                                                            std::uint16_t port) {
  const std::string where = host + ":" + std::to_string(port);
  const bool is_full = static_cast<int>(ports_.size()) >= options_.max_connections;
  if (!is_there_ || is_full || !pen_) {
    return fail(ErrorCode::kIo, where + ": Connection timed out");
  }
  return std::make_unique<FakeStream>(*this);
}

const FaultWindow* FakeController::window_of(InjectedFault fault) const noexcept {
  for (const FaultWindow& w : faults_) {
    if (w.fault == fault && now_ns_ >= w.from_ns && now_ns_ < w.until_ns) return &w;
  }
  return nullptr;
}

void FakeController::say_instead(std::string text, std::string request, int count, int skip) {
  instead_ = std::move(text);
  instead_of_ = std::move(request);
  insteads_ = count;
  skips_ = skip;
}

void FakeController::say_unasked(std::string_view text) {
  for (Port* const port : ports_) {
    if (!port->is_guard_alive_) port->say(text);
  }
}

void FakeController::babble(std::string_view bytes) {
  for (Port* const port : ports_) port->out_.append(bytes);
}

void FakeController::hang_up() noexcept {
  for (Port* const port : ports_) {
    if (!port->is_guard_alive_) port->is_open_ = false;
  }
  waiting_.clear();
}

void FakeController::hang_up_guard() noexcept {
  for (Port* const port : ports_) {
    if (port->is_guard_alive_) port->is_open_ = false;
  }
}

int FakeController::effects() const noexcept {
  return static_cast<int>(
      std::count_if(effects_.begin(), effects_.end(), [](const Effect& e) { return e.exists; }));
}

void FakeController::tick(std::int64_t now_ns) {
  now_ns_ = now_ns;
  idle_ns_ = 0;
  pen_ = world_.device().read(now_ns);
  is_there_ = !is_active(InjectedFault::kUnplugged);
  if (!is_there_) {  // it has lost its power
    hang_up();
    hang_up_guard();
    remove_all();
    enter("off");
  } else if (!pen_ && pen_.error() == DeviceFault::kDisconnected) {
    hang_up();
  }
  if (is_active(InjectedFault::kForcesOff) && state_ == "force") {
    enter("stop");
    was_stopped_ = true;
  } else if (was_stopped_ && !is_active(InjectedFault::kForcesOff)) {
    if (state_ == "stop") enter("force");  // somebody pressed the button at the machine
    was_stopped_ = false;
  }
  if (!is_active(InjectedFault::kNoAnswer)) {
    for (Port* const port : ports_) {
      port->out_.append(port->held_);
      port->held_.clear();
    }
  }
  if (options_.guard_watches_ticks) watch_guards();
  work_until(now_ns);
}

// The driver waits this long; the guards' time passes, too.
void FakeController::pass_time(std::int64_t ns) {
  work_until(now_ns_ + ns);
  const bool is_short = ns < 5 * kMs;  // in the loop, time passes with the ticks
  if (is_short || ns >= kSecond) return;
  idle_ns_ += ns;
  if (options_.gives_up_force && state_ == "force") enter("off");
  watch_guards();
}

void FakeController::watch_guards() {
  for (std::size_t i = 0; i < ports_.size(); ++i) {
    Port& port = *ports_[i];
    const std::int64_t silent_ns = now_ns_ + idle_ns_ - port.beat_ns_;
    const bool acts = port.is_guard_alive_ && port.has_beaten_ && silent_ns >= port.patience_ns_;
    if (acts) port.act_as_guard();
  }
}

std::int64_t FakeController::done_at() noexcept {
  const std::int64_t begin_ns = std::max(now_ns_, busy_until_ns_);
  const auto ms = [](double amount) { return static_cast<std::int64_t>(1e6 * amount); };
  if (const auto* slow = window_of(InjectedFault::kSlowAnswers)) return begin_ns + ms(slow->amount);
  if (const auto* burst = window_of(InjectedFault::kBurstAnswers)) {
    const std::int64_t every_ns = std::max<std::int64_t>(1, ms(burst->amount));
    return burst->from_ns + ((now_ns_ - burst->from_ns) / every_ns + 1) * every_ns;
  }
  const auto* const late = window_of(InjectedFault::kLateAnswer);
  if (late != nullptr && late->from_ns != late_window_ns_) {
    late_window_ns_ = late->from_ns;
    return begin_ns + ms(late->amount);
  }
  return begin_ns;
}

// A request arrives. It is handled immediately unless the controller is busy.
void FakeController::accept(Port& port, std::string_view text) {
  ++requests_;
  Waiting request{.port = &port, .size = std::min<std::size_t>(text.size(), 255)};
  std::copy_n(text.begin(), request.size, request.text.begin());
  if (const std::size_t at = text.find(" force ["); at != std::string_view::npos) {
    const auto force = vector_of(text.substr(at + 7));
    if (force) newest_ = {force->x, force->y, force->z};
    request.bears_force = force && norm(*force) > 0.0;
    const bool waits_already = std::any_of(waiting_.begin(), waiting_.end(),
                                           [](const Waiting& w) { return w.bears_force; });
    if (request.bears_force && waits_already) break_rule("two forces wait in the socket");
  }
  request.done_ns = port.is_guard_alive_ ? now_ns_ : done_at();
  if (!port.is_guard_alive_) busy_until_ns_ = request.done_ns;
  if (is_stalled_ && !port.is_guard_alive_) {
    request.done_ns = std::numeric_limits<std::int64_t>::max();
  }
  if (request.done_ns <= now_ns_ && (waiting_.empty() || port.is_guard_alive_)) {
    return handle(port, text);
  }
  waiting_.push_back(request);
  max_waiting_ = std::max(max_waiting_, waiting_.size());
  if (waiting_.size() > kMaxWaiting) break_rule("requests pile up");
}

void FakeController::work_until(std::int64_t until_ns) {
  while (!waiting_.empty() && waiting_.front().done_ns <= until_ns) {
    const Waiting first = waiting_.front();
    waiting_.erase(waiting_.begin());
    handle(*first.port, {first.text.data(), first.size});
  }
  // The clock was set back: nothing waits for the old time.
  if (busy_until_ns_ > now_ns_ + kSecond) {
    busy_until_ns_ = now_ns_;
    for (Waiting& waiting : waiting_) waiting.done_ns = std::min(waiting.done_ns, now_ns_);
  }
}

void FakeController::handle(Port& port, std::string_view text) {
  const bool is_of_other = has_remote_guard_ && &port != ports_.front();
  if (is_of_other && text == "remove all" && effects() > 0) ++guard_acts_;
  const std::string_view answer = answer_to(text);
  if (is_silent_) return;
  if (is_active(InjectedFault::kLostAnswers)) {
    owes_answer_ = !owes_answer_;
    if (owes_answer_) return;
  }
  const bool is_meant = insteads_ > 0 && !port.is_guard_alive_ && text.starts_with(instead_of_);
  if (is_meant && skips_-- <= 0) {
    --insteads_;
    return port.say(instead_);
  }
  port.say(answer);
}

std::string_view FakeController::answer_to(std::string_view text) {
  if (take_word(text, "get ")) return answer_to_get(text);
  if (take_word(text, "set ")) return answer_to_set(text);
  if (take_word(text, "create biasforce ")) return create(text);
  if (text == "remove all") {
    if (!options_.keeps_effects) remove_all();
    return "All effects removed";
  }
  if (text == "calibrateforcesensor") {
    if (state_ == "force") break_rule("the force sensor is calibrated while a hand may pull");
    options_.is_force_calibrated = true;
    return "Force sensor calibrated";
  }
  break_rule("a command that no public client uses");
  return kUnknown;
}

std::string_view FakeController::vector_text(const Vec3& v) {
  char* at = room_.data();
  *at++ = '[';
  for (const double number : {v.x, v.y, v.z}) {
    if (at != room_.data() + 1) *at++ = ',';
    at = std::isfinite(number) ? std::to_chars(at, at + 32, std::clamp(number, -1e9, 1e9),
                                               std::chars_format::fixed, 7)
                                     .ptr
                               : std::copy_n("nan", 3, at);
  }
  *at++ = ']';
  return {room_.data(), static_cast<std::size_t>(at - room_.data())};
}

std::string_view FakeController::answer_to_get(std::string_view what) {
  if (what == "state") {
    if (state_ == "init" && ++looks_ >= options_.init_looks) {
      options_.is_position_calibrated = true;
      enter("stop");
    }
    return state_;
  }
  if (what == "measpos") {
    if (!pen_) return "--- ERROR: position is not calibrated";
    return vector_text(kMPerMm * plane_.to_device(pen_->position));
  }
  if (what == "modelvel") {
    if (!pen_) return "--- ERROR: position is not calibrated";
    return vector_text(kMPerMm * plane_.turn_to_device(pen_->velocity));
  }
  if (what == "workspace_r") return options_.workspace_r;
  if (what == "workspace_phi") return "[-0.4,0.0,0.4]";
  if (what == "workspace_z") return "[-0.2,0.0,0.2]";
  if (what == "force_calibrated") return options_.is_force_calibrated ? "true" : "false";
  if (what == "position_calibrated") return options_.is_position_calibrated ? "true" : "false";
  break_rule("a value that no public client asks for");
  return kUnknown;
}

void FakeController::enter(std::string_view state) {
  state_ = state;
  if (state_ == "off") newest_ = {};
  static_cast<void>(apply());
}

std::string_view FakeController::answer_to_set(std::string_view what) {
  if (take_word(what, "state ")) {
    const bool is_known = what == "init" || what == "off" || what == "force" ||
                          what == "position" || what == "home" || what == "stop";
    if (!is_known) return kUnknown;
    if (what != "off" && options_.has_emergency) return "--- ERROR: emergency button is pressed";
    if (what == "force" && !(options_.is_position_calibrated && options_.is_force_calibrated)) {
      break_rule("the state force before the machine is calibrated");
      return "--- ERROR: not calibrated";
    }
    if (what == "init") looks_ = 0;
    int& ignored = state_ == "init" ? options_.ignored_offs_in_init : options_.ignored_offs;
    if (what == "off" && ignored > 0) {
      --ignored;
      return "state set to 'off'";
    }
    enter(what);
    char* at = std::copy_n("state set to '", 14, room_.data());
    at = std::copy(state_.begin(), state_.end(), at);
    *at++ = '\'';
    return {room_.data(), static_cast<std::size_t>(at - room_.data())};
  }
  if (take_word(what, "inertia ")) {
    std::from_chars(what.data(), what.data() + what.size(), inertia_kg_);
    if (inertia_kg_ < 2.0) break_rule("an inertia that no public client dares");
    return "Inertia set";
  }
  if (take_word(what, "coulombfriction ")) {
    std::from_chars(what.data(), what.data() + what.size(), friction_n_);
    return "Coulomb friction set";
  }
  const std::size_t blank = what.find(' ');
  if (blank == std::string_view::npos) return kUnknown;
  return set_effect(what.substr(0, blank), what.substr(blank + 1));
}

FakeController::Effect* FakeController::find(std::string_view name) noexcept {
  for (Effect& effect : effects_) {
    if (effect.exists && name == effect.name.data()) return &effect;
  }
  return nullptr;
}

std::string_view FakeController::create(std::string_view what) {
  if (find(what) != nullptr && options_.creates_twice) return "Effect biasforce created";
  if (find(what) != nullptr) return "--- ERROR: the effect exists already";
  for (Effect& effect : effects_) {
    if (effect.exists) continue;
    effect = {};
    effect.exists = true;
    std::copy_n(what.begin(), std::min(what.size(), effect.name.size() - 1), effect.name.begin());
    return "Effect biasforce created";
  }
  return "--- ERROR: too many effects";
}

std::string_view FakeController::set_effect(std::string_view name, std::string_view what) {
  Effect* const effect = find(name);
  if (effect == nullptr) return kNoSuch;
  if (take_word(what, "force ")) return set_bias(*effect, what);
  if (what != "enable" && what != "disable") return kUnknown;
  effect->is_enabled = what == "enable";
  const bool has_guard =
      has_remote_guard_ || std::any_of(ports_.begin(), ports_.end(),
                                       [](const Port* port) { return port->is_guard_alive_; });
  if (effect->is_enabled && !has_guard) break_rule("an effect is enabled without a guard");
  if (effect->is_enabled && guard_acts_ < 2) break_rule("an effect is enabled before a trial");
  if (effect->is_enabled && norm(effect->force) > 0.0) break_rule("an effect begins with a force");
  static_cast<void>(apply());
  return effect->is_enabled ? "Effect enabled now" : "Effect disabled now";
}

std::string_view FakeController::set_bias(Effect& effect, std::string_view vector) {
  const auto asked = vector_of(vector);
  if (!asked) {
    break_rule("a force that is not [x,y,z]");
    largest_n_ = kInf;
    return "--- ERROR: not a vector";
  }
  largest_n_ = std::max(largest_n_, is_finite(*asked) ? norm(*asked) : kInf);
  if (!(norm(*asked) <= kMaxN)) return "--- ERROR: force out of range";
  const Force before = effect.force;
  effect.force = {asked->x, asked->y, asked->z};
  if (apply()) return "Bias force's force set";
  effect.force = before;
  return "--- ERROR: force could not be set";
}

void FakeController::remove_all() noexcept {
  for (Effect& effect : effects_) effect = {};
  newest_ = {};
  static_cast<void>(apply());
}

// Applies the sum of the enabled effects in the state `force`. Returns false if the machine reports
// an error (kWriteError) and keeps the last force. It lets go even if it reports an error.
bool FakeController::apply() {
  Force sum;
  for (const Effect& effect : effects_) {
    if (effect.exists && effect.is_enabled && state_ == "force") sum += effect.force;
  }
  if (sum == Force{}) {
    world_.device().stop();
    return !is_active(InjectedFault::kWriteError);
  }
  const Vec3 turned = plane_.turn_to_page(Vec3{sum.x, sum.y, sum.z});
  return world_.device().write({turned.x, turned.y, turned.z}).has_value() ||
         !is_active(InjectedFault::kWriteError);
}

}  // namespace felt::hapticmaster
