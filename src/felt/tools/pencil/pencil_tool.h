#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "felt/stroke/steady/steady_line.h"
#include "felt/tools/gesture_tool.h"
#include "felt/tools/line_stabiliser.h"
#include "felt/tools/pencil/connect_ink.h"
#include "felt/tools/pencil/drawn_path.h"
#include "felt/tools/pencil/ink_snap.h"
#include "felt/tools/pencil/landing_pressure.h"
#include "felt/tools/pencil/modifier_hold.h"
#include "felt/tools/pencil/pencil_options.h"
#include "felt/tools/pencil/shape_hold.h"
#include "felt/tools/pencil/straight_ink.h"
#include "felt/tools/pencil/wet_ink.h"
#include "felt/tools/pencil/width_steps.h"

namespace felt {

/// Draws lines of variable width (paper, "sketch creation", "controlling the width", "connect
/// curves"; pencil.md). Each gesture makes one line and one edit, "Draw". If a modifier is held
/// during the gesture and meant (ModifierHold), the line is straight (StraightInk). If the steady
/// hand is on, SteadyLine removes the shaking of the hand, and ToolResult::as_drawn has the line of
/// the unchanged samples.
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
  [[nodiscard]] double retrace_n() const override;

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
  void restart_straight(std::span<const InkSample> samples);
  [[nodiscard]] std::optional<Stroke> straight_line(InkConnections& to) const;
  void begin_steady();
  void add_ink(const InkSample& ink);
  /// Adds samples whose pressure is known (LandingPressure).
  void add_landed(std::span<const InkSample> ink);
  [[nodiscard]] std::optional<Stroke> free_line();
  /// Completes the line in the fitter.
  [[nodiscard]] std::optional<Stroke> fitted_line();
  /// Fits these samples.
  template <class Samples>
  [[nodiscard]] std::optional<Stroke> line_of(const Samples& samples);
  /// Returns the edit that adds the line, or nullopt without a line.
  [[nodiscard]] std::optional<Edit> edit_of(const std::optional<Stroke>& drawn,
                                            const InkConnections& to, const Scene& scene) const;
  /// Returns a shape in the look of the line, or nullopt if its data are invalid.
  [[nodiscard]] std::optional<Stroke> shape_ink(const ShapeGuess& shape) const;
  /// Returns the shapes that are offered, and the ink. The one that was accepted applies, or the
  /// ink.
  [[nodiscard]] std::optional<Offer> shape_offer(const Edit& ink, const Scene& scene) const;
  void draw_shapes(Overlay& overlay) const;
  void draw_ahead(Overlay& overlay) const;
  void add_offer(ToolResult& result, const Scene& scene) const;
  [[nodiscard]] InkConnections connections(const Scene& scene) const;
  [[nodiscard]] std::optional<SnapTarget> attraction() const noexcept;

  PencilSettings settings_;  // of the line being drawn, or of the next line
  std::unique_ptr<InkFitter> fitter_;
  InkFitOptions fitted_;  // the options that fitter_ was made with
  StraightInk straight_;
  ModifierHold hold_;
  Stabiliser stabiliser_;
  WidthSteps width_steps_;              // none if the option is off
  std::unique_ptr<SteadyLine> steady_;  // null if the steady hand is off
  std::optional<Shake> shake_;          // that steady_ was made for
  LandingPressure landing_;
  InkSample pen_;  // last sample of the line
  Rgba color_;

  InkSnap snap_;
  Point pen_point_;  // position of the pen, for the overlay
  bool near_ = false;

  WetInk wet_;
  DrawnPath path_;        // only if a gesture is on
  WidthMap path_widths_;  // of the path while the pen lands, when the wet ink has no widths yet
  ShapeHold shapes_;      // only if shapes are on
};

std::unique_ptr<Tool> make_pencil();

}  // namespace felt
