#include "felt/tools/pencil/connect_ink.h"

#include <algorithm>
#include <utility>

#include "felt/document/edit_builder.h"
#include "felt/stroke/edit/join.h"
#include "felt/tools/connecting.h"

namespace felt {
namespace {

class Connector {
 public:
  Connector(const Stroke& ink, const InkConnections& connections, const Scene& scene)
      : ink_(ink), to_(connections), scene_(scene), edit_(scene.document) {}

  Edit run() && {
    place_ends();
    if (!add_closed() && !add_joined()) edit_.add(scene_.layer, share(ink_));
    return std::move(edit_).build("Draw");
  }

 private:
  static StrokePtr share(Stroke stroke) {
    return std::make_shared<const Stroke>(std::move(stroke));
  }

  /// Moves the ends to their targets. Drops targets that the ends cannot reach.
  void place_ends() {
    place(StrokeTip::kStart, to_.start, stroke_with_tip(scene_.document, to_.start));
    if (!to_.start && to_.start_meets) move(StrokeTip::kStart, *to_.start_meets);
    if (to_.closes) {
      to_.closes = move(StrokeTip::kEnd, tip_point(ink_, StrokeTip::kStart));
      to_.end.reset();
    } else {
      if (to_.end == to_.start) to_.end.reset();
      place(StrokeTip::kEnd, to_.end, stroke_with_tip(scene_.document, to_.end));
      if (!to_.end && to_.end_meets) move(StrokeTip::kEnd, *to_.end_meets);
    }
  }

  void place(StrokeTip mine, std::optional<TipId>& on, const StrokePtr& other) {
    if (on && !(other && move(mine, tip_point(*other, on->tip)))) on.reset();
  }

  bool move(StrokeTip mine, Point target) {
    const double shift = distance(tip_point(ink_, mine), target);
    auto moved = with_tip_at(ink_, mine, target, std::clamp(5.0 * shift, 2.0, kTipFadeMm));
    if (moved) ink_ = *std::move(moved);
    return moved.has_value();
  }

  bool add_closed() {
    if (!to_.closes) return false;
    auto ring = closed(ink_);
    if (!ring) return false;
    edit_.add(scene_.layer, share(*std::move(ring)));
    return true;
  }

  /// Returns true if the stroke of an end may be joined with the ink.
  [[nodiscard]] bool may_join(const std::optional<TipId>& on) const {
    if (!on) return false;
    const Stroke& other = *scene_.document.find(on->stroke);
    const Layer* layer = scene_.document.layer(scene_.layer);
    return scene_.document.layer_of(on->stroke) == scene_.layer && layer && !layer->locked &&
           look_alike(other, ink_);
  }

  bool add_joined() {
    const bool start = may_join(to_.start), end = may_join(to_.end);
    const bool is_outline = start && end && to_.start->stroke == to_.end->stroke;
    if (to_.keep_separate && !is_outline) return false;
    if (start && end && add_between()) return true;
    if (start && add_to(*to_.start, StrokeTip::kStart)) return true;
    return end && add_to(*to_.end, StrokeTip::kEnd);
  }

  bool add_to(TipId on, StrokeTip mine) {
    auto one = joined_at(*scene_.document.find(on.stroke), on.tip, ink_, mine);
    if (one) edit_.replace(on.stroke, share(*std::move(one)));
    return one.has_value();
  }

  /// If both ends lie on strokes, joins the two strokes, or closes one stroke.
  bool add_between() {
    const TipId a = *to_.start, b = *to_.end;
    auto one = joined_at(*scene_.document.find(a.stroke), a.tip, ink_, StrokeTip::kStart);
    if (!one) return false;
    if (a.stroke == b.stroke) {
      auto ring = closed(*one);
      if (!ring) return false;
      edit_.replace(a.stroke, share(*std::move(ring)));
      return true;
    }
    // After the first join, the ink's free end is the end `a.tip` of the joined stroke.
    auto both = joined_at(*one, a.tip, *scene_.document.find(b.stroke), b.tip);
    if (!both) return false;
    edit_.replace(a.stroke, share(*std::move(both)));
    edit_.remove(b.stroke);
    return true;
  }

  Stroke ink_;
  InkConnections to_;
  const Scene& scene_;
  EditBuilder edit_;
};

}  // namespace

Edit connect_ink(const Stroke& ink, const InkConnections& connections, const Scene& scene) {
  return Connector(ink, connections, scene).run();
}

}  // namespace felt
