#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "felt/tools/gesture_tool.h"
#include "felt/tools/line_stabiliser.h"
#include "felt/tools/pencil/connect_ink.h"
#include "felt/tools/pencil/drawn_path.h"
#include "felt/tools/pencil/ink_snap.h"
#include "felt/tools/pencil/modifier_hold.h"
#include "felt/tools/pencil/pencil_options.h"
#include "felt/tools/pencil/shape_hold.h"
#include "felt/tools/pencil/straight_ink.h"
#include "felt/tools/pencil/wet_ink.h"

namespace felt {

/// Draws lines of variable width (paper, "sketch creation", "controlling the width", "connect
/// curves"; pencil.md). Each gesture makes one line and one edit, "Draw". If a modifier is held
/// during the gesture and meant (ModifierHold), the line is straight (StraightInk).
///
/// If the options say so, a line may also be a gesture (meanings.h), or become a shape while the
/// pen rests at its end (ShapeHold). Then the result has an Offer. A line that became a shape is
/// one edit, "Shape".
///
/// The work per sample does not depend on the length of the stroke, except for the last sample,
/// which completes it.
class PencilTool final : public GestureTool {
 public:
  /// Ends of lines begin to attract a hovering pen below this height ...
  static constexpr double kNearMm = 5.0;
  /// ... and stop above this height.
  static constexpr double kFarMm = 7.0;
  /// Maximum number of samples of a line that is refined: a minute at 1 kHz, which takes 0.1 s to
  /// refine.
  static constexpr std::size_t kMaxRefinedSamples = 60'000;

  PencilTool();

  [[nodiscard]] ForceModel force(const Scene& scene) const override;
  void draw(Overlay& overlay) const override;

  [[nodiscard]] std::optional<OfferView> offered() const override;
  void choose(OfferKind kind) override;

  /// Returns the width of the line that a mouse draws. With a pen that senses pressure, lines
  /// become thinner or broader than this.
  [[nodiscard]] std::optional<ToolSize> size() const override;
  /// Keeps the ratio of the thinnest to the broadest line if their ranges allow it.
  [[nodiscard]] std::vector<std::pair<std::string_view, double>> options_for_size(
      double mm) const override;

 protected:
  ToolResult hover(const PenSample& sample, const Scene& scene) override;
  ToolResult begin(const PenSample& sample, const Scene& scene) override;
  ToolResult move(const PenSample& sample, const Scene& scene) override;
  ToolResult end(const Scene& scene) override;
  void drop() override;
  void stop_hovering() override;
  void take_options(const OptionValues& options) override;

 private:
  void make_fitter(const Scene& scene);
  [[nodiscard]] std::optional<Stroke> straight_line(InkConnections& to) const;
  [[nodiscard]] std::optional<Stroke> free_line();
  /// Returns a shape in the look of the line, or nullopt if its data are invalid.
  [[nodiscard]] std::optional<Stroke> shape_ink(const ShapeGuess& shape) const;
  /// Returns the shapes that are offered, and the ink. The one that was accepted applies, or the
  /// ink.
  [[nodiscard]] std::optional<Offer> shape_offer(const Edit& ink, const Scene& scene) const;
  void draw_shapes(Overlay& overlay) const;
  [[nodiscard]] std::optional<Edit> drawn_edit(const Scene& scene);
  [[nodiscard]] InkConnections connections(const Scene& scene) const;
  [[nodiscard]] std::optional<SnapTarget> attraction() const noexcept;

  PencilSettings settings_;  // of the line being drawn, or of the next line
  std::unique_ptr<InkFitter> fitter_;
  InkFitOptions fitted_;  // the options that fitter_ was made with
  StraightInk straight_;
  ModifierHold hold_;
  Stabiliser stabiliser_;
  InkSample pen_;  // last sample of the line
  Rgba color_;

  InkSnap snap_;
  Point pen_point_;  // position of the pen, for the overlay
  bool near_ = false;

  WetInk wet_;
  DrawnPath path_;    // only if a gesture is on
  ShapeHold shapes_;  // only if shapes are on
};

std::unique_ptr<Tool> make_pencil();

}  // namespace felt
