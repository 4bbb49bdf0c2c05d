#include "desktop/help/script_player.h"

#include <algorithm>
#include <string>

#include "felt/replay/script_feed.h"
#include "felt/session/session_medium.h"

namespace felt::desktop {
namespace {

constexpr std::int64_t kTickNs = 1'000'000;
constexpr std::int64_t kSettleNs = 300'000'000;  // time for the pen to leave the surface at the
                                                 // end

/// Returns options for a practised hand on the present surface with the present medium.
HandScriptOptions hand_of(Studio& studio) {
  HandScriptOptions options = studio.loop().device().hand_options();
  const SurfaceMaterial& surface = studio.session().surface();
  const Capabilities& device = studio.session().device();
  const Medium* medium = studio.session().materials().find_medium(drawing_medium(studio.session()));
  set_surface(options, surface, device, medium);
  return options;
}

bool is_pose(const Event& event) {
  return std::holds_alternative<HandEvent>(event.what);
}

}  // namespace

Result<void> ScriptPlayer::load(const QString& name, std::string_view text) {
  events_.clear();
  FeedOptions options;
  options.hand = hand_of(studio_);
  FeedSink sink;
  sink.event = [this](const Event& event) -> Result<void> {
    events_.push_back(event);
    return {};
  };
  ScriptFeed feed(options, std::move(sink));
  feed.begin_play(0);
  Result<void> read = feed.read(name.toStdString(), read_text(text));
  if (read) read = feed.rest();
  if (!read) events_.clear();
  track_.emplace(events_);
  next_ = 0;
  played_ns_ = 0;
  length_ns_ = events_.empty() ? 0 : events_.back().time_ns + kSettleNs;
  return read;
}

void ScriptPlayer::advance(std::int64_t ns) {
  for (std::int64_t done = 0; done < ns && !is_over(); done += kTickNs) tick();
}

void ScriptPlayer::finish() {
  while (!is_over()) tick();
}

void ScriptPlayer::tick() {
  played_ns_ += kTickNs;
  while (next_ < events_.size() && events_[next_].time_ns <= played_ns_) {
    const Event& event = events_[next_++];
    if (!is_pose(event)) studio_.apply(event.what);
  }
  HandInput* hand = studio_.loop().device().hand();
  if (hand && track_ && track_->has_poses()) {
    const ScriptPose pose = track_->at(played_ns_);
    hand->aim(Aim{pose.position, pose.pressure, pose.buttons, pose.tilt_deg});
  }
  studio_.advance(kTickNs);
}

}  // namespace felt::desktop
