#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "felt/document/edit.h"
#include "felt/document/edit_builder.h"
#include "felt/stroke/arc_map.h"
#include "felt/tools/junctions.h"
#include "felt/tools/pull/brush_pull.h"
#include "felt/tools/pull/brush_reach.h"
#include "felt/tools/scene.h"

namespace felt {

/// Keeps strokes together that share a point (junctions.h) while one of them is pulled or pushed
/// (R33), whatever the mode: adds to an edit of the gesture what the others must do.
///
/// A stroke whose shared point goes somewhere is pulled there by a brush, so its other end and its
/// corners stay; what is connected to that one follows in its turn. An end on a stroke of a locked
/// layer is brought back instead, by a brush as well. A function of the edit and of the document at
/// the touch, as long as no more than kMaxFollowers are needed: going back undoes it.
///
/// Strokes that stay as they were since the last edit cost a look-up, one that changed its shared
/// points, and each follower of it one multiplication per control point. One object a gesture.
class ConnectedPull {
 public:
  static constexpr int kMaxRounds = 4;
  /// The strokes that follow in one gesture, at most: the first ones. Strokes that the gesture
  /// itself pulls or pushes do not count.
  static constexpr std::size_t kMaxFollowers = 256;

  /// What was prepared so far, for tests.
  struct Work {
    int maps = 0;     ///< of arc lengths
    int brushes = 0;  ///< pulls of one stroke at one place
  };

  explicit ConnectedPull(const BrushOptions& brush) : brush_(brush) { brush_.free_ends = false; }

  /// `edit` is what the gesture has made of the document of the scene.
  void complete(Edit& edit, const Scene& scene);
  [[nodiscard]] const Work& work() const noexcept { return work_; }

 private:
  struct Pull {
    double u = 0.0;
    Point to;

    friend bool operator==(const Pull&, const Pull&) noexcept = default;
  };
  /// A stroke of the edit that others may follow.
  struct Leader {
    StrokePtr before;
    std::vector<Junction> junctions;
    std::optional<ArcMap> arc;  // of `before`, when it is needed
    StrokePtr given;            // by the gesture, the last time
    StrokePtr after;            // the same with the ends that are held
    std::vector<Point> places;  // of the junctions, on `after`
  };
  struct Follower {
    explicit Follower(StrokeReplacement stroke) : place(std::move(stroke)), after(place.before()) {}

    StrokeReplacement place;
    std::vector<Pull> pulls;  // the last ones, and what they made
    StrokePtr after;
    std::optional<BrushPull> brush;  // of the first pull, at
    double brush_u = 0.0;
  };

  const Leader& lead(const StrokeChange& change, const Scene& scene);
  [[nodiscard]] StrokePtr held(const Leader& leader, StrokePtr after);
  [[nodiscard]] std::vector<Point> carried(Leader& leader);
  /// Null if there are too many.
  Follower* follower(StrokeId id, const Scene& scene);
  void follow(Follower& follower, std::vector<Pull> pulls);
  [[nodiscard]] static StrokePtr pulled(const BrushPull& brush, StrokePtr stroke, Vec displacement);
  [[nodiscard]] StrokePtr pulled(StrokePtr stroke, double u, Point to);

  BrushOptions brush_;
  std::map<StrokeId, Leader> leaders_;
  std::map<StrokeId, Follower> followers_;
  Work work_;
};

}  // namespace felt
