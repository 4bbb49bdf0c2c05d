#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "felt/geometry/point.h"

namespace felt {

/// Tracks a pen: its speed, its heading, and the shape it has drawn since begin(). A sample takes
/// constant time, and the memory does not grow. Not thread-safe.
class PenTrack {
 public:
  /// Minimum distance between stored points, so that a pen that trembles in one place does not add
  /// to the path.
  static constexpr double kNodeMm = 0.2;
  /// Distance over which a direction is measured. Over this distance, the direction changes by less
  /// than 15 degrees because of a tremor of 0.1 mm, or because of four times the noise of a tablet.
  static constexpr double kChordMm = 0.8;
  /// The first direction is measured between these distances from the start. Nearer to the start,
  /// the ink is often only a hook that the pen makes when it lands.
  static constexpr double kFirstFromMm = 0.3, kFirstToMm = 1.8;

  /// Starts a path at this position.
  void begin(Point start, std::int64_t time_ns) noexcept;
  /// Appends a position. Requires finite coordinates. If the time does not increase, the speed
  /// stays as it was.
  void push(Point pen, std::int64_t time_ns) noexcept;

  [[nodiscard]] Point start() const noexcept { return start_; }
  [[nodiscard]] Point pen() const noexcept { return pen_; }
  /// Returns the speed, mm/s. It is low-passed over about 15 ms, because sampled positions jump by
  /// the resolution of the sensor.
  [[nodiscard]] double speed_mm_per_s() const noexcept { return norm(velocity_); }
  /// Returns the unit direction in which the pen will probably draw the next `ahead_mm`: the
  /// direction of the last kChordMm, turned further according to the current curvature of the path.
  /// Returns nullopt if the path is shorter than kChordMm.
  [[nodiscard]] std::optional<Vec> heading(double ahead_mm) const noexcept;
  /// Returns the unit direction in which the path began, or nullopt if the path is shorter than
  /// kFirstToMm.
  [[nodiscard]] std::optional<Vec> first_direction() const noexcept { return first_direction_; }
  /// Returns the shortest distance from a point to the last 3 mm of the path.
  [[nodiscard]] double passed_within_mm(Point target) const noexcept;

  /// Returns the length of the path.
  [[nodiscard]] double length_mm() const noexcept { return length_mm_; }
  /// Returns the largest distance from the start.
  [[nodiscard]] double extent_mm() const noexcept { return extent_mm_; }
  /// Returns the signed area between the path and the chord back to the start.
  [[nodiscard]] double area_mm2() const noexcept { return area_mm2_; }
  /// Returns the signed number of turns of the direction: about 1 or -1 for an outline, more for a
  /// coil.
  [[nodiscard]] double turns() const noexcept { return turns_; }

 private:
  static constexpr std::size_t kNodes = 32;

  void add_node(Point pen) noexcept;
  /// Returns the i-th node before the pen; 0 is the latest.
  [[nodiscard]] Point node(std::size_t i) const noexcept;
  /// Returns the point at this distance back along the path, or nullopt if the path is shorter.
  [[nodiscard]] std::optional<Point> back(double distance_mm) const noexcept;
  [[nodiscard]] double open_step_mm() const noexcept { return distance(node(0), pen_); }

  Point start_, pen_;
  std::int64_t time_ns_ = 0;
  Vec velocity_;  // mm/s
  std::array<Point, kNodes> nodes_{};
  std::size_t latest_ = 0, count_ = 0;
  double length_mm_ = 0.0, extent_mm_ = 0.0, area_mm2_ = 0.0, turns_ = 0.0;
  Point turn_from_;               // start of the current step for turns_ ...
  std::optional<Vec> turn_step_;  // ... and the step before it
  std::optional<Point> first_from_;
  std::optional<Vec> first_direction_;
};

}  // namespace felt
