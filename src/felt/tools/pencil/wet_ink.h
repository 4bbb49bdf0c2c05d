#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "felt/stroke/drawn_profile.h"
#include "felt/stroke/fit/ink_fitter.h"
#include "felt/stroke/fit/width_fitter.h"
#include "felt/stroke/fit/width_map.h"
#include "felt/tools/overlay.h"

namespace felt {

/// The picture of a stroke being drawn: the fitter's stable prefix and the provisional tail, cut
/// into pieces over which width and tone change linearly.
///
/// The prefix has the breakpoints of the finished stroke, and the widths that are drawn between
/// them (DrawnProfile). The last breakpoint so far starts an *open line*, whose slope may still
/// change; behind kOpenMm, it is fixed. A piece is made once, when it no longer changes, so the
/// time per sample does not depend on the length of the stroke. If the stroke is drawn into the
/// same overlay again, only the new pieces, the open line and the tail are copied.
class WetInk {
 public:
  static constexpr double kPieceMm = 2.0;  ///< about the longest piece
  static constexpr double kNodeMm = 0.25;
  static constexpr double kOpenMm = 30.0;
  /// Errors of the widths and tones within a piece. A piece is not shorter than kMinBendMm if it is
  /// cut only for these errors.
  static constexpr double kBendErrorMm = 0.002, kBendToneError = 0.02, kMinBendMm = 0.1;

  /// Starts a stroke with the widths and the width fit of these options.
  void begin(const InkFitOptions& options);
  /// Updates the picture. Call it after each InkFitter::push() with the same sample.
  void update(const InkFitter& fitter, const InkSample& sample);
  /// Returns the width at the pen, mm.
  [[nodiscard]] double width_mm() const noexcept { return pen_.width_mm; }
  /// Returns the width and the tone at the pen.
  [[nodiscard]] const InkWidth& ink() const noexcept { return pen_; }
  /// Adds the current picture of the stroke.
  void draw(InkFitter& fitter, Overlay& overlay) const;
  /// Adds samples that follow the picture and have not been passed to update() yet, because they
  /// may still move (SteadyLine::held).
  void draw_ahead(std::span<const InkSample> ahead, Overlay& overlay) const;

 private:
  /// Width and tone at a distance along the pen's path.
  struct Node {
    std::size_t sample = 0;
    double path_mm = 0.0;
    InkWidth ink;
  };

  /// A part of the stroke from one node of the drawn profile to the next.
  struct Line {
    Cubic curve;
    InkWidth from, to;
    ProfileLine profile;
    int min_pieces = 1;

    Line(const Cubic& c, const InkWidth& start, const InkWidth& end) noexcept;
  };

  void add_segment(const InkFitter& fitter, int i);
  void add_lines(const InkFitter& fitter);
  void fix_open_line(const InkFitter& fitter);
  /// Calls visit(line) for the lines from the start of the open line to its end `end`.
  template <class Visit>
  void for_each_line(const InkFitter& fitter, const WidthKnot& end, Visit visit) const;
  void close_line(const InkFitter& fitter, const WidthKnot& end);
  [[nodiscard]] WidthKnot open_end(double u) const noexcept;
  void add_node(Point pen);
  [[nodiscard]] InkWidth open_width(double path_mm) const;

  std::uint64_t stroke_ = 0;  // Overlay::ink_stroke
  std::vector<Overlay::InkSegment> pieces_;
  int segments_ = 0;          // fitter segments in pieces_
  std::size_t places_ = 0;    // fitter positions in pieces_
  std::size_t samples_ = 0;   // fitter samples in pieces_
  WidthMap stable_widths_;    // of the fitter's samples, up to samples_
  bool has_tone_ = false;     // samples have a tone of their own
  WidthFitter profile_;       // of the same samples
  std::size_t knots_ = 0;     // breakpoints of profile_ that were used
  WidthKnot open_{};          // start of the open line
  std::optional<Line> bent_;  // the line before it, whose end may still bend
  WidthMap pen_widths_;       // of all samples, as they arrived
  InkWidth stable_;

  // Widths of the tail, one node per kNodeMm; no node is added while the pen rests.
  std::vector<Node> nodes_;
  std::size_t first_node_ = 0;  // nodes before it are stable
  std::size_t taken_ = 0;       // samples passed to update()
  Point path_end_;
  Point last_;  // position of the last sample passed to update()
  double path_mm_ = 0.0;
  InkWidth pen_;
};

}  // namespace felt
