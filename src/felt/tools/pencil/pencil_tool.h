#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "felt/tools/contact.h"
#include "felt/tools/pencil/connect_ink.h"
#include "felt/tools/pencil/ink_snap.h"
#include "felt/tools/pencil/pencil_options.h"
#include "felt/tools/pencil/stabiliser.h"
#include "felt/tools/pencil/wet_ink.h"
#include "felt/tools/pressing.h"
#include "felt/tools/tool.h"

namespace felt {

/// Draws lines of variable width (paper, "sketch creation", "controlling the width", "connect
/// curves"; pencil.md).
///
///   air --touch--> drawing --lift--> air         lift: one edit, "Draw"
///                     |
///                     +--cancel, finish--> waiting --lift--> air
///
/// Work of a sample is bounded whatever the length of the stroke, but for the last one, which
/// completes it. Samples without a finite position are ignored.
class PencilTool final : public Tool {
 public:
  /// Below this height over the sheet a pen in the air is attracted by ends of lines ...
  static constexpr double kNearMm = 5.0;
  /// ... until it is higher than this.
  static constexpr double kFarMm = 7.0;
  /// Lines of more samples are not refined: a minute at 1 kHz, a tenth of a second of work.
  static constexpr std::size_t kMaxRefinedSamples = 60'000;

  PencilTool();

  [[nodiscard]] const ToolInfo& info() const noexcept override;
  ToolResult sample(const PenSample& sample, const Scene& scene) override;
  ToolResult finish(const Scene& scene) override;
  void cancel() override;
  [[nodiscard]] ForceModel force(const Scene& scene) const override;
  void draw(Overlay& overlay) const override;

  /// Take effect with the next line; while the pen is in the air, at once.
  Result<void> set_option(std::string_view id, const OptionValue& value) override;
  [[nodiscard]] Result<OptionValue> option(std::string_view id) const override;

 private:
  void hover(const PenSample& sample, const Scene& scene);
  void begin(const PenSample& sample, const Scene& scene);
  void make_fitter(const Scene& scene);
  void add(const PenSample& sample, const Scene& scene);
  void add_ink(const InkSample& pen);
  ToolResult end(const Scene& scene);
  void stop();
  void take_options();
  [[nodiscard]] InkConnections connections(const Scene& scene) const;
  [[nodiscard]] std::optional<SnapTarget> attraction() const noexcept;

  OptionValues options_;
  PencilSettings settings_;  // of the line being drawn, or of the next one
  bool has_new_options_ = false;
  Contact contact_;
  bool drawing_ = false;
  bool waiting_ = false;  // for the pen to be lifted

  std::unique_ptr<InkFitter> fitter_;
  WidthMapOptions fitted_widths_;  // that fitter_ was made with
  Stabiliser stabiliser_;
  std::vector<InkSample> gap_;  // out of contact, perhaps only for a moment
  InkSample pen_;               // the last one in contact
  Rgba color_;

  InkSnap snap_;
  Point pen_point_;  // where the pen is, for the overlay
  bool near_ = false;

  WetInk wet_;
};

std::unique_ptr<Tool> make_pencil();

}  // namespace felt
