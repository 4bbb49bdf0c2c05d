#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "felt/document/document.h"
#include "felt/document/selection.h"
#include "felt/document/stroke_index.h"
#include "felt/geometry/affine.h"
#include "felt/geometry/rect.h"
#include "felt/tools/transform/connected_lines.h"

namespace felt {

/// What is selected, as it was at the touch, ready to be mapped again and again (R33): strokes,
/// marks and places are found once. Prepared in time linear in the selection and in its layers.
///
/// A preview of a selection of up to kMostPreviewPoints is made in portions of kPointsPerStep, one
/// a sample, so that a sample costs the same however much is selected: 40 strokes of ten segments
/// follow with every sample, 1,000 strokes 40 times a second. Of more no preview is made: the frame
/// and 2,000 marked pieces follow the pen, and the lines come at the lift.
class MovedStrokes {
 public:
  static constexpr std::size_t kPointsPerStep = 1'200;
  static constexpr std::size_t kMostPreviewPoints = 100'000;
  /// In a selection of more strokes, connections to other strokes are not looked for: they stay
  /// where they are, and nothing holds the selection there.
  static constexpr std::size_t kMaxConnected = 5'000;

  MovedStrokes() = default;
  /// Strokes of hidden and locked layers are left out. With `duplicates`, copies on top of the
  /// layers are mapped and the strokes stay: of a stroke that is selected in part each run of
  /// selected segments is copied, as a line of its own.
  ///
  /// Strokes that are not selected but share a point (junctions.h) with what moves go along there:
  /// an end moves with the point, a line that an end stands on gets a joint there, and what is left
  /// of them holds like the rest of a line that is selected in part. Strokes of locked layers stay,
  /// and so does the end of a line that lies on one, unless that line is selected as a whole.
  MovedStrokes(const Document& document, const StrokeIndex& index, const Selection& selection,
               bool duplicates);

  [[nodiscard]] bool empty() const noexcept { return items_.empty(); }
  /// The fixed points that hold the selection (R34); none for copies.
  [[nodiscard]] const std::vector<Point>& anchors() const noexcept { return anchors_; }
  /// Below this factor a segment would become too short (I5); 1 at most.
  [[nodiscard]] double least_scale() const noexcept { return least_scale_; }
  /// The copies, all of each selected; nothing without duplicates.
  [[nodiscard]] const std::optional<Selection>& copies() const noexcept { return copies_; }

  /// Works on the preview of this map for a while. A preview when one is complete, perhaps of an
  /// earlier map: it shows up when its turn comes. Nothing where a stroke cannot become that.
  std::optional<Edit> step(const Affine& map, double width_factor);
  /// The whole edit at once, or, where a stroke cannot become that, the last preview again; empty
  /// when there was none.
  [[nodiscard]] Edit finished(const Affine& map, double width_factor, std::string label) const;

 private:
  struct Item {
    StrokePtr before;
    Selection::Marks marks;
    bool is_small = false;  // one segment, whole: never becomes shorter than a segment may be
    /// The marked end moves as this place on an item before does, which bends.
    std::optional<MovedLine::Leader> leader;
  };
  struct Aim {
    Affine map;
    double width_factor = 1.0;
    friend bool operator==(const Aim&, const Aim&) noexcept = default;
  };

  /// The strokes of the last two previews are let go one by one as the next is made: whoever
  /// showed them drops a thousand at once, which would take half a millisecond.
  struct Shown {
    StrokePtr last, before;
  };

  void prepare_originals(const Document& document, const StrokeIndex& index,
                         const Selection& selection);
  void prepare_copies(const Document& document, const Selection& selection);
  void add(MovedLine line);
  [[nodiscard]] static StrokePtr moved(const Item& item, const Aim& aim);
  /// Of an item with a leader: how far that has gone in `done`.
  [[nodiscard]] Aim aim_of(const Item& item, const Aim& aim,
                           const std::vector<StrokeChange>& done) const;
  [[nodiscard]] std::optional<Edit> all_moved(const Aim& aim, std::string label) const;

  std::vector<Item> items_;
  Edit places_;  // what becomes of item i: its i-th change, but for the stroke after
  std::size_t points_ = 0;
  std::vector<Point> anchors_;
  double least_scale_ = 0.0;
  std::optional<Selection> copies_;

  Edit work_;  // of the preview in work, its first strokes
  std::vector<Shown> shown_;
  std::optional<Aim> aim_;   // of the preview in work
  std::optional<Aim> done_;  // of the last complete one
};

}  // namespace felt
