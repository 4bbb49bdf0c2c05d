#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "felt/motion/oriented_pair.h"
#include "felt/motion/stroke_blend.h"

namespace felt {

/// A stroke between two key drawings: the blend, and both strokes.
struct LinkedBlend {
  OrientedPair keys;
  StrokeBlend blend;
};

/// One end of a blend, and how far it is from the point at which it is held, in both keys.
struct BlendEnd {
  std::size_t blend = 0;
  bool is_end = false;  ///< the last point, not the first
  Vec a_offset, b_offset;
};

/// Ends that touch each other in both key drawings.
struct EndCluster {
  std::vector<BlendEnd> ends;
};

/// An end that touches another line in both key drawings, at these parameters of its blend.
struct EndOnLine {
  BlendEnd end;
  std::size_t line = 0;
  double a_v = 0.0, b_v = 0.0;
};

/// Where ends of strokes are held together between two key drawings.
struct EndLinks {
  std::vector<EndCluster> clusters;
  std::vector<EndOnLine> on_lines;  ///< in the order of their blends
};

/// Finds the ends that touch other ends or lines in both key drawings: their ink overlaps, or
/// nearly. Takes quadratic time in the number of blends.
EndLinks find_end_links(std::span<const LinkedBlend> blends);

/// Moves the ends of all poses, one for each blend at the time t, to where they are held. An end in
/// a cluster is held at the mean of the cluster's ends, an end on a line at that line.
void hold_ends(std::span<const LinkedBlend> blends, const EndLinks& links, double t,
               std::span<BlendPose> poses);

}  // namespace felt
