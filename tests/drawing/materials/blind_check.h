#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "felt/devices/simulated/stroke_forces.h"
#include "felt/material/materials.h"

namespace felt {

/// One of the combinations to tell apart: a medium on a surface.
struct Choice {
  std::string id;  ///< the name in the report
  const SurfaceMaterial* surface = nullptr;
  const Medium* tool = nullptr;
};
/// Returns `tool` on each built-in surface. The surface gives the id.
std::vector<Choice> surfaces_under(std::string_view tool);
/// Returns each built-in medium on `surface`. The medium gives the id.
std::vector<Choice> media_on(std::string_view surface);

/// Tests whether the choices can be told apart by their forces alone. The same strokes are drawn
/// with each choice. Some of them give the centroid of each choice's features; each of the others
/// is assigned to the nearest centroid. Distances are in units of the spread within a choice.
struct BlindCheck {
  std::string name;  ///< for example "touch"
  std::string_view device = "touch";
  std::int64_t period_ns = 1'000'000;
  std::vector<Choice> choices;
  int learn = 40;  ///< strokes of each choice to learn from
  int judge = 60;  ///< strokes of each choice to be assigned to a choice
};

/// Returns the checks that docs/materials.md reports, each on an entry-level device and on a better
/// one: the pencil on every surface, and every medium on kMediaSurface, because all media can be
/// felt best on it.
std::vector<BlindCheck> blind_checks_of_surfaces();
std::vector<BlindCheck> blind_checks_of_media();
inline constexpr std::string_view kMediaSurface = "rough-paper";

/// counts[i][j] is the number of strokes of choice i that were assigned to choice j.
struct Confusion {
  std::vector<std::string> ids;  ///< ids of the choices
  std::vector<std::vector<int>> counts;
  /// Share of the strokes of choices i and j that are assigned correctly if only these two are
  /// possible; 0.5 is chance.
  std::vector<std::vector<double>> of_two;
  bool is_sound = true;  ///< the safety chain reported no fault in any stroke

  [[nodiscard]] double accuracy() const;
  /// Returns the number of pairs with a share of at least kDistinct in of_two. pairs() returns the
  /// number of all pairs.
  [[nodiscard]] int distinct_pairs() const;
  [[nodiscard]] int pairs() const;
  /// Returns the table as text.
  [[nodiscard]] std::string text() const;
};

/// Smallest share of correct assignments at which two choices are called distinct.
inline constexpr double kDistinct = 0.9;

/// Runs the check with strokes of a typical hand at 50 to 150 mm/s and 0.5 to 0.8 N. The seeds are
/// fixed, so each run gives the same result.
Confusion run_blind_check(const BlindCheck& check);

/// Returns the pairs that cannot be told apart, for example "touch: paper, wood", as
/// docs/materials.md lists them.
std::vector<std::string> alike_pairs(const BlindCheck& check, const Confusion& confusion);
std::string name_of_pair(const BlindCheck& check, std::size_t i, std::size_t j);

}  // namespace felt
