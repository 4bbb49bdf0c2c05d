#pragma once

#include <memory>
#include <optional>
#include <set>

#include "felt/document/edit_builder.h"
#include "felt/tools/gesture_tool.h"
#include "felt/tools/recolor/recolor_options.h"

namespace felt {

/// Gives every line that the pen touches the current colour, the current medium or both
/// (recolor.md). One gesture is one edit, "Recolour". The first modifier gives both.
class RecolorTool final : public GestureTool {
 public:
  RecolorTool();

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
  [[nodiscard]] Edit edit(const Scene& scene) const;
  void stop();

  RecolorSettings settings_;
  std::optional<Point> pen_;
  // The state of the gesture:
  RecolorGives gives_ = RecolorGives::kColor;
  std::set<StrokeId> touched_;
  std::optional<Edit> edit_;
};

std::unique_ptr<Tool> make_recolor();

}  // namespace felt
