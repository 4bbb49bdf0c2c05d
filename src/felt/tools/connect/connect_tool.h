#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "felt/document/edit_builder.h"
#include "felt/tools/connect/connect_ends.h"
#include "felt/tools/connect/connect_options.h"
#include "felt/tools/connect/tip_lead.h"
#include "felt/tools/connected_pull.h"
#include "felt/tools/gesture_tool.h"
#include "felt/tools/snapping.h"

namespace felt {

/// Joins two existing ends, or closes a stroke (paper, "Connect curves"; connect.md):
///
///   - drag: the pen grabs the nearest end, which moves with the pen. Within the snap radius of
///     another end, the grabbed end is shown connected, and lifting the pen there commits the
///     connection. If the pen is lifted elsewhere, the end moves back, or stays if the option
///     `extend` is on.
///   - tap: connects the tapped end with another end within reach; both ends move halfway.
///
/// Lines that stand on a part that bends follow it (R33). A dragged end leaves the lines that it
/// stands on or meets; at a tap, they follow.
///
/// From the start of the drag, the other end of the same stroke is a target too, so that the user
/// can close the stroke. The pencil is stricter: it closes a new line only if the line has gone
/// around an area (R44).
class ConnectTool final : public GestureTool {
 public:
  /// A gesture is a tap if the pen moves less than this distance ...
  static constexpr double kTapMm = 1.0;
  /// ... and is lifted within this time. A user who presses on an end and hesitates wants no
  /// change.
  static constexpr std::int64_t kTapNs = 500'000'000;
  /// The end that a touch would grab begins to attract a hovering pen below this height ...
  static constexpr double kNearMm = 5.0;
  /// ... and stops above this height.
  static constexpr double kFarMm = 7.0;
  /// Maximum number of ends shown before the touch, including the one that would be grabbed.
  static constexpr std::size_t kMaxShown = 4;

  ConnectTool();

  [[nodiscard]] ForceModel force(const Scene& scene) const override;
  void draw(Overlay& overlay) const override;

 protected:
  ToolResult hover(const PenSample& sample, const Scene& scene) override;
  ToolResult begin(const PenSample& sample, const Scene& scene) override;
  ToolResult move(const PenSample& sample, const Scene& scene) override;
  ToolResult end(const Scene& scene) override;
  void drop() override;
  void take_options(const OptionValues& options) override;

 private:
  /// A grabbed end. All results are computed from its stroke as it was at the touch.
  struct Drag {
    Drag(const Scene& scene, const TipHit& hit, const PenSample& pen);

    TipId tip;
    Point from;      ///< position of the end at the touch
    Point pen_from;  ///< position of the pen at the touch
    std::int64_t since_ns;
    StrokeReplacement place;
    TipLead lead;
    ConnectedPull lines;            ///< those that stand on the line, while the end follows the pen
    Point at;                       ///< current position of the end
    std::optional<TipId> on = {};   ///< the end to which `tip` is connected
    std::optional<Edit> edit = {};  ///< the current edit; nullopt if none
    bool is_pulled = false;         ///< moved too far for a tap
    bool is_long = false;           ///< lasted too long for a tap
    bool extend = false;            ///< the option `extend`, inverted by the modifier
  };

  void find(Point pen, const Scene& scene);
  ToolResult lead_to(Point at, const Scene& scene);
  [[nodiscard]] Edit connect(TipId to, MeetingPlace place, const Scene& scene) const;
  [[nodiscard]] Edit tap(const Scene& scene) const;
  [[nodiscard]] std::optional<TipHit> partner(const TipHit& tip, const Scene& scene) const;
  [[nodiscard]] bool is_in_snap_radius() const;
  void draw_drag(Overlay& overlay) const;
  void draw_hover(Overlay& overlay) const;

  ConnectSettings settings_;
  SnapFinder finder_;
  std::vector<TipHit> shown_;      // a touch would grab the first of these
  std::optional<TipHit> partner_;  // the end to which a tap would connect shown_[0]
  bool near_ = false;
  // Position at which the last drag ended, until the pen leaves it.
  std::optional<Point> released_at_;
  std::optional<Drag> drag_;
};

std::unique_ptr<Tool> make_connect();

}  // namespace felt
