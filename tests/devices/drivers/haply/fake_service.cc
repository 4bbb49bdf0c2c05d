#include "tests/devices/drivers/haply/fake_service.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>

#include "felt/base/constants.h"
#include "felt/devices/haply/web_socket_key.h"
#include "felt/haptics/safety/safety_stages.h"

namespace felt::haply {
namespace {

using Json = nlohmann::json;

constexpr std::uint16_t kControlPort = 10001, kEventsPort = 10020;
constexpr std::string_view kGripId = "61548";

// Every tick of every test writes the state, so its text is assembled by hand.
void add_number(std::string& text, double number) {
  std::array<char, 32> digits{};
  if (!std::isfinite(number)) {
    text += "null";
    return;
  }
  const char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
  text.append(digits.data(), static_cast<std::size_t>(end - digits.data()));
}
/// Adds a member of an object. The first member has no comma before it.
void add_member(std::string& text, std::string_view name, double number) {
  if (text.back() != '{') text += ',';
  text.append("\"").append(name).append("\":");
  add_number(text, number);
}
void add_vector(std::string& text, double x, double y, double z) {
  text += '{';
  add_member(text, "x", x);
  add_member(text, "y", y);
  add_member(text, "z", z);
  text += '}';
}
std::string_view word(bool is_so) {
  return is_so ? "true" : "false";
}

// Returns the shortest rotation {w, x, y, z} from (0, 1, 0) to this unit vector.
std::array<double, 4> turn_of_y_to(const Vec3& to) {
  const double size = std::sqrt(2.0 * (1.0 + to.y));
  if (!(size > 1e-6)) return {0.0, 1.0, 0.0, 0.0};
  return {(1.0 + to.y) / size, to.z / size, 0.0, -to.x / size};
}

// The driver's end of the stream.
class ClientEnd final : public ByteStream {
 public:
  ClientEnd(FakeService& service, bool is_events) : service_(&service), port_(service, is_events) {}

  // A test without memory may end here: NOLINTNEXTLINE(bugprone-exception-escape)
  tl::expected<void, StreamFault> send(std::span<const std::byte> bytes,
                                       std::int64_t) noexcept override {
    if (!port_.is_open() || !port_.take(bytes)) return tl::unexpected(StreamFault::kClosed);
    return {};
  }
  tl::expected<std::size_t, StreamFault> receive(std::span<std::byte> room,
                                                 std::int64_t within_ns) noexcept override {
    std::string& out = port_.out();
    if (out.empty() && port_.is_open() && !port_.is_events()) service_->wait(within_ns);
    if (out.empty()) {
      return tl::unexpected(port_.is_open() && !port_.is_answered() ? StreamFault::kTimedOut
                                                                    : StreamFault::kClosed);
    }
    const std::size_t count = std::min(room.size(), out.size());
    std::copy_n(std::as_bytes(std::span(out)).begin(), count, room.begin());
    out.erase(0, count);
    return count;
  }

 private:
  FakeService* service_;
  FakeService::Port port_;
};

// Returns the numbers after `key` in a command that a client writes each tick, without allocating.
// Returns nullopt if the command has another form.
std::optional<Force> force_in(std::string_view text, std::string_view key) {
  const std::size_t begin = text.find("\"" + std::string(key) + "\":{");
  if (begin == std::string_view::npos) return std::nullopt;
  Force force;
  for (double* const axis : {&force.x, &force.y, &force.z}) {
    const std::string_view name = axis == &force.x   ? "\"x\":"
                                  : axis == &force.y ? "\"y\":"
                                                     : "\"z\":";
    const std::size_t at = text.find(name, begin);
    *axis = std::numeric_limits<double>::quiet_NaN();
    if (at == std::string_view::npos) continue;
    const char* const from = text.data() + at + name.size();
    std::from_chars(from, text.data() + text.size(), *axis);
  }
  return force;
}

}  // namespace

FakeService::FakeService(FakeWorld& world, std::vector<FaultWindow> faults,
                         const PlaneCalibration& plane, FakeServiceOptions options)
    : world_(world), faults_(std::move(faults)), plane_(plane), options_(std::move(options)) {
  waiting_.reserve(1024);
  tick(0);
}

FakeService::~FakeService() {
  for (Port* port : ports_) {
    port->service_ = nullptr;
    port->end();
  }
}

FakeService::Port::~Port() {
  if (service_ == nullptr) return;
  std::erase(service_->ports_, this);
  std::erase_if(service_->waiting_, [this](const Waiting& one) { return one.port == this; });
  if (is_socket_ && !is_events_) service_->world_.device().stop();  // the session is over
}

bool FakeService::is_connected() const noexcept {
  return std::any_of(ports_.begin(), ports_.end(),
                     [](const Port* port) { return port->is_socket() && port->is_open(); });
}

const FaultWindow* FakeService::window_of(InjectedFault fault) const noexcept {
  for (const FaultWindow& window : faults_) {
    const bool is_now = now_ns_ >= window.from_ns && now_ns_ < window.until_ns;
    if (window.fault == fault && is_now) return &window;
  }
  return nullptr;
}

bool FakeService::is_active(InjectedFault fault) const noexcept {
  return window_of(fault) != nullptr;
}

Result<std::unique_ptr<ByteStream>> FakeService::connect(const std::string& host,
                                                         std::uint16_t port) {
  const bool is_events = port == kEventsPort;
  if (port != kControlPort && !(is_events && options_.has_events)) {
    return fail(ErrorCode::kNotFound, host + ":" + std::to_string(port) + ": Connection refused");
  }
  return std::make_unique<ClientEnd>(*this, is_events);
}

void FakeService::hang_up() {
  waiting_.clear();
  for (Port* port : ports_) port->end();
  world_.device().stop();
}

void FakeService::report(std::string_view event) {
  for (Port* port : ports_) {
    if (port->is_events() && port->is_socket()) port->say(event);
  }
}

void FakeService::write_state(const tl::expected<PenSample, DeviceFault>& pen) {
  const bool is_gone = !pen && pen.error() == DeviceFault::kDisconnected;
  const bool is_lost = !pen && pen.error() == DeviceFault::kNotCalibrated;
  if (is_gone && is_there_) {
    report(R"({"name":"device-disconnected","category":"device","level":"warning","data":)"
           R"({"device_family":"inverse","device_id":")" +
           options_.device_id + R"("},"message":"Device )" + options_.device_id + R"( was lost"})");
  }
  is_there_ = !is_gone;
  if (is_gone) {
    state_ = R"({"inverse3":[],"session_id":7,"verse_grip":[]})";
    return;
  }
  const PenSample shown = pen.value_or(PenSample{});
  state_ = R"({"inverse3":[)";
  add_arm(shown, options_.is_calibrated && !is_lost);
  state_.append(R"(],"session_id":7,")").append(options_.grip_family).append(R"(":[)");
  add_grip(shown);
  state_ += "]}";
}

void FakeService::add_arm(const PenSample& shown, bool is_calibrated) {
  const Vec3 at = plane_.to_device(shown.position), v = plane_.turn_to_device(shown.velocity);
  const Force f = options_.shows_force && !brakes_ ? applied_ : Force{};
  state_.append(R"({"device_id":")").append(options_.device_id);
  state_.append(R"(","state":{"angular_position":{"a0":1.5,"a1":-2,"a2":0},)");
  state_.append(R"("control_domain":"cartesian","control_mode":")");
  state_.append(brakes_ ? "idle" : "force").append(R"(","current_cursor_force":)");
  add_vector(state_, f.x, f.y, f.z);
  state_ += R"(,"cursor_position":)";
  add_vector(state_, at.x / kMmPerM, at.y / kMmPerM, at.z / kMmPerM);
  state_ += R"(,"cursor_velocity":)";
  add_vector(state_, v.x / kMmPerM, v.y / kMmPerM, v.z / kMmPerM);
  state_.append(R"(,"transform":{}},"status":{"calibrated":)").append(word(is_calibrated));
  state_.append(R"(,"in_use":true,"power_supply":)").append(word(options_.has_power));
  state_ += R"(,"ready":true}})";
}

/// The handle points along its own y axis. A hand without a tilt holds it upright.
void FakeService::add_grip(const PenSample& shown) {
  const double tilt_rad = shown.tilt_deg.value_or(0.0) / kDegPerRad;
  const Vec3 axis = plane_.turn_to_device(Vec3{std::sin(tilt_rad), 0.0, std::cos(tilt_rad)});
  const auto turn = turn_of_y_to(axis);
  const auto bit = [&](unsigned i) { return word(((shown.buttons >> i) & 1u) != 0); };
  state_.append(R"({"device_id":")").append(kGripId).append(R"(","state":{"buttons":{"a":)");
  state_.append(bit(0)).append(R"(,"b":)").append(bit(1)).append(R"(,"c":)").append(bit(2));
  state_ += R"(},"orientation":{)";
  add_member(state_, "w", turn[0]);
  add_member(state_, "x", turn[1]);
  add_member(state_, "y", turn[2]);
  add_member(state_, "z", turn[3]);
  state_ += "}}}";
}

std::string FakeService::inventory() {
  Json all = Json::parse(state_);
  for (Json& device : all["inverse3"]) {
    device["config"] = {
        {"type", options_.type},
        {"port", "/dev/ttyACM0"},
        {"device_info", {{"major_version", 7}, {"minor_version", 4}, {"id", options_.device_id}}},
        {"gravity_compensation",
         {{"enabled", options_.has_gravity_compensation}, {"scaling_factor", 1.0}}},
        {"handedness", "right"},
        {"preset", "defaults"},
        {"basis", {{"permutation", "XYZ"}}},
        {"filters", {{"force_gate", {{"gain", 0.3}}}, {"damping", {{"scalar", 0.0}}}}}};
    device["status"]["in_use"] = is_connected();
  }
  return all.dump();
}

std::string FakeService::answer_to(std::string_view path) {
  std::string body;
  if (path == "/version") {
    body = Json{{"project_name", "haply-inverse-service"},
                {"git_tag", "x"},
                {"project_version", options_.version}}
               .dump();
  } else if (path == "/devices") {
    body = R"({"ok":true,"data":)" + inventory() + "}";
  } else {
    return "HTTP/1.1 404 Not Found\r\nConnection: close\r\n\r\n{\"ok\":false}";
  }
  return "HTTP/1.1 200 OK\r\nContent-Type: application/json\r\nConnection: close\r\n\r\n" + body;
}

void FakeService::tick(std::int64_t now_ns) {
  now_ns_ = now_ns;
  auto& device = world_.device();
  const auto pen = device.read(now_ns);
  const std::int64_t silence_ns = now_ns > received_ns_ ? now_ns - received_ns_ : 0;
  if (silence_ns > options_.watchdog_ns) {
    device.stop();
    applied_ = {};
  }
  if (!options_.is_calibrated && messages_ > options_.calibrates_after) {
    options_.is_calibrated = true;
  }
  write_state(pen);
  sum_ = {};
  work_until(now_ns);
  if (brakes_ && !is_active(InjectedFault::kForcesOff)) {
    brakes_ = false;
    report(R"({"name":"device-safety-triggered","category":"device","level":"notice","data":)"
           R"({"safety_type":"ebrake_released"},"message":"Emergency brake released"})");
  }
}

void FakeService::take_force(const Force& force) {
  asked_ = force;
  sum_ += force;
  // A zero request releases the motors immediately. Only the sum of the real service's forces is
  // known.
  apply(force == Force{} ? Force{} : sum_);
}

// Handles everything that is due by `until_ns`. A service that stalled, or works in bursts, accepts
// all waiting messages together.
void FakeService::work_until(std::int64_t until_ns) {
  if (is_active(InjectedFault::kNoAnswer)) return;
  const auto stood = [](const Waiting& one) { return one.done_ns == INT64_MAX; };
  const bool is_burst = is_active(InjectedFault::kBurstAnswers) && !waiting_.empty() &&
                        waiting_.front().done_ns <= until_ns;
  if (is_burst || std::any_of(waiting_.begin(), waiting_.end(), stood)) return take_waiting();
  while (!waiting_.empty() && waiting_.front().done_ns <= until_ns) take_first();
}

void FakeService::take_first() {
  const Waiting one = waiting_.front();
  waiting_.erase(waiting_.begin());
  if (!waiting_.empty()) waiting_.front().is_taken = true;
  received_ns_ = now_ns_;
  asked_ = one.force;
  apply(one.force);
  if (one.port->is_open()) one.port->say(state_);
}

void FakeService::take_waiting() {
  if (waiting_.empty()) return;
  std::vector<Waiting> all;
  all.swap(waiting_);
  waiting_.reserve(1024);
  for (const Waiting& one : all) sum_ += one.force;
  received_ns_ = now_ns_;
  asked_ = sum_;
  apply(sum_);
  for (const Waiting& one : all) {
    if (!one.port->is_open() || (options_.answers_once && &one != &all.back())) continue;
    one.port->say(state_);
  }
  sum_ = {};  // the following messages belong to the next tick
}

void FakeService::apply(const Force& force) {
  largest_n_ = std::max(largest_n_,
                        is_finite(force) ? norm(force) : std::numeric_limits<double>::infinity());
  const Vec3 turned = plane_.turn_to_page(Vec3{force.x, force.y, force.z});
  const auto done = world_.device().write({turned.x, turned.y, turned.z});
  applied_ = done ? force : Force{};
  if (force == Force{}) world_.device().stop();  // a zero request releases the motors
  if (done) return;
  if (done.error() == DeviceFault::kForcesOff && !brakes_) {
    brakes_ = true;
    report(R"({"name":"device-safety-triggered","category":"device","level":"error","data":)"
           R"({"device_id":"049D","safety_type":"ebrake_triggered"},)"
           R"("message":"Emergency brake engaged"})");
  }
  if (done.error() == DeviceFault::kDisconnected) hang_up();
}

void FakeService::take_setup(std::string_view text) {
  const Json message = Json::parse(text, nullptr, false);
  if (!message.is_object()) return break_rule("a message that is no JSON object");
  if (message.contains("session")) {
    profile_ = message["session"]["configure"]["profile"].value("name", "");
  }
  for (const Json& device : message.value("inverse3", Json::array())) {
    if (!device.contains("configure")) continue;
    const Json& configure = device["configure"];
    if (configure.contains("preset") && configure.contains("mount")) {
      break_rule("both a preset and a mount");
    }
    if (configure.contains("preset")) preset_ = configure["preset"].value("preset", "");
  }
  if (profile_.empty()) break_rule("no profile in the first message");
}

// Returns the time at which a message that is accepted at `from_ns` is answered.
std::int64_t FakeService::done_at(std::int64_t from_ns) noexcept {
  const auto ns = [](double ms) { return static_cast<std::int64_t>(1e6 * ms); };
  if (const FaultWindow* slow = window_of(InjectedFault::kSlowAnswers)) {
    return from_ns + ns(slow->amount);
  }
  if (const FaultWindow* bursts = window_of(InjectedFault::kBurstAnswers)) {
    const std::int64_t each_ns = std::max<std::int64_t>(ns(bursts->amount), 1);
    return (from_ns / each_ns + 1) * each_ns;
  }
  const FaultWindow* late = window_of(InjectedFault::kLateAnswer);
  if (late != nullptr && late->from_ns != late_window_ns_) {
    late_window_ns_ = late->from_ns;
    return from_ns + ns(late->amount);
  }
  return from_ns;
}

// Checks the rules for each message, accepted or not.
void FakeService::check_newest(const Force& force) {
  constexpr double kMaxRiseN = 2.0 * 0.3;  // of two periods
  const Force from = limit_rise(newest_, force, 0.0);
  if (is_finite(force)) largest_rise_n_ = std::max(largest_rise_n_, norm(force - from));
  if (largest_rise_n_ > kMaxRiseN + 1e-4) break_rule("a force that rises too fast");
  newest_ = force;
}

// Returns true if the message is not answered immediately.
bool FakeService::comes_to_wait(Port& port, std::string_view text) {
  const Force force = force_in(text, options_.key).value_or(Force{});
  check_newest(force);
  const bool stands = is_active(InjectedFault::kNoAnswer);
  const bool is_batch = stands || is_active(InjectedFault::kBurstAnswers);
  const std::int64_t from_ns = waiting_.empty() ? now_ns_ : std::max(busy_until_ns_, now_ns_);
  const std::int64_t done_ns = stands ? INT64_MAX : done_at(from_ns);
  if (done_ns <= now_ns_ && waiting_.empty()) return false;
  if (!is_batch) busy_until_ns_ = done_ns;
  waiting_.push_back({&port, force, done_ns, !is_batch && from_ns <= now_ns_});
  const auto waits = [](const Waiting& one) { return !one.is_taken; };
  const auto bears = [](const Waiting& one) { return !one.is_taken && one.force != Force{}; };
  const auto count = std::count_if(waiting_.begin(), waiting_.end(), waits);
  max_waiting_ = std::max(max_waiting_, static_cast<std::size_t>(count));
  if (count > 2 || std::count_if(waiting_.begin(), waiting_.end(), bears) > 1) {
    break_rule("messages are piled up before a service that is late");
  }
  return true;
}

bool FakeService::take_message(Port& port, std::string_view text) {
  ++messages_;
  if (port.was_set_up_ && comes_to_wait(port, text)) return false;
  received_ns_ = now_ns_;
  const bool is_setup = !port.was_set_up_;
  port.was_set_up_ = true;
  if (is_setup) {
    take_setup(text);
  } else if (text.find("configure") != std::string_view::npos) {
    break_rule("a configuration after the first message");
  }
  const std::optional<Force> force = force_in(text, options_.key);
  const bool is_command = text.find("set_cursor_force") != std::string_view::npos;
  if (is_command && text.find("\"" + options_.device_id + "\"") == std::string_view::npos) {
    break_rule("a command for a device that is not there");
  }
  if (is_command && !force) ++ignored_;
  // A force lasts for one message, so a message without a force releases the motors.
  take_force(force.value_or(Force{}));
  if (!is_setup && is_active(InjectedFault::kLostAnswers)) {
    owes_answer_ = !owes_answer_;
    if (!owes_answer_) return false;
  }
  return !is_silent_;
}

bool FakeService::Port::take(std::span<const std::byte> bytes) {
  in_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (!is_socket_) take_request();
  while (is_open_ && is_socket_ && take_frame()) {
  }
  return is_open_;
}

void FakeService::Port::take_request() {
  const std::size_t blank = in_.find("\r\n\r\n");
  if (blank == std::string::npos) return;
  const std::string request = in_.substr(0, blank);
  in_.erase(0, blank + 4);
  constexpr std::string_view kKey = "Sec-WebSocket-Key: ";
  const std::size_t key = request.find(kKey);
  if (key == std::string::npos) {
    const std::size_t path = request.find(' ') + 1;
    out_ += service_->answer_to(request.substr(path, request.find(' ', path) - path));
    is_answered_ = true;
    return;
  }
  const std::size_t from = key + kKey.size();
  const std::string word =
      request.substr(from, std::min(request.find("\r\n", from), request.size()) - from);
  if (word.size() != 24) service_->break_rule("a key that is not of 16 bytes");
  out_ +=
      "HTTP/1.1 101 Switching Protocols\r\nupgrade: WebSocket\r\nConnection: Upgrade\r\n"
      "sec-websocket-accept: " +
      accept_for(word) + "\r\n\r\n";
  is_socket_ = true;
  if (!is_events_) say(service_->inventory());
}

void FakeService::Port::frame(std::uint8_t first, std::string_view payload) {
  out_ += static_cast<char>(first);
  if (payload.size() < 126) {
    out_ += static_cast<char>(payload.size());
  } else if (payload.size() < 65536) {
    out_ += static_cast<char>(126);
    out_ += static_cast<char>(payload.size() >> 8);
    out_ += static_cast<char>(payload.size() & 0xFF);
  } else {
    out_ += static_cast<char>(127);
    for (int shift = 56; shift >= 0; shift -= 8) {
      out_ += static_cast<char>((std::uint64_t{payload.size()} >> shift) & 0xFF);
    }
  }
  out_ += payload;
}

void FakeService::Port::say(std::string_view text) {
  if (out_.size() + text.size() > kRoom / 2) return;  // the client does not read
  if (!service_->options_.fragments) return frame(0x81, text);
  const std::size_t third = text.size() / 3;
  frame(0x01, text.substr(0, third));
  frame(0x89, "are you there");
  frame(0x00, text.substr(third, third));
  frame(0x80, text.substr(2 * third));
}

// Handles the payload of a frame.
void FakeService::Port::take_payload(std::uint8_t opcode, std::string_view payload) {
  if (opcode == 0x8) {
    frame(0x88, payload);
    end();
    if (!is_events_) service_->world_.device().stop();
  } else if (opcode == 0x1) {
    if (is_events_) service_->break_rule("a message on the events channel");
    if (!is_events_ && service_->take_message(*this, payload)) {
      say(service_->instead_.empty() ? service_->state_ : service_->instead_);
    }
  } else if (opcode != 0xA) {
    service_->break_rule("a frame of a strange kind");
  }
}

// Handles a frame from a client. Returns false if no frame is complete.
bool FakeService::Port::take_frame() {
  const auto byte = [this](std::size_t i) { return static_cast<std::uint8_t>(in_[i]); };
  if (in_.size() < 2) return false;
  if ((byte(1) & 0x80) == 0) service_->break_rule("a frame without a mask");
  if ((byte(0) & 0x70) != 0) service_->break_rule("bits that are reserved");
  std::size_t size = byte(1) & 0x7F, at = 2;
  if (size == 126) {
    if (in_.size() < 4) return false;
    size = (std::size_t{byte(2)} << 8) | byte(3);
    at = 4;
  } else if (size == 127) {
    service_->break_rule("a message that is too long");
    end();
    return false;
  }
  if (in_.size() < at + 4 + size) return false;
  const std::uint8_t opcode = byte(0) & 0x0F;
  for (std::size_t i = 0; i < size; ++i) {
    in_[at + 4 + i] = static_cast<char>(byte(at + 4 + i) ^ byte(at + i % 4));
  }
  take_payload(opcode, std::string_view(in_.data() + at + 4, size));
  in_.erase(0, at + 4 + size);
  return true;
}

}  // namespace felt::haply
