#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "felt/geometry/vec3.h"
#include "felt/session/event.h"

namespace felt {

/// The pose of the pen in a script at some time.
struct ScriptPose {
  std::int64_t time_ns = 0;
  Vec3 position;
  std::optional<double> pressure{};
  std::uint32_t buttons = 0;
  /// If true, a hand aims at `position`; otherwise `position` is that of the pen itself.
  bool by_hand = false;
  std::optional<double> tilt_deg{};

  friend constexpr bool operator==(const ScriptPose&, const ScriptPose&) noexcept = default;
};

/// Computes the pose of the pen between the pose events of a script, by the rules of
/// docs/formats/events.md ("Between two events"): straight lines between poses, but no ink on the
/// path to the point where the pen is put down, and a lift at the end. Time must only increase. A
/// tick takes constant time on average.
class PoseTrack {
 public:
  static constexpr std::int64_t kLongGapNs = 200'000'000;
  static constexpr std::int64_t kLandingNs = 50'000'000;
  static constexpr double kHoverMm = 5.0;
  /// Speed at which the pen comes down before the first pose.
  static constexpr double kLandingMmPerS = 100.0;

  /// Makes a track. The events must outlive it, and their times must not run backwards.
  explicit PoseTrack(std::span<const Event> events);

  /// Returns the pose at a time. Times must not run backwards from call to call.
  [[nodiscard]] ScriptPose at(std::int64_t now_ns);
  /// Returns false if the script has no poses; at() then returns a pen high above the surface.
  [[nodiscard]] bool has_poses() const noexcept { return last_.has_value() || next_.has_value(); }

 private:
  [[nodiscard]] std::optional<ScriptPose> find_next();

  std::span<const Event> events_;
  std::size_t searched_ = 0;        // events examined so far
  std::int64_t end_ns_ = 0;         // time of the last event of any kind
  std::optional<ScriptPose> last_;  // pose at or before now; initially, a pose above the first one
  std::optional<ScriptPose> next_;  // the first pose after now
};

/// Returns the pose at a time between a.time_ns and b.time_ns, interpolated between the two poses.
/// Exact at both ends.
ScriptPose between(const ScriptPose& a, const ScriptPose& b, std::int64_t now_ns) noexcept;

}  // namespace felt
