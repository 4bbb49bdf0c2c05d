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

/// Keeps strokes that share a point (junctions.h) together while one of them is pulled (R33;
/// NibLines does the same for strokes that are pushed): adds the changes of the other strokes to
/// the gesture's edit.
///
/// If a shared point moves, a brush pulls the other stroke to the new position of that point, while
/// the ends and corners elsewhere on the pulled stroke stay. Strokes connected to the pulled stroke
/// follow in turn. If an end of a changed stroke lies on a stroke of a locked layer, a brush pulls
/// this end back to its position at the touch instead. If at most kMaxFollowers strokes follow, the
/// result depends only on the edit and the document at the touch, so moving back undoes it.
///
/// For a stroke that has not changed since the last edit, complete() only does a look-up. For each
/// changed stroke it searches for shared points, and for each follower it does one multiplication
/// per control point. Make one object per gesture.
class ConnectedPull {
 public:
  /// Maximum number of strokes that follow in one gesture; further strokes do not move. Strokes
  /// that the gesture itself pulls do not count.
  static constexpr std::size_t kMaxFollowers = 256;

  /// Numbers of preparations since construction, for tests.
  struct Work {
    int maps = 0;     ///< arc length maps
    int brushes = 0;  ///< brush pulls of one stroke at one point
  };

  explicit ConnectedPull(const BrushOptions& brush) : brush_(brush) { brush_.free_ends = false; }

  /// Adds the changes of the followers to `edit`, which is the gesture's edit of scene.document.
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
    std::optional<ArcMap> arc;  // of `before`, made when needed
    StrokePtr given;            // this stroke in the gesture's last edit
    StrokePtr after;            // `given`, with ends on locked strokes pulled back
    std::vector<Point> places;  // positions of the junctions on `after`
  };
  struct Follower {
    explicit Follower(StrokeReplacement stroke) : place(std::move(stroke)), after(place.before()) {}

    StrokeReplacement place;
    std::vector<Pull> pulls;  // the last pulls; `after` is their result
    StrokePtr after;
    std::optional<BrushPull> brush;  // of the first pull, at brush_u
    double brush_u = 0.0;
  };

  const Leader& lead(const StrokeChange& change, const Scene& scene);
  [[nodiscard]] StrokePtr held(const Leader& leader, StrokePtr after);
  [[nodiscard]] std::vector<Point> carried(Leader& leader);
  /// Returns null if more strokes than kMaxFollowers would follow.
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
