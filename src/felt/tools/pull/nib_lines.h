#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "felt/document/edit.h"
#include "felt/document/edit_builder.h"
#include "felt/tools/pull/nib_push.h"
#include "felt/tools/scene.h"

namespace felt {

/// The strokes that a nib pushes, and the strokes connected to them (R27, R33). Strokes that share
/// a point (junctions.h) at the touch keep sharing it, however many of them the nib touches:
///
///   1. In each step of the nib, each stroke under the nib is pushed aside on its own (NibPush).
///   2. Each stroke that has moved pulls the others to its shared points. Between its other shared
///      points, a stroke that is pulled this way keeps its position.
///   3. Each stroke that was pulled is pushed out from under the nib again, and pulls in turn.
///
/// This ends when nothing moves. Usually one or two rounds are enough. After kExactVisits rounds
/// each push goes some micrometres farther than the radius, so that the rounds end. If they do not
/// end, the strokes keep clear of the nib, and the points stay slightly apart until the next step.
/// If the strokes move farther and farther apart, the nib moves over them instead. Points shared
/// with strokes of locked layers stay, and a stroke is not pushed while the nib covers such a point
/// of it. Points that were up to kSharedPointMm apart keep this offset.
///
/// Gaps that remain (gap_mm()) are closed with ConnectedPull, whatever lies under the nib.
///
/// Takes time linear in the strokes that move, and quadratic in the shared points of one stroke.
/// Edit thread only.
class NibLines {
 public:
  /// Maximum number of strokes that move without having been touched by the nib. Connections to
  /// further strokes break.
  static constexpr std::size_t kMaxFollowers = 256;
  /// Number of rounds of a stroke in one step that push it exactly to the radius, and maximum
  /// number of rounds.
  static constexpr int kExactVisits = 4;
  static constexpr int kMaxVisits = 60;

  /// A stroke that the nib has touched or that follows another stroke.
  struct Line {
    Line(StrokeReplacement stroke, StrokePtr ink, double radius_mm)
        : replacement(std::move(stroke)), push(std::move(ink), radius_mm) {}

    StrokeReplacement replacement;
    NibPush push;
    bool touched = false;     ///< by the nib
    double carried_mm = 0.0;  ///< displacement at the first touch
    /// Parameters of the shared points, in order.
    std::vector<double> pins;
    int visits = 0;  ///< rounds in this step
    bool waits = false;
    bool has_links = false;
    struct Link {
      double u = 0.0;
      StrokeId other;
      double other_u = 0.0;
      Point start;        ///< position at the touch
      Vec offset{};       ///< from this point to that of the other stroke
      bool held = false;  ///< stays, because the other stroke is locked
    };
    std::vector<Link> links;
  };

  explicit NibLines(double radius_mm) : radius_mm_(radius_mm) {}

  /// Moves the nib straight from `from` to `to`. Returns true if a stroke moved.
  bool move(Point from, Point to, Vec came_from, const Scene& scene);
  /// Returns the strokes to commit, refitted (refit.h). If the refit would move a stroke under the
  /// nib at `pen` or off a shared point, the strokes are pushed and pulled again.
  [[nodiscard]] std::vector<std::pair<StrokeId, StrokePtr>> finished(Point pen) const;
  /// Returns the largest distance between strokes at a point that they share.
  [[nodiscard]] double gap_mm() const;
  [[nodiscard]] const std::map<StrokeId, Line>& lines() const noexcept { return lines_; }

 private:
  using Lines = std::map<StrokeId, Line>;

  void meet(const Scene& scene, Point from, Point to);
  void note_touch(Line& line, Point from, Point to) const;
  Line* follower(StrokeId id, const Scene* scene);
  void find_links(StrokeId id, Line& line, const Scene& scene) const;
  bool weld(Point p, Vec came_from, const Scene* scene);
  bool visit(Line& line, Point p, Vec came_from, const Scene* scene);
  [[nodiscard]] bool is_held_under(const Line& line, Point p) const;
  void queue(StrokeId id, Line& line);
  void copy_links(const Line& line, Line& to, const NibLines& from) const;
  Line& add(StrokeReplacement place, StrokePtr ink);
  static bool pull(Line& line, double u, Point target);
  [[nodiscard]] std::vector<std::vector<StrokeId>> moved_groups() const;
  [[nodiscard]] std::vector<std::pair<StrokeId, StrokePtr>> finished_group(
      const std::vector<StrokeId>& ids, Point pen) const;
  [[nodiscard]] double largest_gap_mm(const std::vector<StrokeId>& ids) const;

  double radius_mm_;
  Lines lines_;
  std::size_t followers_ = 0;
  std::vector<StrokeId> queue_;
};

}  // namespace felt
