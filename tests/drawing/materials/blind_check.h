#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "felt/devices/simulated/felt_stroke.h"
#include "felt/material/materials.h"

namespace felt {

/// What a hand may have before it: a pen on a sheet.
struct Choice {
  std::string id;  ///< how a report calls it
  const SurfaceMaterial* surface = nullptr;
  const Medium* tool = nullptr;
};
/// Every built-in sheet under this pen, called by the sheet.
std::vector<Choice> sheets_under(std::string_view tool);
/// Every built-in medium on this sheet, called by the medium.
std::vector<Choice> media_on(std::string_view surface);

/// Which of them is it? The same strokes are drawn with each choice, some to learn from, others to
/// be judged: by the nearest centroid of what was felt, in units of how much a choice's own strokes
/// differ.
struct BlindCheck {
  std::string name;  ///< "touch"
  std::string_view device = "touch";
  std::int64_t period_ns = 1'000'000;
  std::vector<Choice> choices;
  int learn = 40;  ///< strokes of each choice to learn from
  int judge = 60;  ///< others of each choice, to be judged
};

/// What docs/materials.md reports, on an entry-level device and a better one: every sheet under the
/// pencil, and every medium on the sheet with the most to feel for all.
std::vector<BlindCheck> blind_checks_of_sheets();
std::vector<BlindCheck> blind_checks_of_media();
inline constexpr std::string_view kMediaSheet = "rough-paper";

/// counts[i][j]: strokes of choice i that were taken for choice j.
struct Confusion {
  std::vector<std::string> ids;  ///< of the choices
  std::vector<std::vector<int>> counts;
  /// The same where only these two were to choose from, right in how many of all: 0.5 is chance.
  std::vector<std::vector<double>> of_two;
  bool is_sound = true;  ///< no stroke troubled the safety chain

  [[nodiscard]] double accuracy() const;
  /// How many pairs are told apart as often as kDistinct, and how many there are.
  [[nodiscard]] int distinct_pairs() const;
  [[nodiscard]] int pairs() const;
  /// The table as text.
  [[nodiscard]] std::string text() const;
};

/// At least this share must be right between two that are called distinct.
inline constexpr double kDistinct = 0.9;

/// Strokes at 50 to 150 mm/s and 0.5 to 0.8 N of a typical hand, seeded.
Confusion run_blind_check(const BlindCheck& check);

/// Pairs that cannot be told apart, "touch: paper, wood": what docs/materials.md lists.
std::vector<std::string> alike_pairs(const BlindCheck& check, const Confusion& confusion);
std::string name_of_pair(const BlindCheck& check, std::size_t i, std::size_t j);

}  // namespace felt
