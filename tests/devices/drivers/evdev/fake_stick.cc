#include "tests/devices/drivers/evdev/fake_stick.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <utility>

#include "felt/devices/evdev/stick_axes.h"

namespace felt {
namespace {

constexpr std::size_t kMaxEvents = 64;  // that the kernel keeps for a reader
constexpr double kFullDamperMmPerS = 300.0;
constexpr const char* kNode = "/dev/input/event7";
constexpr const char* kSysfs = "/sys/class/input/event7/device";

std::string bits(const std::set<std::uint16_t>& set) {
  std::array<std::uint64_t, 12> words{};
  for (const std::uint16_t bit : set) words[bit / 64] |= std::uint64_t{1} << (bit % 64);
  std::string text;
  for (std::size_t i = words.size(); i-- > 0;) {
    if (text.empty() && words[i] == 0 && i > 0) continue;
    std::array<char, 20> word{};
    std::snprintf(word.data(), word.size(), "%llx", static_cast<unsigned long long>(words[i]));
    text += (text.empty() ? "" : " ") + std::string(word.data());
  }
  return text + "\n";
}

std::int32_t counts(double mm) {
  const double share = std::clamp(mm / FakeStick::kHalfWayMm, -1.0, 1.0);
  return static_cast<std::int32_t>(std::lround(share * FakeStick::kCounts));
}

std::int32_t lever(double z_mm) {
  const double share = std::clamp(-z_mm / FakeStick::kDepthMm, 0.0, 1.0);
  return static_cast<std::int32_t>(std::lround(share * FakeStick::kLeverCounts));
}

double condition_force(const EvdevCondition& c, double off) {
  const double coefficient = (off > 0.0 ? c.right_coefficient : c.left_coefficient) / 32767.0;
  const double largest = (off > 0.0 ? c.right_saturation : c.left_saturation) / 65535.0;
  return -std::clamp(coefficient * off, -largest, largest);
}

}  // namespace

class FakeStick::Port final : public EvdevPort {
 public:
  explicit Port(FakeStick& stick) : stick_(stick), plugging_(stick.pluggings_) {}
  ~Port() override {
    if (is_gone()) return;
    stick_.kept_.clear();
    stick_.effects_.clear();
    stick_.release_if_quiet();
  }
  tl::expected<bool, int> next(EvdevEvent& event) noexcept override {
    if (is_gone()) return tl::unexpected(ENODEV);
    if (stick_.events_.empty()) return false;
    event = stick_.events_.front();
    stick_.events_.pop_front();
    return true;
  }
  tl::expected<EvdevAxis, int> axis(std::uint16_t code) noexcept override {
    take_lock();
    if (is_gone()) return tl::unexpected(ENODEV);
    const std::int32_t value = stick_.said_axes_[code];
    if (code == evdev::kAbsThrottle) return EvdevAxis{value, 0, kLeverCounts, 0};
    if (code > evdev::kAbsY) return tl::unexpected(EINVAL);
    return EvdevAxis{value, -kCounts, kCounts, 0};
  }
  tl::expected<bool, int> key(std::uint16_t code) noexcept override {
    take_lock();
    if (is_gone()) return tl::unexpected(ENODEV);
    return stick_.said_keys_[code];
  }
  tl::expected<int, int> slots() noexcept override {
    take_lock();
    if (is_gone()) return tl::unexpected(ENODEV);
    return stick_.slots_;
  }
  tl::expected<std::int16_t, int> upload(const EvdevEffect& effect) noexcept override {
    take_lock();
    if (is_gone()) return tl::unexpected(ENODEV);
    return stick_.upload(effect);
  }
  tl::expected<void, int> erase(std::int16_t id) noexcept override {
    take_lock();
    if (is_gone()) return tl::unexpected(ENODEV);
    return stick_.erase(id);
  }
  tl::expected<void, int> send(const EvdevEvent& event) noexcept override {
    take_lock();
    if (is_gone()) return tl::unexpected(ENODEV);
    return stick_.send(event);
  }

 private:
  [[nodiscard]] bool is_gone() const noexcept {
    return !stick_.is_plugged_ || plugging_ != stick_.pluggings_;
  }

  void take_lock() const noexcept {
    if (stick_.is_haptic_) stick_.forbid("the haptic thread waits for the kernel");
  }

  FakeStick& stick_;
  std::uint32_t plugging_;
};

StylusPreset FakeStick::preset() {
  StylusPreset preset = *find_stylus_preset("touch");
  preset.name = "stick";
  preset.label = "Microsoft SideWinder Force Feedback 2";
  preset.source = "estimate";
  preset.mechanics = {.mass_kg = 0.15, .friction_n = 0.2, .viscous_n_s_per_m = 0.5};
  Capabilities& can = preset.capabilities;
  can.max_force_n = kFullN;
  can.continuous_force_n = kFullN;
  can.workspace_min = {kMiddle.x - kHalfWayMm, kMiddle.y - kHalfWayMm, -20.0};
  can.workspace_max = {kMiddle.x + kHalfWayMm, kMiddle.y + kHalfWayMm, 40.0};
  can.position_step_mm = 0.0;
  can.delay_ticks = 0;
  return preset;
}

FakeStick::FakeStick(std::vector<FaultWindow> faults, std::vector<std::uint16_t> effects)
    : world_(preset(), std::move(faults)), kinds_(effects.begin(), effects.end()) {
  if (kinds_.empty()) {
    kinds_ = {evdev::kFfSpring,   evdev::kFfFriction, evdev::kFfDamper,
              evdev::kFfConstant, evdev::kFfGain,     evdev::kFfAutocenter};
  }
  plug(true);
}

void FakeStick::plug(bool in) noexcept {
  if (std::exchange(is_plugged_, in) == in) return;
  const std::string folder = kSysfs;
  if (!in) {
    events_.clear();
    for (const char* file : {"/name", "/uniq", "/id/vendor", "/id/product", "/capabilities/abs",
                             "/capabilities/key", "/capabilities/ff"}) {
      system_.remove(folder + file);
    }
    system_.remove(kNode);
    return;
  }
  ++pluggings_;
  kept_.clear();
  effects_.clear();
  autocenter_ = 0x8000;
  has_reported_ = false;
  system_.add_file(kNode)
      .add_file(folder + "/name", "Microsoft SideWinder Force Feedback 2 Joystick\n")
      .add_file(folder + "/uniq", "\n")
      .add_file(folder + "/id/vendor", "045e\n")
      .add_file(folder + "/id/product", "001b\n")
      .add_file(folder + "/capabilities/abs",
                bits({evdev::kAbsX, evdev::kAbsY, evdev::kAbsThrottle}))
      .add_file(folder + "/capabilities/key",
                bits({evdev::kButtonTrigger, evdev::kButtonTrigger + 1, evdev::kButtonTrigger + 2}))
      .add_file(folder + "/capabilities/ff", bits(kinds_));
}

Result<std::unique_ptr<EvdevPort>> FakeStick::open(const std::string& path) {
  if (const auto may = system_.may_use(path); !may) return tl::unexpected(may.error());
  events_.clear();
  return std::make_unique<Port>(*this);
}

PenSample FakeStick::as_said(const PenSample& pen) noexcept {
  PenSample said = pen;
  const double share =
      std::max(lever(pen.position.z) / double{kLeverCounts}, StickAxes::kMinPressure);
  said.pressure = pen.position.z < 0.0 ? share : 0.0;
  said.position.z = pen.position.z < 0.0 ? -StickAxes::kDepthMm * share : StickAxes::kHoverMm;
  said.velocity.z = 0.0;
  return said;
}

void FakeStick::tick(std::int64_t now_ns) noexcept {
  now_ns_ = now_ns;
  // If the clock was set back, the uploads count as just made.
  for (auto& [id, slot] : effects_) slot.uploaded_ns = std::min(slot.uploaded_ns, now_ns);
  const auto pen = world_.device().read(now_ns);
  if (!pen && pen.error() == DeviceFault::kDisconnected) {
    plug(false);
    world_.device().stop();  // no power either
    return;
  }
  plug(true);
  if (!pen) return;
  push(*pen);
  if (has_reported_ && now_ns >= reported_ns_ && now_ns - reported_ns_ < kPollNs) return;
  reported_ns_ = now_ns;
  has_reported_ = true;
  report(*pen);
}

void FakeStick::report(const PenSample& pen) noexcept {
  const std::size_t before = events_.size();
  const auto axis = [this](std::uint16_t code, std::int32_t value) {
    if (std::exchange(said_axes_[code], value) != value)
      events_.push_back({evdev::kAbs, code, value});
  };
  const auto key = [this](std::uint16_t code, bool down) {
    if (std::exchange(said_keys_[code], down) != down)
      events_.push_back({evdev::kKey, code, down ? 1 : 0});
  };
  axis(evdev::kAbsX, counts(pen.position.x - kMiddle.x));
  axis(evdev::kAbsY, counts(pen.position.y - kMiddle.y));
  axis(evdev::kAbsThrottle, lever(pen.position.z));
  key(evdev::kButtonTrigger, pen.position.z < 0.0);
  key(evdev::kButtonTrigger + 1, (pen.buttons & 1) != 0);
  key(evdev::kButtonTrigger + 2, (pen.buttons & 2) != 0);
  if (events_.size() > before) events_.push_back({evdev::kSyn, evdev::kSynReport, 0});
  if (events_.size() > kMaxEvents) drop_events();
}

void FakeStick::drop_events() noexcept {
  events_.clear();
  events_.push_back({evdev::kSyn, evdev::kSynDropped, 0});
  events_.push_back({evdev::kAbs, evdev::kAbsX, 12345});
  events_.push_back({evdev::kSyn, evdev::kSynReport, 0});
}

Force FakeStick::force_at(const PenSample& pen) const noexcept {
  Force force;
  const std::array<double, 2> off{(pen.position.x - kMiddle.x) / kHalfWayMm,
                                  (pen.position.y - kMiddle.y) / kHalfWayMm};
  const std::array<double, 2> speed{pen.velocity.x, pen.velocity.y};
  for (const auto& [id, slot] : effects_) {
    if (!slot.plays) continue;
    const EvdevEffect& effect = kept_.at(id);
    std::array<double, 2> shares{};
    for (std::size_t i = 0; i < 2; ++i) {
      const EvdevCondition& c = effect.conditions[i];
      if (effect.type == evdev::kFfSpring)
        shares[i] = condition_force(c, off[i] - c.center / 32767.0);
      if (effect.type == evdev::kFfDamper)
        shares[i] = condition_force(c, speed[i] / kFullDamperMmPerS);
      if (effect.type == evdev::kFfFriction)
        shares[i] = condition_force(c, std::clamp(speed[i] / 5.0, -1.0, 1.0));
    }
    if (effect.type == evdev::kFfConstant) {
      const double angle = effect.direction * 6.283185307179586 / 65536.0;
      shares = {-std::sin(angle) * effect.level / 32767.0,
                std::cos(angle) * effect.level / 32767.0};
    }
    force += Force{kFullN * shares[0], kFullN * shares[1], 0.0};
  }
  return (gain_ / 65535.0) * force;
}

void FakeStick::push(const PenSample& pen) noexcept {
  for (auto& [id, slot] : effects_) {
    if (slot.plays && (now_ns_ >= slot.until_ns || slot.until_ns - now_ns_ > 70'000'000'000)) {
      slot.plays = false;
    }
  }
  if (playing() == 0) return release_if_quiet();
  const auto done = world_.device().write(force_at(pen));
  if (done) {
    if (refused_ == EIO) refused_ = 0;
    return;
  }
  if (done.error() == DeviceFault::kDisconnected) {
    plug(false);
    world_.device().stop();
  } else {
    refused_ = EIO;
  }
}

std::size_t FakeStick::playing() const noexcept {
  return static_cast<std::size_t>(std::count_if(
      effects_.begin(), effects_.end(), [](const auto& entry) { return entry.second.plays; }));
}

void FakeStick::release_if_quiet() noexcept {
  if (playing() > 0) return;
  if (world_.held_force() != Force{}) world_.device().stop();
  // Checks whether the device accepts forces; the result applies to the next upload.
  const auto asked = world_.device().write({});
  refused_ = asked ? 0 : EIO;
  if (!asked && asked.error() == DeviceFault::kDisconnected) plug(false);
}

void FakeStick::note_asked() noexcept {
  std::array<double, 2> shares{};
  for (const auto& [id, slot] : effects_) {
    if (!slot.plays) continue;
    const EvdevEffect& effect = kept_.at(id);
    const double angle = effect.direction * 6.283185307179586 / 65536.0;
    const double level = effect.type == evdev::kFfConstant ? std::abs(effect.level) / 32767.0 : 0.0;
    const std::array<double, 2> along{std::abs(std::sin(angle)), std::abs(std::cos(angle))};
    for (std::size_t i = 0; i < 2; ++i) {
      const EvdevCondition& c = effect.conditions[i];
      shares[i] += std::max(c.left_saturation, c.right_saturation) / 65535.0 + level * along[i];
    }
  }
  largest_n_ = std::max(largest_n_, kFullN * std::hypot(shares[0], shares[1]));
}

tl::expected<std::int16_t, int> FakeStick::upload(const EvdevEffect& effect) noexcept {
  ++uploads_;
  if (!kinds_.contains(effect.type)) {
    forbid("an effect of a kind that it has not got");
    return tl::unexpected(EINVAL);
  }
  if (effect.length_ms == 0 || effect.length_ms > 1000) forbid("an effect that does not end soon");
  if (must_refuse_ != 0) return tl::unexpected(must_refuse_);
  if (refused_ != 0) return tl::unexpected(refused_);
  std::int16_t id = effect.id;
  if (id < 0) {
    if (kept_.size() >= static_cast<std::size_t>(slots_)) return tl::unexpected(ENOSPC);
    for (id = 0; kept_.contains(id);) ++id;
    effects_[id] = {};
  } else if (!kept_.contains(id)) {
    forbid("an upload for an effect that is not there");
    return tl::unexpected(EINVAL);
  } else {
    const std::int64_t since_ns = now_ns_ - effects_[id].uploaded_ns;
    if (since_ns >= 0 && since_ns < kUploadNs - 1) forbid("more than 125 uploads a second");
  }
  kept_[id] = effect;
  kept_[id].id = id;
  effects_[id].uploaded_ns = now_ns_;
  note_asked();
  return id;
}

tl::expected<void, int> FakeStick::erase(std::int16_t id) noexcept {
  if (kept_.erase(id) == 0) {
    forbid("erases what is not there");
    return tl::unexpected(EINVAL);
  }
  effects_.erase(id);
  release_if_quiet();
  return {};
}

tl::expected<void, int> FakeStick::send(const EvdevEvent& event) noexcept {
  if (event.type != evdev::kFf) {
    forbid("an event that is none of force feedback");
    return tl::unexpected(EINVAL);
  }
  if (event.code == evdev::kFfGain || event.code == evdev::kFfAutocenter) {
    if (!kinds_.contains(event.code)) forbid("gain or autocenter that it has not got");
    (event.code == evdev::kFfGain ? gain_ : autocenter_) = event.value;
    return {};
  }
  const auto slot = effects_.find(static_cast<std::int16_t>(event.code));
  if (slot == effects_.end()) {
    forbid("plays what is not there");
    return {};
  }
  if (event.value > 0 && kinds_.contains(evdev::kFfAutocenter) && autocenter_ != 0) {
    forbid("plays beside the stick's own spring");
  }
  slot->second.plays = event.value > 0;
  slot->second.until_ns = now_ns_ + kept_[slot->first].length_ms * 1'000'000LL;
  note_asked();
  release_if_quiet();
  return {};
}

}  // namespace felt
