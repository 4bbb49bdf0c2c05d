#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "felt/geometry/point.h"

namespace felt {

/// Follows a pen: how fast it moves, where it is heading, and what shape it has drawn since
/// begin(). A sample costs constant time and memory. One thread.
class PenTrack {
 public:
  /// Distance between stored points. A pen that trembles on the spot does not travel.
  static constexpr double kNodeMm = 0.2;
  /// Distance over which a direction is measured: four times the noise of a tablet and a tremor of
  /// 0.1 mm turn it by less than 15 degrees.
  static constexpr double kChordMm = 0.8;
  /// The first direction is that of the ink between these distances from the start. What lies
  /// before is often the hook of a landing pen.
  static constexpr double kFirstFromMm = 0.3, kFirstToMm = 1.8;

  /// Starts a path here.
  void begin(Point start, std::int64_t time_ns) noexcept;
  /// Appends a position. Requires finite coordinates. Times that do not increase leave the speed as
  /// it was.
  void push(Point pen, std::int64_t time_ns) noexcept;

  [[nodiscard]] Point start() const noexcept { return start_; }
  [[nodiscard]] Point pen() const noexcept { return pen_; }
  /// Low-passed over about 15 ms, because sampled positions jump by the resolution of the sensor.
  [[nodiscard]] double speed_mm_per_s() const noexcept { return norm(velocity_); }
  /// Unit direction in which the pen will probably draw the next `ahead_mm`: that of the last
  /// kChordMm, turned as much further as the path was bending. Nothing before kChordMm of path.
  [[nodiscard]] std::optional<Vec> heading(double ahead_mm) const noexcept;
  /// Unit direction in which the path began. Nothing before kFirstToMm of path.
  [[nodiscard]] std::optional<Vec> first_direction() const noexcept { return first_direction_; }
  /// Shortest distance from a point to the last few millimetres of the path.
  [[nodiscard]] double passed_within_mm(Point target) const noexcept;

  /// Length of the path.
  [[nodiscard]] double length_mm() const noexcept { return length_mm_; }
  /// Largest distance from the start.
  [[nodiscard]] double extent_mm() const noexcept { return extent_mm_; }
  /// Signed area between the path and the chord back to the start.
  [[nodiscard]] double area_mm2() const noexcept { return area_mm2_; }
  /// Whole turns of the direction, signed: about 1 or -1 for an outline, more for a coil.
  [[nodiscard]] double turns() const noexcept { return turns_; }

 private:
  static constexpr std::size_t kNodes = 32;

  void add_node(Point pen) noexcept;
  /// The i-th node before the pen, 0 being the latest.
  [[nodiscard]] Point node(std::size_t i) const noexcept;
  /// The point this far back along the path, or nothing.
  [[nodiscard]] std::optional<Point> back(double distance_mm) const noexcept;
  [[nodiscard]] double open_step_mm() const noexcept { return distance(node(0), pen_); }

  Point start_, pen_;
  std::int64_t time_ns_ = 0;
  Vec velocity_;  // mm/s
  std::array<Point, kNodes> nodes_{};
  std::size_t latest_ = 0, count_ = 0;
  double length_mm_ = 0.0, extent_mm_ = 0.0, area_mm2_ = 0.0, turns_ = 0.0;
  Point turn_from_;               // where the last step for turns_ began ...
  std::optional<Vec> turn_step_;  // ... and the one before it
  std::optional<Point> first_from_;
  std::optional<Vec> first_direction_;
};

}  // namespace felt
