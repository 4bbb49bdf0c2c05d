#pragma once

#include <cstdint>
#include <vector>

#include "felt/stroke/fit/ink_fitter.h"
#include "felt/stroke/fit/width_map.h"
#include "felt/tools/overlay.h"

namespace felt {

/// The picture of a stroke being drawn: the fitter's stable prefix, cut into pieces over which
/// width and tone change linearly, and the provisional tail.
///
/// A piece is made once, when its segment becomes stable, so the time per sample does not depend on
/// the length of the stroke. If the stroke is drawn into the same overlay again, only the new
/// pieces and the tail are copied.
class WetInk {
 public:
  static constexpr double kPieceMm = 2.0;
  static constexpr double kNodeMm = 0.25;

  void begin(const WidthMapOptions& widths);
  /// Updates the picture. Call it after each InkFitter::push() with the same sample.
  void update(const InkFitter& fitter, const InkSample& sample);
  /// Returns the width at the pen, mm.
  [[nodiscard]] double width_mm() const noexcept { return pen_.width_mm; }
  /// Adds the current picture of the stroke.
  void draw(InkFitter& fitter, Overlay& overlay) const;

 private:
  /// Width and tone at a distance along the pen's path.
  struct Node {
    std::size_t sample = 0;
    double path_mm = 0.0;
    InkWidth ink;
  };

  void add_segment(const InkFitter& fitter, int i);
  void add_node(Point pen);
  [[nodiscard]] InkWidth open_width(double path_mm) const;

  std::uint64_t stroke_ = 0;  // Overlay::ink_stroke
  std::vector<Overlay::InkSegment> pieces_;
  int segments_ = 0;         // fitter segments in pieces_
  std::size_t places_ = 0;   // fitter positions in pieces_
  std::size_t samples_ = 0;  // fitter samples in pieces_
  WidthMap stable_widths_;   // of the fitter's samples, up to samples_
  WidthMap pen_widths_;      // of all samples, as they arrived
  InkWidth stable_;

  // Widths of the tail, one node per kNodeMm; no node is added while the pen rests.
  std::vector<Node> nodes_;
  std::size_t first_node_ = 0;  // nodes before it are stable
  std::size_t taken_ = 0;       // samples passed to update()
  Point path_end_;
  double path_mm_ = 0.0;
  InkWidth pen_;
};

}  // namespace felt
