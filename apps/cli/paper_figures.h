#pragma once

#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/drawing.h"
#include "felt/haptics/force_law.h"
#include "overlay_picture.h"

namespace felt::cli {

/// A figure of the paper, as this program draws it.
struct PaperFigure {
  SessionView view;
  Rect area;  ///< the part of the page that it shows
  std::string caption;
};

/// What holds the head of the cat while figures 3 and 4 turn it.
struct HeldHead {
  std::vector<Point> anchors;  ///< the first control points that are not selected
  Point centre;                ///< of the turn
  Point grab;                  ///< where the pen grabbed the head
};

/// The four figures, and the numbers of the last two.
struct PaperFigures {
  std::vector<PaperFigure> figures;
  HeldHead head;
};

/// Plays the figures of the paper with a simulated hand, the simulated PHANToM Premium and this
/// form of the forces: 1, the stylus on the surface; 2, a sketch as its segments; 3 and 4, the head
/// of a cat while it is turned, at two moments. The same form gives the same figures.
Result<PaperFigures> paper_figures(LawForm law);

/// Returns the drawing of the cat in these figures, fitted by Feltline.
Result<Drawing> sample_cat_drawing();

}  // namespace felt::cli
