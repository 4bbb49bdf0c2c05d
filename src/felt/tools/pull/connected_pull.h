#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "felt/document/edit.h"
#include "felt/document/edit_builder.h"
#include "felt/tools/junctions.h"
#include "felt/tools/pull/brush_reach.h"
#include "felt/tools/scene.h"

namespace felt {

/// Keeps strokes together that share a point (junctions.h) while one of them is pulled or pushed
/// (R33), whatever the mode: adds to an edit of the gesture what the others must do.
///
/// A stroke whose shared point goes somewhere is pulled there by a brush, so its other end and its
/// corners stay; what is connected to that one follows in its turn. An end on a stroke of a locked
/// layer is brought back instead, by a brush as well. A function of the edit and of the document at
/// the touch: going back undoes it. One object a gesture.
class ConnectedPull {
 public:
  static constexpr int kMaxRounds = 4;
  static constexpr std::size_t kMaxFollowers = 64;

  explicit ConnectedPull(const BrushOptions& brush) : brush_(brush) { brush_.free_ends = false; }

  /// `edit` is what the gesture has made of the document of the scene.
  void complete(Edit& edit, const Scene& scene);

 private:
  struct Pull {
    double u = 0.0;
    Point to;
  };

  const std::vector<Junction>& junctions(const StrokeChange& change, const Scene& scene);
  void hold(StrokeChange& change, const Scene& scene);
  [[nodiscard]] StrokePtr pulled(StrokePtr stroke, double u, Point to) const;

  BrushOptions brush_;
  std::map<StrokeId, std::vector<Junction>> junctions_;
  std::map<StrokeId, StrokeReplacement> followers_;
};

/// Where the place u of a stroke has gone when `after` was made of it: ends with the ends, a place
/// that still lies on the curve nowhere, another one along by its share of the length that changed.
Point carried_along(const Stroke& before, const Stroke& after, double u);

}  // namespace felt
