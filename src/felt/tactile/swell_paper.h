#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "felt/tactile/tactile_check.h"

namespace felt {

/// The numbers of a drawing for swell paper, on which black ink rises when it is heated.
/// Sources: [1] to [3] as in TactileRule; [4]
/// https://tactilelibrary.com/creating-tactile-graphics-for-swell-form-machines-and-swell-touch-paper
/// [5] https://www.brailleauthority.org/size-and-spacing-braille-characters
/// [6] https://github.com/tactile-graphics/guides/wiki
struct SwellRules {
  /// The narrowest line: that of the thin pen for swell paper. The lines of the thick pen are 3 mm
  /// wide, the fifth step of kStyleMm. A narrower line rises less [4].
  static constexpr double kLineMm = 1.0;
  /// The smallest dot: about that of braille, 1.44 mm [5].
  static constexpr double kDotMm = 1.5;
  /// Distance between a texture and the ink and edges around it: the absolute minimum between two
  /// elements. It is the white space between a texture and its outline [1].
  static constexpr double kWhiteMm = 3.2;
  /// A texture is at least so wide, to be felt as one [1].
  static constexpr double kTextureMm = 6.4;
  /// Distance between the lines of a texture: less than TactileLimits::gap_mm, so that they feel
  /// like one rough area, and more than twice the width of a line (chosen).
  static constexpr double kPitchMm = 2.5;
  static constexpr std::size_t kTextures = 5;  ///< the most that fingers keep apart [6]
};

/// What prepare_for_swell_paper() has changed.
struct SwellReport {
  std::size_t lines = 0;
  std::size_t widened = 0;        ///< lines that were too narrow on average
  std::size_t made_even = 0;      ///< other lines whose width varied, or differed within a style
  std::vector<double> widths_mm;  ///< of the line styles, ascending
  std::size_t recolored = 0;      ///< lines that were not black, or not opaque
  std::size_t textures = 0;       ///< areas that have a texture
  std::size_t outlines = 0;       ///< areas that are too narrow for a texture
  std::size_t area_colors = 0;    ///< of the areas; more than kTextures share textures
  std::size_t pictures = 0;       ///< pictures that were left out
  std::size_t unseen_lines = 0;   ///< lines that are not seen on the paper and were left out
  std::size_t unseen_areas = 0;   ///< the same for areas
  std::size_t faults = 0;         ///< faults of the lines (check_tactile) that are left

  /// Returns what was changed, one sentence of plain English for each kind of change.
  [[nodiscard]] std::vector<std::string> sentences() const;
};

/// Returns a drawing that can be printed on swell paper at true size: only black, opaque lines on
/// white paper.
///
///   * Hidden layers, pictures and the surface are left out, and so is ink that is not seen on the
///     paper of the drawing (is_seen); all layers are opaque. Unseen areas still cover what lies
///     below them.
///   * Each line has one width. Lines whose mean widths differ by less than
///     TactileLimits::kStyleMm have the same width, at least SwellRules::kLineMm; there are at
///     most TactileLimits::kLineStyles widths, kStyleMm apart. Dots keep their size if it is at
///     least kDotMm.
///   * Each area becomes a texture of lines or dots by its colour, with a white space around it,
///   and
///     a line along its edge where the drawing has none. An area that is too narrow gets the line
///     only.
///
/// Equal drawings give equal results. Fails like check_tactile(), and if an area is so large or has
/// so many corners that its texture would take more than kMaxTextureTests tests.
Result<Drawing> prepare_for_swell_paper(const Drawing& drawing, SwellReport& report);
inline constexpr std::size_t kMaxTextureTests = 400'000'000;

}  // namespace felt
