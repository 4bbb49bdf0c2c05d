#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/document.h"
#include "felt/document/selection.h"
#include "felt/document/stroke_index.h"
#include "felt/geometry/affine.h"
#include "felt/geometry/rect.h"
#include "felt/tools/connected_lines.h"
#include "felt/tools/connected_pull.h"

namespace felt {

/// The selected strokes as they were at the touch, prepared for mapping (R33): strokes, marks and
/// positions in the layers are looked up once, in time linear in the selection and its layers.
///
/// The preview of a selection of up to kMaxPreviewPoints control points is made in portions of
/// kPointsPerStep points, one portion per sample, so that the time per sample does not depend on
/// the size of the selection. At 1 kHz, 40 strokes of ten segments are updated with every sample,
/// 1,000 such strokes 40 times a second. Larger selections have no preview: the frame and 2,000
/// marked segments follow the pen, and the lines move when the pen is lifted.
class MovedStrokes {
 public:
  static constexpr std::size_t kPointsPerStep = 1'200;
  static constexpr std::size_t kMaxPreviewPoints = 100'000;
  /// Maximum number of selected strokes for which connected strokes are searched. If more are
  /// selected, connected strokes stay in place and do not hold the selection.
  static constexpr std::size_t kMaxConnected = 5'000;

  MovedStrokes() = default;
  /// Prepares the strokes, except those on hidden or locked layers. If `duplicates` is true, the
  /// strokes stay, and copies are mapped instead; they are added on top of the layers. If a stroke
  /// is selected only in part, each unbroken sequence of selected segments is copied as a separate
  /// line. If check_copies() refuses the copies, there is nothing to map: empty() is true.
  ///
  /// Strokes that are not selected but share a point (junctions.h) with moving ink follow at that
  /// point: an end moves with the point, and a line on which an end lies gets a joint at that
  /// point. If `leaves_originals`, nothing
  /// follows a selection of which a line was pasted onto its original. The remaining parts of
  /// the strokes that follow resist like the unselected part of a partly
  /// selected line. Strokes on locked layers stay. If an end of a moving line lies on such a
  /// stroke, this end stays too, unless the line is selected as a whole.
  MovedStrokes(const Document& document, const StrokeIndex& index, const Selection& selection,
               bool duplicates, bool leaves_originals = true);

  [[nodiscard]] bool empty() const noexcept { return items_.empty(); }
  /// Returns the fixed points that hold the selection (R34); empty for copies.
  [[nodiscard]] const std::vector<Point>& anchors() const noexcept { return anchors_; }
  /// Returns the factor below which a segment would become too short (I5); at most 1.
  [[nodiscard]] double min_scale() const noexcept { return min_scale_; }
  /// Returns a selection of all copies as whole strokes, or nullopt if `duplicates` was false.
  [[nodiscard]] const std::optional<Selection>& copies() const noexcept { return copies_; }

  /// Returns the error of check_copies() if it refused the copies; once, and nullopt after that.
  [[nodiscard]] std::optional<Error> take_refusal() noexcept {
    return std::exchange(refusal_, std::nullopt);
  }

  /// Returns what closes the gaps of finished() and of a preview, or nullopt if lines that share a
  /// point cannot part (ConnectedLines::may_part).
  [[nodiscard]] std::optional<ConnectedPull> connected_pull() const;
  /// Returns the selection after `edit`, which finished() has made, if the edit adds joints to
  /// selected strokes; otherwise nullopt. `before` is the selection at the touch. A stroke that was
  /// selected in part is deselected if ConnectedPull has added further joints to it.
  [[nodiscard]] std::optional<Selection> selection_after(const Edit& edit,
                                                         const Selection& before) const;

  /// Continues the preview in progress, or starts a preview of this map if none is in progress.
  /// Returns the preview if it is now complete. It may be the preview of an earlier map, because
  /// making a preview can take several samples. Returns nullopt if the preview is not complete or a
  /// stroke cannot be mapped.
  std::optional<Edit> step(const Affine& map, double width_factor);
  /// Returns the whole edit. If a stroke cannot be mapped, returns the edit of the last preview
  /// instead, or an empty one.
  [[nodiscard]] Edit finished(const Affine& map, double width_factor, std::string label) const;

 private:
  struct Item {
    StrokePtr before;
    Selection::Marks marks;
    bool is_small = false;  // one whole segment; keeps at least the minimum length
    bool is_selected_whole = false;
    /// The marked end moves with this point on an earlier item, which bends.
    std::optional<MovedLine::Leader> leader;
  };
  struct Aim {
    Affine map;
    double width_factor = 1.0;
    friend bool operator==(const Aim&, const Aim&) noexcept = default;
  };

  /// Keeps the strokes of the last two previews alive, so that they are released one by one as the
  /// next preview is made. Releasing a thousand strokes together would take half a millisecond.
  struct Shown {
    StrokePtr last, before;
  };

  void prepare_originals(const Document& document, const StrokeIndex& index,
                         const Selection& selection, bool leaves_originals);
  void prepare_copies(const Document& document, const Selection& selection);
  void add(MovedLine line);
  [[nodiscard]] static StrokePtr moved(const Item& item, const Aim& aim);
  /// Returns the map of an item. If the item has a leader, this is a translation by the
  /// displacement of the leader's point in `done`.
  [[nodiscard]] Aim aim_of(const Item& item, const Aim& aim,
                           const std::vector<StrokeChange>& done) const;
  [[nodiscard]] std::optional<Edit> all_moved(const Aim& aim, std::string label) const;

  std::vector<Item> items_;
  std::size_t selected_ = 0;  // the first items are those of the selection
  bool may_part_ = false;
  Edit places_;  // changes without `after`; change i belongs to item i
  std::size_t points_ = 0;
  std::vector<Point> anchors_;
  double min_scale_ = 0.0;
  std::optional<Selection> copies_;
  std::optional<Error> refusal_;

  Edit work_;  // the preview in progress, with its first strokes
  std::vector<Shown> shown_;
  std::optional<Aim> aim_;   // of the preview in progress
  std::optional<Aim> done_;  // of the last complete preview
};

}  // namespace felt
