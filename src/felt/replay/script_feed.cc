#include "felt/replay/script_feed.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "felt/base/constants.h"
#include "felt/base/random.h"
#include "felt/stroke/fit/sample_faults.h"

namespace felt {
namespace {

// Mean speed of the hand between strokes. These motions are minimum-jerk paths, as in
// `script_hand`.
constexpr double kAirMmPerS = 250.0;
constexpr double kMinTravelS = 0.12;
constexpr double kRestS = 0.25;  // after the last stroke
constexpr double kMaxTravelS = 60.0;

// Limits of one raw stroke. They bound the memory, because it is proportional to the longest
// stroke.
constexpr double kMaxLengthMm = 20'000.0;
constexpr double kMaxDurationS = 600.0;
constexpr double kMaxReachMm = 1e4;
constexpr double kMaxPauseS = 1.0;  // the longest pause in script_hand

constexpr double kTremorRmsMm = 0.03;

/// Fails if a hand would need very long to draw the stroke.
Result<void> check_length(const RecordedPath& path) {
  double length_mm = 0.0, duration_s = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const RecordedPoint &a = path[i - 1], &b = path[i];
    length_mm += distance(a.position, b.position);
    if (!a.time_ns || !b.time_ns) continue;
    const double pause_s =
        1e-9 * (static_cast<double>(*b.time_ns) - static_cast<double>(*a.time_ns));
    duration_s += std::clamp(pause_s, 0.0, kMaxPauseS);
  }
  if (!(length_mm <= kMaxLengthMm)) {
    return fail(ErrorCode::kLimitExceeded,
                "points: the stroke is longer than 20 m, see --mm-per-unit");
  }
  if (!(duration_s <= kMaxDurationS)) {
    return fail(ErrorCode::kLimitExceeded, "points: the stroke takes longer than 10 minutes");
  }
  return {};
}

/// Returns the points on the page above which the hand waits before and after a stroke.
std::pair<Point, Point> ends_of(const RecordedPath& path, const std::vector<TimedAim>& aims) {
  const auto is_drawn = [](const RecordedPoint& p) {  // script_hand skips all other points
    return std::abs(p.position.x) <= kMaxReachMm && std::abs(p.position.y) <= kMaxCoordinateMm;
  };
  const auto first = std::find_if(path.begin(), path.end(), is_drawn);
  const auto last = std::find_if(path.rbegin(), path.rend(), is_drawn);
  return {first != path.end() ? first->position : on_page(aims.front().target_mm),
          last != path.rend() ? last->position : on_page(aims.back().target_mm)};
}

}  // namespace

Tremor::Tremor(std::uint64_t seed) {
  if (seed == 0) return;
  Random random(seed);
  for (Tone& tone : tones_) {
    tone = {random.between(8.0, 12.0), random.between(0.0, kTau), random.between(0.0, kTau)};
  }
  // The mean squares of tones with different frequencies add up.
  amplitude_mm_ = kTremorRmsMm * std::sqrt(2.0 / static_cast<double>(tones_.size()));
}

Vec Tremor::at(std::int64_t time_ns) const noexcept {
  if (amplitude_mm_ == 0.0) return {};
  const double t_s = 1e-9 * static_cast<double>(time_ns);
  Vec sum;
  for (const Tone& tone : tones_) {
    sum.x += std::sin(kTau * tone.hz * t_s + tone.phase_x);
    sum.y += std::sin(kTau * tone.hz * t_s + tone.phase_y);
  }
  return amplitude_mm_ * sum;
}

ScriptFeed::ScriptFeed(const FeedOptions& options, FeedSink sink)
    : options_(options), sink_(std::move(sink)), tremor_(options.seed) {}

Result<void> ScriptFeed::read(const std::string& name, ReadBytes read) {
  file_start_ns_ = now_ns_;
  file_strokes_ = 0;
  report_ = {};
  const ScriptSink lines{
      .event = [this](const Event& event) { return add_event(event); },
      .stroke = [this](const RawStroke& stroke) { return add_stroke(stroke); },
  };
  return read_script(name, std::move(read), lines);
}

void ScriptFeed::begin_play(std::int64_t from_ns) noexcept {
  now_ns_ = std::max(now_ns_, from_ns);
  is_fresh_ = true;
}

Result<void> ScriptFeed::add_event(const Event& event) {
  Event timed = event;
  timed.time_ns = now_ns_ = std::max(now_ns_, file_start_ns_ + event.time_ns);
  if (const auto* hand = std::get_if<HandEvent>(&event.what)) hand_ = hand->target;
  return sink_.event(timed);
}

RecordedPath ScriptFeed::path_of(const RawStroke& stroke) {
  SampleCheck check;
  for (const InkSample& sample : stroke.samples) check.add(sample);
  SampleFaults faults = check.faults();
  faults.needs_times = true;  // the hand draws at the recorded speed
  ++file_strokes_;
  report_.add_faults(0, stroke.id.empty() ? std::to_string(file_strokes_) : stroke.id, faults);
  RecordedPath path;
  for (const InkSample& sample : stroke.samples) {
    path.push_back(
        {{options_.mm_per_unit * sample.position.x, options_.mm_per_unit * sample.position.y},
         with_valid_pressure(sample).pressure,
         faults.has_no_clock ? std::nullopt : sample.time_ns,
         sample.tilt_deg});
  }
  return path;
}

Result<void> ScriptFeed::add_stroke(const RawStroke& stroke) {
  RecordedPath path = path_of(stroke);
  std::vector<Point> meant;
  for (const RecordedPoint& point : path) meant.push_back(point.position);
  if (Result<void> fine = check_length(path); !fine) return fine;
  HandScriptOptions hand = sink_.hand ? sink_.hand() : options_.hand;
  if (!is_fresh_) hand.lead_in_s = 0.0;
  is_fresh_ = false;
  const std::vector<TimedAim> aims = script_hand(std::span<const RecordedPath>(&path, 1), hand);
  if (aims.empty()) return {};
  // Between strokes the hand is at the pen's position; within a stroke its aims lead the pen.
  const auto [first, last] = ends_of(path, aims);
  if (Result<void> there = travel_to({first.x, first.y, hand.hover_mm}); !there) return there;
  if (sink_.stroke_begins) sink_.stroke_begins();
  const std::int64_t start_ns = now_ns_;
  for (const TimedAim& aim : aims) {
    if (Result<void> sent = put(aim, start_ns); !sent) return sent;
  }
  hand_ = Vec3{last.x, last.y, hand.hover_mm};
  ++strokes_;
  return sink_.stroke_drawn ? sink_.stroke_drawn(meant) : Result<void>();
}

Result<void> ScriptFeed::travel_to(const Vec3& target) {
  if (!hand_) return {};
  const Vec3 from = *hand_;
  const double duration_s = std::min(kMinTravelS + norm(target - from) / kAirMmPerS, kMaxTravelS);
  const double interval_s = 1e-9 * static_cast<double>(options_.hand.interval_ns);
  const auto steps = static_cast<std::int64_t>(std::ceil(duration_s / interval_s));
  const std::int64_t start_ns = now_ns_;
  for (std::int64_t i = 1; i <= steps; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(steps);
    const double part = t * t * t * (10.0 + t * (6.0 * t - 15.0));
    const TimedAim aim{.time_ns = options_.hand.interval_ns * i,
                       .target_mm = lerp(from, target, part)};
    if (Result<void> sent = put(aim, start_ns); !sent) return sent;
  }
  return {};
}

Result<void> ScriptFeed::put(const TimedAim& aim, std::int64_t start_ns) {
  now_ns_ = std::max(now_ns_, start_ns + aim.time_ns);
  hand_ = aim.target_mm;
  const Vec shake = tremor_.at(now_ns_);
  return sink_.event({now_ns_, HandEvent{.target = aim.target_mm + Vec3{shake.x, shake.y, 0.0},
                                         .pressure = aim.pressure,
                                         .tilt_deg = aim.tilt_deg}});
}

Result<void> ScriptFeed::rest() {
  if (strokes_ == 0 || !hand_) return {};
  const auto rest_ns = static_cast<std::int64_t>(1e9 * kRestS);
  return put({.time_ns = rest_ns, .target_mm = *hand_}, now_ns_);
}

}  // namespace felt
