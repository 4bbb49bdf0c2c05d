#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/document.h"

namespace felt {

/// The rules that a raised drawing must keep, so that a fingertip can tell its parts apart.
/// Sources: [1] "Designing tactile graphics", https://www.tactilegraphics.org/designingtgs.html [2]
/// American Printing House for the Blind, "Guidelines for design of tactile graphics",
///     https://www.aph.org/edresearch/guides.htm
/// [3] Tacticos, handbook of tactile images, chapter 4, https://www.tacticos.eu
enum class TactileRule : std::uint8_t {
  kGap,         ///< lines that do not touch are at least TactileLimits::gap_mm apart [1] [2]
  kSmallShape,  ///< a shape is at least 12.7 mm (1/2 in) in one direction; dots may be smaller [1]
  kShortSide,   ///< a side between two corners of a closed line is at least 12.7 mm long [1]
  kNarrowArea,  ///< an area is at least 6.4 mm (1/4 in) wide, to be felt as an area [1] [2]
  kLineStyles,  ///< there are at most five widths of lines [2]
  kAreaStyles,  ///< areas do not differ only by their colour
  kSize,        ///< the drawing fits on A4; hands lose their way on a larger one [3]
  kThinLine,    ///< a line is at least kLineMm wide, a dot kDotMm: thinner ones do not rise
};

/// The names of the rules, as the command line and tables write them.
inline constexpr std::array<std::string_view, 8> kTactileRuleNames{
    "gap",         "small-shape", "short-side", "narrow-area",
    "line-styles", "area-styles", "size",       "thin-line"};

/// What is wrong at one position of a drawing.
struct TactileFault {
  TactileRule rule = TactileRule::kGap;
  Point at{};              ///< mm; the narrowest position of a gap, the middle of a shape
  double measured = 0.0;   ///< mm; for kLineStyles and kAreaStyles a number of styles
  double limit = 0.0;      ///< what the rule wants, in the same unit
  double length_mm = 0.0;  ///< kGap: how long the lines are too near each other
  StrokeId stroke{};       ///< zero if the fault is of a fill or of the whole drawing
  StrokeId other{};        ///< kGap: the other line; may be the same stroke

  friend bool operator==(const TactileFault&, const TactileFault&) = default;
};

struct TactileLimits {
  /// Distance between the edges of two lines. 6.4 mm (1/4 in) is needed on swell paper, whose lines
  /// have soft edges; 3.2 mm (1/8 in) is the minimum for any method [1] [2].
  double gap_mm = 6.4;
  /// The colour of the paper: ink that is not seen on it (is_seen) is not checked.
  Rgba paper{255, 255, 255, 255};

  static constexpr double kEmbossedGapMm = 3.2;
  static constexpr double kShapeMm = 12.7;
  static constexpr double kAreaMm = 6.4;
  /// The mean width of a line: half of that of the thin pen for swell paper. Feltline's own choice.
  static constexpr double kLineMm = 0.5;
  /// The width of a dot: about that of braille, 1.44 mm.
  static constexpr double kDotMm = 1.4;
  static constexpr std::size_t kLineStyles = 5;
  /// Widths that differ by less are one style, mm: Feltline's own choice.
  static constexpr double kStyleMm = 0.5;
  static constexpr double kLongMm = 297.0;  ///< A4
  static constexpr double kShortMm = 210.0;
};

/// The longest total length of the lines that can be checked: 100 m. More than an A4 page can hold.
inline constexpr double kMaxTactileMm = 100'000.0;

/// Returns the factor by which a drawing, with the widths of its lines, must be enlarged to remove
/// all faults that depend on size (all but kLineStyles, kAreaStyles and kSize), rounded up to
/// tenths; 1 if there are none. Infinity if one of them measures 0.
double tactile_enlargement(const std::vector<TactileFault>& faults) noexcept;

/// Returns true for the rules whose faults can be removed by enlarging the drawing.
constexpr bool depends_on_size(TactileRule rule) noexcept {
  return rule != TactileRule::kLineStyles && rule != TactileRule::kAreaStyles &&
         rule != TactileRule::kSize;
}

/// Checks the visible layers of a document, without their pictures and without ink that is not seen
/// on the paper. Lines that touch or cross are
/// joined: near a junction they may be closer than the limit, unless they leave it at an angle of
/// less than about 29 degrees, because then a fingertip feels one broad line. Returns the faults in
/// the order of the rules, and for one rule in the order of the strokes. Fails if the lines are
/// longer than kMaxTactileMm. Takes time proportional to the number of pairs of points within the
/// gap: 0.5 s for 20 m of hatching with lines 2 mm apart.
Result<std::vector<TactileFault>> check_tactile(const Document& document,
                                                const TactileLimits& limits = {});

}  // namespace felt
