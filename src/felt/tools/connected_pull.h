#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "felt/document/edit.h"
#include "felt/document/edit_builder.h"
#include "felt/document/stroke_index.h"
#include "felt/geometry/bvh.h"
#include "felt/stroke/arc_map.h"
#include "felt/tools/brush_pull.h"
#include "felt/tools/brush_reach.h"
#include "felt/tools/point_moves.h"
#include "felt/tools/scene.h"

namespace felt {

/// Finds points on a stroke. Builds a search tree on the first search if the stroke has many
/// segments.
class NearCurve {
 public:
  explicit NearCurve(StrokePtr stroke) : stroke_(std::move(stroke)) {}

  /// Returns the parameter of the point of the stroke that is nearest to p, or nullopt if it is
  /// farther away than kSharedPointMm. Adds the number of segments and nodes examined to `work`.
  [[nodiscard]] std::optional<double> u_near(Point p, int& work);
  [[nodiscard]] const StrokePtr& stroke() const noexcept { return stroke_; }

 private:
  const SegmentBvh& tree(int& work);

  StrokePtr stroke_;
  SegmentBvh tree_;
};

/// Keeps strokes that share a point (junctions.h) together while some of them are changed (R33;
/// NibLines does the same for strokes that are pushed): adds the changes of the other strokes to
/// the gesture's edit.
///
/// The strokes are placed one after the other, first those of the edit, then those that share a
/// point with a stroke that has moved. A stroke is placed once: its shared points with the strokes
/// that have been placed before, moved or not, move to where those are (with_points_moved()), and
/// its other ends and corners stay. So all shared points hold at the end, whether strokes share
/// several points or several strokes share one. If an end of a stroke lies on a stroke of a locked
/// layer, or the other way round, this point stays. Points that were up to kSharedPointMm apart
/// keep this offset; if the gesture moved both, they may come nearer. If at most kMaxFollowers
/// strokes follow, the result depends only on the edit and the document at the touch, so moving
/// back undoes it.
///
/// For a stroke that has not changed since the last edit, complete() only does a look-up. For each
/// changed stroke it searches for shared points, and for each follower with one shared point it
/// does one multiplication per control point. A change takes time n log n in the segments and
/// shared points of the stroke. Make one object per gesture.
class ConnectedPull {
 public:
  /// Maximum number of strokes that follow in one gesture; further strokes do not move. Strokes
  /// that the gesture itself pulls do not count.
  static constexpr std::size_t kMaxFollowers = 256;

  /// Numbers of preparations since construction, for tests.
  struct Work {
    int maps = 0;     ///< arc length maps
    int brushes = 0;  ///< brush pulls of one stroke at one point
    int looks = 0;    ///< segments and nodes of search trees examined, and comparisons of points
  };

  explicit ConnectedPull(const BrushOptions& brush) : brush_(brush) { brush_.free_ends = false; }

  /// Keeps the shape of a stroke that the gesture moves as a whole, even if it separates from a
  /// locked stroke or from another such stroke.
  void keep_shape(StrokeId id) { rigid_.insert(id); }

  /// Lets an end leave the points that it shares with other strokes. Call it before complete().
  void release(TipId tip) { released_.insert(tip); }
  /// Does the same for the points that the end shares with one stroke.
  void release(TipId tip, StrokeId from) { released_from_.insert({tip, from}); }

  /// Adds the changes of the followers to `edit`, which is the gesture's edit of scene.document.
  void complete(Edit& edit, const Scene& scene);
  [[nodiscard]] const Work& work() const noexcept { return work_; }

 private:
  /// A point that a stroke shares with another one.
  struct Link {
    double u = 0.0;
    StrokeId other;
    double other_u = 0.0;
    Point start;   ///< position at the touch
    Vec offset{};  ///< from this point to that of the other stroke
    bool is_other_end = false;
    bool is_held = false;  ///< the other stroke is locked
  };
  /// A shared point of a stroke and the position to which other strokes take it.
  struct Tie {
    PointMove move;
    Vec offset{};  ///< from the point of the other stroke to `move.to`

    friend bool operator==(const Tie&, const Tie&) noexcept = default;
  };
  /// A stroke of the edit, or one that follows.
  struct Line {
    StrokePtr before;
    std::vector<Link> links;
    std::optional<ArcMap> arc;        // of `before`, made when needed
    StrokePtr given;                  // in the gesture's last edit; `before` if it follows
    std::vector<Tie> ties;            // with the strokes that were placed before it
    std::optional<NearCurve> placed;  // `given`, with these points moved
    std::vector<Point> places;        // positions of the links on this stroke
    std::optional<StrokeReplacement> follows;
    std::optional<BrushPull> brush;  // of the only tie, at brush_u
    double brush_u = 0.0;
  };

  /// What a call of complete() has done so far.
  struct Spread {
    std::map<StrokeId, std::vector<Tie>> ties;
    std::map<StrokeId, StrokePtr> waiting;  // the gesture's own strokes that have no place yet
    std::set<StrokeId> queued, placed;
    std::set<StrokeId> next;  // strokes that must follow
  };

  Line& line(StrokeId id, const StrokePtr& before, const Scene& scene);
  /// Returns null if more strokes than kMaxFollowers would follow.
  Line* follower(StrokeId id, const Scene& scene);
  [[nodiscard]] std::vector<Tie> held(const Line& line, std::vector<Tie> ties);
  void place(Line& line, const StrokePtr& given, std::vector<Tie> all);
  void place_change(StrokeChange& change, bool is_own, Spread& spread, const Scene& scene);
  [[nodiscard]] bool is_released(StrokeId id, const Stroke& stroke, double u, StrokeId other) const;
  [[nodiscard]] Tie tie_at(Line& line, std::size_t i, const Stroke* waiting);
  [[nodiscard]] std::vector<PointMove> moves_of(Line& line, NearCurve& given);
  [[nodiscard]] StrokePtr shaped(Line& line);
  [[nodiscard]] std::vector<double> carried(Line& line, NearCurve& curve,
                                            const std::vector<double>& us);

  BrushOptions brush_;
  std::map<StrokeId, Line> lines_;
  std::set<StrokeId> rigid_;
  std::set<TipId> released_;
  std::set<std::pair<TipId, StrokeId>> released_from_;
  std::size_t followers_ = 0;
  Work work_;
};

}  // namespace felt
