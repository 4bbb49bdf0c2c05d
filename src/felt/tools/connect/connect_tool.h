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

/// Joins two ends that are there, or closes a stroke (paper, "Connect curves"; connect.md):
///
///   - dragging: what is near the pen is taken hold of, and the end moves as the pen moves; within
///     the snap radius of another end it is connected to it, and shown so; letting go there commits
///     that. Elsewhere the end goes back, or stays (`extend`).
///   - tapping: an end with another one within reach; each goes half of the way.
///
/// The other end of the same stroke counts at once, unlike in the pencil (R44): there a line begins
/// at its start and must get away from it first, here a person takes hold of an end to close it.
class ConnectTool final : public GestureTool {
 public:
  /// A gesture is a tap until the pen has gone this far, ...
  static constexpr double kTapMm = 1.0;
  /// ... and no longer one after this time: who presses on an end and thinks wants nothing.
  static constexpr std::int64_t kTapNs = 500'000'000;
  /// Below this height over the sheet a pen in the air is attracted by the end it would take ...
  static constexpr double kNearMm = 5.0;
  /// ... until it is higher than this.
  static constexpr double kFarMm = 7.0;
  /// So many ends are shown before the touch, the one that would be taken among them.
  static constexpr std::size_t kMostShown = 4;

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
  /// An end that the pen has taken hold of. Its stroke as it was at the touch decides everything.
  struct Drag {
    Drag(const Scene& scene, const TipHit& tip, const PenSample& pen);

    TipId tip;
    Point from;      ///< where the end was
    Point pen_from;  ///< where the pen was then
    std::int64_t since_ns;
    StrokeReplacement place;
    TipLead lead;
    Point at;                       ///< where the end is led to
    std::optional<TipId> on = {};   ///< what it is connected to
    std::optional<Edit> edit = {};  ///< what has come of it; none: as before
    bool is_pulled = false;         ///< no tap any more
    bool is_long = false;           ///< nor that
    bool extend = false;            ///< what the modifier makes of the option
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
  std::vector<TipHit> shown_;      // the first is the one that would be taken
  std::optional<TipHit> partner_;  // what a tap would connect it to
  bool near_ = false;
  std::optional<Point> released_at_;  // the last drag ended there, and the pen has not left since
  std::optional<Drag> drag_;
};

std::unique_ptr<Tool> make_connect();

}  // namespace felt
