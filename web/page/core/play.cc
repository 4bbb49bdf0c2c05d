#include <algorithm>
#include <utility>

#include "felt/replay/script_feed.h"
#include "felt/session/session_medium.h"
#include "web/page/core/studio.h"

namespace felt::page {

/// A script in progress: the poses move the simulated hand, the other events go to the session.
struct Studio::Play {
  std::vector<Event> events;
  std::optional<PoseTrack> track;
  std::string device;  // to return to
  std::size_t next = 0;
  std::int64_t played_ns = 0;
  double speed = 1.0;
  std::int64_t length_ns = 0;
};

namespace {

constexpr std::string_view kPlayDevice = "simulated:touch";
constexpr std::int64_t kSettleNs = 300'000'000;  // until the pen has left the surface

}  // namespace

Studio::Studio() {
  static_cast<void>(use_device(kTablet));
  make_session(Document{}, {}, Options::kFirst);
}

Studio::~Studio() = default;

Result<void> Studio::play(const std::string& name, std::string_view text, double mm_per_unit,
                          double speed) {
  stop_play();
  begin_forces();
  auto play = std::make_unique<Play>();
  play->device = device_id_;
  play->speed = std::clamp(speed, 1.0, 20.0);
  if (Result<void> used = use_device(kPlayDevice); !used) return used;
  FeedOptions options;
  options.mm_per_unit = mm_per_unit;
  options.hand = hand_options_;
  set_surface(options.hand, session_->surface(), session_->device(),
              session_->materials().find_medium(drawing_medium(*session_)));
  FeedSink sink;
  sink.event = [&events = play->events](const Event& event) -> Result<void> {
    events.push_back(event);
    return {};
  };
  ScriptFeed feed(options, std::move(sink));
  feed.begin_play(0);
  Result<void> read = feed.read(name, read_text(text));
  if (read) read = feed.rest();
  if (!read) {
    static_cast<void>(use_device(play->device));
    return read;
  }
  play->track.emplace(play->events);
  play->length_ns = play->events.empty() ? 0 : play->events.back().time_ns + kSettleNs;
  play_ = std::move(play);
  return {};
}

double Studio::play_speed() const noexcept {
  return play_ ? play_->speed : 1.0;
}

double Studio::played() const noexcept {
  if (!play_ || play_->length_ns <= 0) return 1.0;
  return std::min(1.0,
                  static_cast<double>(play_->played_ns) / static_cast<double>(play_->length_ns));
}

void Studio::step_play() {
  Play& play = *play_;
  const std::int64_t now = play.played_ns += servo_->options().period_ns;
  while (play.next < play.events.size() && play.events[play.next].time_ns <= now) {
    const Event& event = play.events[play.next++];
    if (std::holds_alternative<HandEvent>(event.what)) continue;
    if (Result<void> done = apply(event.what); !done) {
      play_error_ = done.error().message;
      play.played_ns = play.length_ns;
      break;
    }
  }
  if (play.track->has_poses()) {
    const ScriptPose pose = play.track->at(now);
    stylus_->aim(Aim{pose.position, pose.pressure, pose.buttons, pose.tilt_deg});
    pen_.hand = {pose.position.x, pose.position.y};
  }
  if (play.played_ns >= play.length_ns) stop_play();
}

void Studio::stop_play() {
  if (!play_) return;
  const std::unique_ptr<Play> ended = std::move(play_);
  static_cast<void>(use_device(ended->device));
}

}  // namespace felt::page
