#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "felt/gather/line_sections.h"

namespace felt {

/// Finds hatchings: rows of lines that lie beside each other at regular distances without crossing,
/// for example shading, a staff, a ruled page, or two parallels. Someone who draws one line several
/// times crosses it and leaves irregular gaps, so the lines of a hatching are not rough lines of
/// one stroke. The fewer lines, the more regular they must be (docs/design/gather.md).
///
///   HatchingFinder finder(count, ink_mm);
///   for each line: finder.add(section) for all its sections, then finder.end_line(line, points)
///   finder.hatchings();
class HatchingFinder {
 public:
  /// `ink_mm` is the usual width of the lines: two or three lines whose ink nearly touches are one
  /// line that was drawn again.
  HatchingFinder(std::size_t lines, double ink_mm)
      : ink_mm_(ink_mm), neighbours_(lines), shapes_(lines) {}

  /// Adds one section of the current line.
  void add(const LineSection& section);
  /// Ends the sections of a line. `points` are its resampled points: one more than its sections.
  void end_line(std::uint32_t line, std::span<const Point> points);
  /// The numbers of the hatchings that a line is in, from 1; 0 stands for none. The line between
  /// two hatchings is in both.
  using Numbers = std::array<std::uint32_t, 2>;
  /// Returns the hatchings of each line.
  [[nodiscard]] std::vector<Numbers> hatchings() const;

 private:
  static constexpr std::uint32_t kNoLine = 0xffffffff;
  enum Side : std::size_t { kBelow, kAbove };

  /// The line that is nearest on one side in most sections.
  struct Neighbour {
    std::uint32_t line = kNoLine;
    double share = 0.0;         ///< of the sections in which it is the nearest
    double gap_mm = 0.0;        ///< mean distance
    double deviation_mm = 0.0;  ///< its standard deviation
  };
  struct Shape {
    double bend = 0.0;       ///< largest distance from the chord, as a share of the chord
    double length_mm = 0.0;  ///< of the path
  };
  /// Two lines beside each other.
  struct Couple {
    double bend = 0.0;       ///< of the line that is bent more
    double length_mm = 0.0;  ///< of the shorter line
    double gap_mm = 0.0;     ///< mean distance
    double deviation = 0.0;  ///< standard deviation of the distance, as a share of it
    double beside = 0.0;     ///< share of the shorter line that lies beside the other
  };
  struct Nearest {
    std::uint32_t line = 0;
    double gap_mm = 0.0;
  };

  [[nodiscard]] static Neighbour usual_neighbour(std::vector<Nearest>& hits, double sections);
  [[nodiscard]] const Neighbour* next(std::uint32_t line, Side side) const;
  [[nodiscard]] std::vector<std::uint32_t> row_from(std::uint32_t line,
                                                    std::vector<bool>& visited) const;
  [[nodiscard]] Couple couple(std::uint32_t a, std::uint32_t b) const;
  static std::size_t run_length(std::span<const Couple> couples, std::size_t first,
                                const std::function<bool(std::size_t)>& fits);
  void number_runs(const std::vector<std::uint32_t>& row, std::uint32_t& last,
                   std::vector<Numbers>& numbers) const;

  double ink_mm_;
  std::vector<std::array<Neighbour, 2>> neighbours_;  // of each line, by side
  std::vector<Shape> shapes_;                         // of each line
  std::array<std::vector<Nearest>, 2> hits_;          // of the current line, by side
};

/// Returns true if both lines are in the same hatching.
bool share_hatching(const HatchingFinder::Numbers& a, const HatchingFinder::Numbers& b) noexcept;

}  // namespace felt
