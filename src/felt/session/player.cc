#include "felt/session/player.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "felt/haptics/pen_sample.h"
#include "felt/rt/device.h"
#include "felt/session/pose_track.h"

namespace felt {
namespace {

/// A device that a script moves. It wraps another device, `below`. During hand events it only sets
/// the aim of the hand of `below`, which then moves the pen. During pen events the script sets the
/// position of the pen, so forces do not move it, and velocities are computed as in drivers.
///
///   scripted.set(track.at(now_ns));
///   servo.step(now_ns);                // calls read() and write()
class PlayedDevice final : public Device {
 public:
  /// `below` and `hand` must outlive this object. `hand` may be null if the script has no hand
  /// events.
  PlayedDevice(Device& below, HandInput* hand) noexcept : below_(below), hand_(hand) {}

  void set(const ScriptPose& pose) noexcept {
    pose_ = pose;
    if (pose_.by_hand)
      hand_->aim(Aim{pose_.position, pose_.pressure, pose_.buttons, pose_.tilt_deg});
  }
  [[nodiscard]] bool by_hand() const noexcept { return pose_.by_hand; }

  [[nodiscard]] std::string_view name() const noexcept override { return below_.name(); }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return below_.capabilities();
  }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override {
    if (pose_.by_hand) return below_.read(now_ns);
    const double dt_s = 1e-9 * static_cast<double>(now_ns - last_ns_);
    last_ns_ = now_ns;
    const Vec3 velocity = velocity_.update(pose_.position, dt_s);
    return PenSample{now_ns,         pose_.position, velocity,
                     pose_.pressure, pose_.buttons,  pose_.tilt_deg};
  }
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override {
    if (pose_.by_hand) return below_.write(force);
    return {};
  }
  void stop() noexcept override { below_.stop(); }

 private:
  Device& below_;
  HandInput* hand_;
  ScriptPose pose_;
  VelocityFilter velocity_;
  std::int64_t last_ns_ = 0;
};

/// After the last event the loop runs for kSettleNs, so that even a hand with mass and lag has
/// lifted the pen off the surface. If the pen is still down, the loop runs for up to
/// kLongestSettleNs.
constexpr std::int64_t kSettleNs = 100'000'000;
constexpr std::int64_t kLongestSettleNs = 500'000'000;

bool is_pose(const Event& event) {
  return std::holds_alternative<PenEvent>(event.what) ||
         std::holds_alternative<HandEvent>(event.what);
}

std::string milliseconds(std::int64_t time_ns) {
  std::string text = std::to_string(static_cast<double>(time_ns) / 1e6);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text + " ms";
}

std::string place_of(std::size_t index, const Event& event) {
  return "event " + std::to_string(index + 1) + ", at " + milliseconds(event.time_ns);
}

/// Checks a script before it is played.
Result<void> check(std::span<const Event> events, const PlayerOptions& options, bool has_hand) {
  std::int64_t last_ns = 0;
  for (std::size_t i = 0; i < events.size(); ++i) {
    const Event& event = events[i];
    std::string wrong;
    if (event.time_ns < last_ns) wrong = "the time is earlier than that of the previous event";
    if (event.time_ns - events[0].time_ns > options.longest_ns) {
      wrong = "the script is longer than " + milliseconds(options.longest_ns);
    }
    if (!has_hand && std::holds_alternative<HandEvent>(event.what)) {
      wrong = "hand events need a device with a simulated hand";
    }
    if (std::holds_alternative<UseDevice>(event.what)) {
      wrong = "device events are only allowed in recordings, which are played with --as-recorded";
    }
    if (!wrong.empty()) {
      return fail(ErrorCode::kInvalidArgument, place_of(i, event) + ": " + wrong);
    }
    last_ns = event.time_ns;
  }
  return {};
}

/// The events of a script that are not poses, in order.
class OtherEvents {
 public:
  explicit OtherEvents(std::span<const Event> events) : events_(events) {}

  /// Returns the next event that takes effect before a sample of this time, or null. Skips poses.
  const Event* next_before(std::int64_t sample_ns) {
    return next([this, sample_ns](std::int64_t time_ns) {
      // If a pose of the same time precedes the event, the event takes effect after the sample of
      // that time.
      return time_ns < sample_ns || (time_ns == sample_ns && time_ns != pose_ns_);
    });
  }
  /// Returns the next event of this time or earlier, or null.
  const Event* next_until(std::int64_t now_ns) {
    return next([now_ns](std::int64_t time_ns) { return time_ns <= now_ns; });
  }
  /// Returns the index of the event that was returned last.
  [[nodiscard]] std::size_t index() const noexcept { return at_ - 1; }

 private:
  template <class IsDue>
  const Event* next(IsDue&& is_due) {
    for (; at_ < events_.size(); ++at_) {
      const Event& event = events_[at_];
      if (is_pose(event)) {
        pose_ns_ = event.time_ns;
      } else if (is_due(event.time_ns)) {
        ++at_;
        return &event;
      } else {
        return nullptr;
      }
    }
    return nullptr;
  }

  std::span<const Event> events_;
  std::size_t at_ = 0;
  std::int64_t pose_ns_ = -1;  // of the last pose that was skipped
};

}  // namespace

/// Plays one script: runs the loop and does the work of the edit thread.
class Player::Run {
 public:
  Run(Player& player, std::span<const Event> events)
      : session_(player.session_),
        options_(player.options_),
        events_(events),
        others_(events),
        track_(events),
        device_(player.device_, player.hand_),
        servo_(std::make_unique<Servo>(device_, servo_options(player))) {
    report_.events = events.size();
    edits_before_ = session_.edit_count();
  }

  Result<PlayReport> play() {
    const std::int64_t period_ns = servo_->options().period_ns;
    const std::int64_t first_ns = events_.front().time_ns;
    const std::int64_t last_ns = events_.back().time_ns;
    std::int64_t now_ns = first_ns / period_ns * period_ns;
    report_.start_ns = now_ns;
    publish(now_ns);
    if (options_.forces) servo_->arm();
    std::int64_t turn_ns = now_ns;
    for (;; now_ns += period_ns) {
      tick(now_ns);
      const bool is_last = is_over(now_ns, last_ns);
      if (now_ns < turn_ns && !is_last) continue;
      turn_ns = now_ns + std::max(options_.edit_period_ns, period_ns);
      if (Result<void> done = turn(now_ns); !done) return tl::unexpected(done.error());
      report_.cancelled = options_.is_cancelled && options_.is_cancelled();
      if (is_last || report_.cancelled) break;
    }
    return end(now_ns);
  }

 private:
  static ServoOptions servo_options(const Player& player) {
    ServoOptions options;
    options.period_ns = player.options_.period_ns;
    options.limits = limits_for(player.device_.capabilities(), player.options_.force_limit_n);
    return options;
  }

  void tick(std::int64_t now_ns) {
    device_.set(track_.at(now_ns));
    const TickReport& tick = servo_->step(now_ns);
    ++report_.ticks;
    report_.largest_asked_n = std::max(report_.largest_asked_n, norm(tick.asked));
    report_.largest_sent_n = std::max(report_.largest_sent_n, norm(tick.sent));
    if (!tick.sample_ok) ++report_.unread;
    PenSample sample;
    bool reported = false;
    while (servo_->for_edit().pop(sample)) {
      samples_.push_back(sample);
      reported = true;
    }
    // The loop does not pass on samples that it rejected. If the script moves the pen, a rejected
    // sample is used, too, because the script defines its position.
    if (!reported && !device_.by_hand()) samples_.push_back(tick.sample);
    pen_is_down_ = in_contact(tick.sample);
    if (options_.on_tick) options_.on_tick(tick);
  }

  /// Does the work of the edit thread, every few milliseconds: passes the collected samples and the
  /// other events to the session in order of time, and publishes its force.
  Result<void> turn(std::int64_t now_ns) {
    ++report_.turns;
    Result<void> done;
    for (const PenSample& sample : samples_) {
      while (const Event* event = others_.next_before(sample.time_ns)) {
        if (done = report(*event); !done) return done;
      }
      done = session_.sample(sample);
      // A line that exceeds a limit draws nothing, as when it was recorded (Session::sample).
      if (!done && done.error().code != ErrorCode::kLimitExceeded) return done;
      done = {};
    }
    report_.samples += samples_.size();
    samples_.clear();
    while (const Event* event = others_.next_until(now_ns)) {
      if (done = report(*event); !done) return done;
    }
    publish(now_ns);
    return {};
  }

  void publish(std::int64_t now_ns) {
    servo_->heartbeat(now_ns);
    servo_->publish(session_.force());
  }

  Result<void> report(const Event& event) {
    const auto* import = std::get_if<ImportEvent>(&event.what);
    Result<void> done = import ? this->import(event.time_ns, *import) : session_.apply(event);
    if (done) return {};
    return tl::unexpected(with_context(done.error(), place_of(others_.index(), event)));
  }

  Result<void> import(std::int64_t time_ns, const ImportEvent& event) {
    if (!options_.read_import) return session_.apply({time_ns, event});
    const Result<VisibleInk> ink = options_.read_import(event);
    if (!ink) return tl::unexpected(ink.error());
    return session_.import(time_ns, event, ink->strokes, ink->fills);
  }

  [[nodiscard]] bool is_over(std::int64_t now_ns, std::int64_t last_ns) const noexcept {
    const std::int64_t since_ns = now_ns - last_ns;
    return since_ns >= kLongestSettleNs || (since_ns >= kSettleNs && !pen_is_down_);
  }

  Result<PlayReport> end(std::int64_t now_ns) {
    servo_->stop();
    report_.safety = servo_->latest().safety;
    report_.end_ns = now_ns;
    if (Result<void> done = session_.finish(); !done) return tl::unexpected(done.error());
    report_.edits = session_.edit_count() - edits_before_;
    return report_;
  }

  Session& session_;
  const PlayerOptions& options_;
  std::span<const Event> events_;
  OtherEvents others_;
  PoseTrack track_;
  PlayedDevice device_;
  std::unique_ptr<Servo> servo_;    // large
  std::vector<PenSample> samples_;  // since the last turn()
  bool pen_is_down_ = false;
  std::uint64_t edits_before_ = 0;
  PlayReport report_;
};

Player::Player(Device& device, HandInput* hand, Session& session, PlayerOptions options)
    : device_(device), hand_(hand), session_(session), options_(std::move(options)) {}

Result<PlayReport> Player::play(std::span<const Event> events) {
  if (Result<void> fine = check(events, options_, hand_ != nullptr); !fine) {
    return tl::unexpected(fine.error());
  }
  if (events.empty()) return PlayReport{};
  return Run(*this, events).play();
}

}  // namespace felt
