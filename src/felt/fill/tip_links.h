#pragma once

#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "felt/fill/line_meetings.h"

namespace felt {

/// A point on a stroke, as one end of a link.
struct LinkEnd {
  StrokeId stroke;
  double u = 0.0;
  Point point;
};

/// A connection from the end of a stroke to another stroke, or to another part of the same stroke.
/// A touch connects ink that visibly touches although the centre lines do not meet; a bridge closes
/// a gap of the drawing.
struct TipLink {
  LinkEnd from, to;
  std::optional<Point> corner;  ///< where the link turns, if it is not straight
  double length_mm = 0.0;       ///< the size of the gap: the distance that the ink is missing
  bool touch = false;
};

/// Finds the links of one stroke end.
///
/// A touch is a point of another centre line within half of the sum of both widths, which is where
/// the ink of a round end begins to touch. An end that already meets the other stroke there gets
/// none, so overshoots make no slivers.
///
/// A bridge closes a gap of at most `max_gap_mm`. The end is extended along its tangent, up to the
/// first stroke in its path. Two ends that face each other are joined at the corner where their
/// tangents cross, or straight if these do not cross nearby. The shortest of these wins. Source:
/// extension by the tangents at end points as in Fourey, Tschumperlé, Revoy, "A fast and efficient
/// semi-guided algorithm for flat coloring line-arts", VMV 2018 (hal-01891876).
class TipLinker {
 public:
  TipLinker(const LineMeetings& meetings, double max_gap_mm)
      : meetings_(meetings), max_gap_mm_(max_gap_mm) {}

  /// Returns the links of an end of an open stroke; links are in the order of the strokes' ids.
  [[nodiscard]] std::vector<TipLink> links(StrokeId id, StrokeTip tip) const;

 private:
  struct Tip;

  bool find_touches(const Tip& tip, std::vector<TipLink>& links) const;
  [[nodiscard]] std::optional<TipLink> touch(const Tip& tip, StrokeId id, const MeetingLine& line,
                                             bool& met) const;
  [[nodiscard]] std::optional<TipLink> bridge(const Tip& tip) const;
  [[nodiscard]] std::optional<TipLink> extension(const Tip& tip) const;
  [[nodiscard]] std::optional<TipLink> to_tip(const Tip& tip, StrokeId id, const MeetingLine& line,
                                              StrokeTip other) const;
  [[nodiscard]] bool is_blocked(const TipLink& link) const;

  const LineMeetings& meetings_;
  double max_gap_mm_;
};

/// All links of a set of strokes for one size of gaps. Keeps the links of each stroke end, and
/// finds them again only if something near the end has changed.
class TipLinks {
 public:
  explicit TipLinks(double max_gap_mm) : max_gap_mm_(max_gap_mm) {}

  /// Forgets the links near areas that have changed (LineMeetings::update).
  void forget(std::span<const Rect> areas);
  /// Returns all links: the shortest first, ends that are joined already left out.
  [[nodiscard]] std::vector<TipLink> links(const LineMeetings& meetings);

 private:
  struct Known {
    Rect reach;  ///< what happens outside has no influence
    std::vector<TipLink> links;
  };

  double max_gap_mm_;
  std::map<std::pair<StrokeId, StrokeTip>, Known> known_;
};

}  // namespace felt
