#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "felt/render/line_style.h"
#include "felt/stroke/outline/outline.h"
#include "felt/stroke/outline/outline_path.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// The ink of a stylised stroke.
struct StyledInk {
  /// Closed polygons that are filled together with the non-zero rule.
  Outline outline;
  /// The lines of the hatching, which are in `outline`, too. Each has the two dabs 2k and 2k + 1.
  std::vector<Dab> hatching;
};

/// The exact position of a dab along its stroke, in widths of the line.
struct RowMark {
  std::size_t dab = 0;
  double along = 0.0;
};

/// A row of dabs along the centre line of a stroke, for example the ink of a stroke in progress, in
/// any unit of length.
struct StyledRow {
  std::span<const Dab> dabs;  ///< if it is closed, the last is where the first is
  /// Indexes of dabs at joints that may be corners, ascending.
  std::span<const std::size_t> corners;
  bool closed = false;
  bool is_mirrored = false;   ///< the row is shown mirrored, so left and right are exchanged
  double units_per_mm = 0.0;  ///< for the hatching; 0 draws none
  /// Ascending, the last for the last dab. If there are any, the layout of a style does not depend
  /// on how finely the dabs were made, and `corners` are corners. May be empty.
  std::span<const RowMark> marks{};
};

/// Computes the ink of stylised strokes. The screen, pictures and vector files use the same ink.
///
/// A style is fitted to the line: positions along it are measured in widths of the line (the arc
/// length divided by the width there). The line is divided at declared corners of at least 30
/// degrees that are at least half a dash and gap apart. Each part gets a whole number of dashes or
/// repeats; lengths and gaps are scaled to fit.
/// A dash bends around each corner, half of it on either side. An open line begins and ends with a
/// whole dash or repeat; arrow heads end at the ends of the line. On a closed line without corners,
/// the pattern has no seam. Shapes are bent with the line. The two rails of a double line are
/// offset curves, without the loops that these have inside of bends tighter than the offset. A line
/// counts as closed for hatching if the distance between its ends is at most a tenth of its length
/// and a quarter of the diagonal of its box. Lines of the hatching are `spacing_mm` apart, have one
/// direction on the page, move with the start of the line, and are clipped to the inside of the
/// centre line by the even-odd rule.
///
/// A line shorter than half of its width is drawn as without a style. All results lie within the
/// plain ink, or inside the line for hatching, and have at most twice kMaxPoints points, because
/// long patterns are then repeated less often. Equal strokes give equal bytes. The positions of
/// dashes and repeats do not depend on the tolerance, so they are the same at every zoom and in
/// every file.
///
/// Keeps the ink of the strokes that were used last, because a drawing is painted in many tiles.
/// Not thread-safe.
class StrokeStyler {
 public:
  static constexpr std::size_t kMaxPoints = std::size_t{1} << 20;
  static constexpr std::size_t kMaxKept = 32;

  StrokeStyler();
  ~StrokeStyler();
  StrokeStyler(StrokeStyler&&) noexcept;
  StrokeStyler& operator=(StrokeStyler&&) noexcept;

  /// Returns the ink of a stroke. Requires tolerance_mm > 0. Valid until the next call.
  const StyledInk& ink(const Stroke& stroke, const StrokeStyle& style, double tolerance_mm);
  /// Returns the ink of a row of dabs. The tolerance has the unit of the row. Valid until the next
  /// call.
  const StyledInk& ink(const StyledRow& row, const StrokeStyle& style, double tolerance);
  /// Returns how many strokes have been stylised so far, without those that were kept.
  [[nodiscard]] std::size_t made_count() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Returns the ink of a stroke as paths for vector files: outline_path() if `style` is null.
OutlinePath styled_path(const Stroke& stroke, const StrokeStyle* style, double tolerance_mm);

}  // namespace felt
