#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "felt/gather/line_sections.h"

namespace felt {

/// Finds hatchings: rows of at least kMinLines straight lines that lie beside each other at regular
/// distances without crossing, for example shading, a staff or a ruled page. Someone who draws one
/// line several times crosses it and leaves irregular gaps, so the lines of a hatching are not
/// rough lines of one stroke.
///
///   HatchingFinder finder(count);
///   for each line: finder.add(section) for all its sections, then finder.end_line(line, points)
///   finder.hatchings();
class HatchingFinder {
 public:
  static constexpr std::size_t kMinLines = 4;

  explicit HatchingFinder(std::size_t lines) : neighbours_(lines) {}

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
    double share = 0.0;   ///< of the sections in which it is the nearest
    double gap_mm = 0.0;  ///< mean distance
  };
  struct Nearest {
    std::uint32_t line = 0;
    double gap_mm = 0.0;
  };

  [[nodiscard]] static Neighbour usual_neighbour(std::vector<Nearest>& hits, double sections);
  [[nodiscard]] const Neighbour* next(std::uint32_t line, Side side) const;
  [[nodiscard]] std::vector<std::uint32_t> row_from(std::uint32_t line,
                                                    std::vector<bool>& visited) const;
  [[nodiscard]] double gap_mm(std::uint32_t a, std::uint32_t b) const;
  void number_runs(const std::vector<std::uint32_t>& row, std::uint32_t& last,
                   std::vector<Numbers>& numbers) const;

  std::vector<std::array<Neighbour, 2>> neighbours_;  // of each line, by side
  std::array<std::vector<Nearest>, 2> hits_;          // of the current line, by side
};

/// Returns true if both lines are in the same hatching.
bool share_hatching(const HatchingFinder::Numbers& a, const HatchingFinder::Numbers& b) noexcept;

}  // namespace felt
