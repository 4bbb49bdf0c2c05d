#pragma once

#include <cstdint>
#include <vector>

#include "felt/stroke/fit/ink_fitter.h"
#include "felt/stroke/fit/width_map.h"
#include "felt/tools/overlay.h"

namespace felt {

/// The picture of a stroke that is being drawn: the fitter's stable prefix, cut into pieces short
/// enough that a straight change of width and tone does, and the provisional tail.
///
/// A piece is made once, when its segment becomes stable: a sample costs what it adds, whatever the
/// length of the stroke. Showing it again in the same overlay costs what is new and the tail.
class WetInk {
 public:
  static constexpr double kPieceMm = 2.0;
  static constexpr double kNodeMm = 0.25;

  void begin(const WidthMapOptions& widths);
  /// After each sample of the fitter; `sample` is the one that it was given.
  void update(const InkFitter& fitter, const InkSample& sample);
  /// Width at the pen, mm.
  [[nodiscard]] double width_mm() const noexcept { return pen_.width_mm; }
  /// Adds the stroke as it is now.
  void draw(InkFitter& fitter, Overlay& overlay) const;

 private:
  /// Width and tone where the pen was after some way.
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
  int segments_ = 0;         // of the fitter, in pieces_
  std::size_t places_ = 0;   // likewise
  std::size_t samples_ = 0;  // likewise
  WidthMap stable_widths_;   // of the samples as the fitter took them, up to samples_
  WidthMap pen_widths_;      // of the samples as they came
  InkWidth stable_;

  // The widths of the tail, a node each kNodeMm: as many as the fitter holds back, at rest none.
  std::vector<Node> nodes_;
  std::size_t first_node_ = 0;  // those before it are stable
  std::size_t taken_ = 0;       // samples
  Point path_end_;
  double path_mm_ = 0.0;
  InkWidth pen_;
};

}  // namespace felt
