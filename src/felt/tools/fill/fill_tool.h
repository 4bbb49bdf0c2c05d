#pragma once

#include <memory>
#include <optional>

#include "felt/tools/fill/fill_gesture.h"
#include "felt/tools/fill/fill_options.h"
#include "felt/tools/gesture_tool.h"
#include "felt/tools/guide_track.h"

namespace felt {

/// Fills the areas that visible strokes enclose with the current colour (fill.md). One gesture is
/// one edit, "Fill". The second modifier removes fills.
class FillTool final : public GestureTool {
 public:
  FillTool();

  [[nodiscard]] ForceModel force(const Scene& scene) const override;
  void draw(Overlay& overlay) const override;

 protected:
  ToolResult hover(const PenSample& sample, const Scene& scene) override;
  ToolResult begin(const PenSample& sample, const Scene& scene) override;
  ToolResult move(const PenSample& sample, const Scene& scene) override;
  ToolResult end(const Scene& scene) override;
  void drop() override;
  void stop_hovering() override;
  void take_options(const OptionValues& options) override;

 private:
  bool visit(Point p, const Scene& scene);
  void feel_edge(const PenSample& sample);
  void stop();

  FillSettings settings_;
  DocumentMap map_{DocumentMap::Of::kVisibleStrokes};
  std::optional<TipLink> gap_;  // why the last tap could not fill
  // The state of the gesture:
  std::optional<FillGesture> gesture_;
  Point start_, pen_;
  std::optional<Edit> edit_;
  const Fill* felt_ = nullptr;  // the area whose edge is felt
  std::optional<GuideTrack> ridge_;
  std::uint32_t ridge_number_ = 0;
};

std::unique_ptr<Tool> make_fill();

}  // namespace felt
