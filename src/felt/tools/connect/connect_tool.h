#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "felt/document/edit_builder.h"
#include "felt/tools/connect/connect_options.h"
#include "felt/tools/connect/tip_lead.h"
#include "felt/tools/gesture_tool.h"
#include "felt/tools/snapping.h"

namespace felt {

/// Joins two existing ends, or closes a stroke (paper, "Connect curves"; connect.md):
///
///   - drag: the pen grabs the nearest end, which moves with the pen. Within the snap radius of
///     another end it is shown connected, and lifting the pen there commits that. Elsewhere the end
///     moves back, or stays with the option `extend`.
///   - tap: connects an end with another end within reach; each moves halfway.
///
/// The other end of the same stroke is a target immediately, because the user grabs an end to close
/// the stroke. With the pencil, a new line must first move away from its start (R44).
class ConnectTool final : public GestureTool {
 public:
  /// A gesture is a tap until the pen has moved by this distance, ...
  static constexpr double kTapMm = 1.0;
  /// ... but not after this time, because a user who presses on an end and hesitates wants no
  /// change.
  static constexpr std::int64_t kTapNs = 500'000'000;
  /// If a hovering pen comes below this height, the end that it would grab attracts it ...
  static constexpr double kNearMm = 5.0;
  /// ... until it is above this height.
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
    Drag(const Scene& scene, const TipHit& tip, const PenSample& pen);

    TipId tip;
    Point from;      ///< position of the end at the touch
    Point pen_from;  ///< position of the pen at the touch
    std::int64_t since_ns;
    StrokeReplacement place;
    TipLead lead;
    Point at;                       ///< current position of the end
    std::optional<TipId> on = {};   ///< the end that it is connected to
    std::optional<Edit> edit = {};  ///< the current edit; nullopt: unchanged
    bool is_pulled = false;         ///< moved too far for a tap
    bool is_long = false;           ///< too long for a tap
    bool extend = false;            ///< the option, inverted by the modifier
  };

  void find(Point pen, const Scene& scene);
  ToolResult lead_to(Point at, const Scene& scene);
  [[nodiscard]] Edit tap(const Scene& scene) const;
  [[nodiscard]] std::optional<TipHit> partner(const TipHit& tip, const Scene& scene) const;
  [[nodiscard]] bool is_in_snap_radius() const;
  void draw_drag(Overlay& overlay) const;
  void draw_hover(Overlay& overlay) const;

  ConnectSettings settings_;
  SnapFinder finder_;
  std::vector<TipHit> shown_;      // a touch would grab the first of these
  std::optional<TipHit> partner_;  // the end that a tap would connect it to
  bool near_ = false;
  // Position at which the last drag ended, until the pen leaves it.
  std::optional<Point> released_at_;
  std::optional<Drag> drag_;
};

std::unique_ptr<Tool> make_connect();

}  // namespace felt
