// The process that is killed. It runs a session, a haptic loop and an autosave in real time, each
// on its own thread.
#include <time.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <future>
#include <memory>
#include <random>
#include <thread>

#include "felt/autosave/autosave.h"
#include "felt/devices/simulated/simulated_stylus.h"
#include "felt/devices/simulated/stylus_presets.h"
#include "felt/session/session.h"
#include "felt/stroke/testing/random_stroke.h"
#include "felt/tools/tool.h"
#include "tests/reliability/kill/kill_shared.h"

namespace felt::kill {
namespace {

constexpr std::uint32_t kDownTicks = 120, kCycleTicks = 190;
constexpr std::int64_t kSaveEveryTicks = 150;

std::uint64_t mixed(std::uint64_t a, std::uint64_t b) {
  std::uint64_t x = a * 0x9e3779b97f4a7c15ULL + b;
  x ^= x >> 31;
  x *= 0xbf58476d1ce4e5b9ULL;
  return x ^ x >> 29;
}

/// Pauses this thread once in eight calls, as on a machine with too little memory or a slow disk.
void stall(int longest_ms) {
  thread_local std::minstd_rand random(static_cast<unsigned>(monotonic_ns()));
  if (random() % 8 != 0) return;
  const auto pause_ms = std::uniform_int_distribution<int>(0, longest_ms)(random);
  std::this_thread::sleep_for(std::chrono::milliseconds(pause_ms));
}

/// Records each sample of a device in shared memory before the haptic loop receives it.
class WitnessedDevice final : public Device {
 public:
  WitnessedDevice(Device& device, Testimony& testimony) : device_(device), testimony_(testimony) {}

  [[nodiscard]] std::string_view name() const noexcept override { return device_.name(); }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return device_.capabilities();
  }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override {
    auto sample = device_.read(now_ns);
    const std::uint32_t k = testimony_.read.load(std::memory_order_relaxed);
    Tick& tick = testimony_.ticks[k];
    if (sample) tick.sample = *sample;
    tick.made_ns = monotonic_ns();
    testimony_.read.store(k + 1, std::memory_order_release);
    return sample;
  }
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override {
    return device_.write(force);
  }
  void stop() noexcept override { device_.stop(); }

 private:
  Device& device_;
  Testimony& testimony_;
};

/// Draws: owns the session, the haptic loop and the autosave. Runs on the edit thread, except
/// tick().
class Artist {
 public:
  Artist(const Picture& picture, Testimony& testimony)
      : picture_(picture),
        stylus_(device_of(picture)),
        device_(stylus_, testimony),
        servo_(std::make_unique<Servo>(device_, servo_options())),
        autosave_(autosave_options(testimony)) {
    SessionOptions options;
    options.device = stylus_.capabilities();
    options.document = base_document(picture);
    options.on_event = [this](const Event& event) { autosave_.event_applied(*session_, event); };
    options.on_edit = [this](const Edit& edit) { autosave_.edit_applied(*session_, edit); };
    session_ = std::make_unique<Session>(make_tools(), std::move(options));
    autosave_.session_began(*session_, drawing(), "Killed", picture.base_path, false);
    autosave_.attach(servo_->for_autosave(), kOffsetNs);
    servo_->publish(session_->force());
    if (picture.with_forces) servo_->arm();
  }

  [[noreturn]] void run(Testimony& testimony) {
    std::thread loop([this, &testimony] { tick(testimony); });
    for (;;) {
      turn();
      if (picture_.stalls) stall(300);
      std::this_thread::sleep_for(std::chrono::milliseconds(4));
    }
  }

 private:
  ServoOptions servo_options() const {
    ServoOptions options;
    options.limits = limits_for(stylus_.capabilities(), 3.0);
    return options;
  }
  AutosaveOptions autosave_options(Testimony& testimony) const {
    AutosaveOptions options;
    options.roots = {picture_.root};
    options.max_log_bytes = 3'000;  // so that a new base is written every few strokes
    options.on_commit = [&testimony, stalls = picture_.stalls](std::int64_t until_ns) {
      testimony.committed_ns.store(until_ns, std::memory_order_release);
      testimony.has_store.store(true, std::memory_order_release);
      if (stalls) stall(400);
    };
    return options;
  }

  [[nodiscard]] Drawing drawing() const {
    Drawing drawing;
    drawing.document = session_->document();
    drawing.page.surface = session_->surface().id;
    drawing.color = session_->ink_color();
    drawing.layer = session_->layer();
    return drawing;
  }

  /// Runs the haptic loop. Called on the haptic thread.
  void tick(Testimony& testimony) {
    timespec due{};
    ::clock_gettime(CLOCK_MONOTONIC, &due);
    for (std::uint32_t k = 0; k < kMaxTicks; ++k) {
      const Target target = target_at(picture_.seed, k);
      stylus_.aim(target.place, {}, 0);
      const TickReport& report = servo_->step(std::int64_t{k} * kTickNs);
      testimony.ticks[k].is_ink = report.sample_ok;
      testimony.confirmed.store(k + 1, std::memory_order_release);
      due.tv_nsec += kTickNs;
      if (due.tv_nsec >= 1'000'000'000) {
        due.tv_nsec -= 1'000'000'000;
        ++due.tv_sec;
      }
      ::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &due, nullptr);
    }
    ::_exit(3);  // the test should have killed this process by now
  }

  void turn() {
    PenSample sample;
    while (servo_->for_edit().pop(sample)) {
      if (reported_ == picture_.hangs_at) {
        for (;;) ::pause();
      }
      for (auto& what : events_at(picture_.seed, reported_)) {
        static_cast<void>(session_->apply({now_ns_, std::move(what)}));
      }
      now_ns_ = sample.time_ns += kOffsetNs;
      static_cast<void>(session_->sample(sample));
      if (++reported_ % kSaveEveryTicks == 0) begin_save();
    }
    end_save();
    servo_->publish(session_->force());
    servo_->heartbeat(now_ns_ - kOffsetNs);
  }

  void begin_save() {
    if (save_.valid()) return;
    saving_ = session_->edit_count();
    save_ = std::async(std::launch::async, [path = picture_.save_path, copy = drawing()] {
      return write_felt(path, copy).has_value();
    });
  }

  void end_save() {
    if (!save_.valid() || save_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
      return;
    }
    if (!save_.get()) ::_exit(4);
    AutosaveMessage saved{.name = "Killed", .path = picture_.save_path};
    if (saving_ == session_->edit_count()) saved.modified = false;
    autosave_.post(std::move(saved));
  }

  const Picture& picture_;
  SimulatedStylus stylus_;
  WitnessedDevice device_;
  std::unique_ptr<Servo> servo_;
  Autosave autosave_;
  std::unique_ptr<Session> session_;
  std::uint32_t reported_ = 0;
  std::int64_t now_ns_ = kOffsetNs;
  std::future<bool> save_;
  std::uint64_t saving_ = 0;
};

}  // namespace

std::int64_t monotonic_ns() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

Target target_at(std::uint64_t seed, std::uint32_t tick) {
  const double t = 1e-3 * tick + 1e-3 * static_cast<double>(seed % 977);
  const bool down = (tick + seed) % kCycleTicks < kDownTicks;
  return {{70.0 + 25.0 * std::cos(4.0 * t) + 3.0 * t, 60.0 + 22.0 * std::sin(5.3 * t),
           down ? -0.6 : 2.5},
          down};
}

std::vector<decltype(Event::what)> events_at(std::uint64_t seed, std::uint32_t sample) {
  // Returns an event about every 50 samples. Some events come in the middle of a line.
  if (sample % 23 != 7) return {};
  static constexpr const char* kTools[] = {"pencil", "pencil", "pencil", "pull",
                                           "eraser", "width",  "smooth", "transform"};
  const std::uint64_t any = mixed(seed, sample);
  switch (any % 16) {
    case 0:
      return {UndoEvent{}};
    case 1:
      return {RedoEvent{}};
    case 2:
      return {SelectTool{kTools[any / 16 % std::size(kTools)]}};
    case 3:
      return {SetOption{"pencil.max_width_mm", 1.0 + static_cast<double>(any / 16 % 40) / 10.0}};
    case 4:
      return {SelectStrokes{}};
    case 5:
      return {LayerEvent{LayerEvent::Do::kAdd, {}, "L"}};
    case 6:
      return {SetOption{"ink.color", any / 16 % 2 == 0 ? "#102030" : "#a03010"}};
    default:
      return {};
  }
}

const StylusPreset& device_of(const Picture& picture) {
  return *find_stylus_preset(picture.with_forces ? "touch" : "tablet");
}

Document base_document(const Picture& picture) {
  std::vector<StrokePtr> strokes;
  for (int i = 0; i < picture.base_strokes; ++i) {
    strokes.push_back(
        std::make_shared<const Stroke>(testing::random_stroke(static_cast<std::uint64_t>(i))));
  }
  return document_of(strokes);
}

void draw(const Picture& picture, Testimony& testimony) {
  Artist(picture, testimony).run(testimony);
}

}  // namespace felt::kill
