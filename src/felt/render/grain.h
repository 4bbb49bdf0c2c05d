#pragma once

#include <memory>
#include <string_view>

#include "felt/geometry/height_field.h"
#include "felt/material/materials.h"
#include "felt/render/line_style.h"

namespace felt {

struct InkLook;

/// The look of media on a surface (R47; docs/design/rendering.md#grain-in-ink; "future work" of the
/// paper): dry ink lies on the hills of the relief and leaves the valleys bare; with more pressure
/// it reaches deeper. The formulas use the values of the medium's MediumLook, its wear, the tone t,
/// and the push q at a distance of rho radii from the middle of the line. The tip presses less
/// towards its edge, so q is smaller there. opacity(q) runs linearly from opacity_light (q = 0) to
/// opacity_heavy (q = 1).
///
///   alpha = opacity(q) (1 - G (1 - seen)),  seen = smoothstep(1/2 + (w r - cut(q)) / (2 soft))
///   r = (grain d s(x) + crumb c(x) + streaks b(y)) / n,   n = |(grain, crumb, streaks)|
///   G = min(1, n),  w = 1 - wear q,  cut = cut_light + (cut_heavy - cut_light) q
///   q = t (1 - 0.45 rho^2)
///
/// The form smoothstep(h - h_cut(p)) comes from docs/design/rendering.md#grain-in-ink. The terms
/// are Feltline's own choice:
/// s  the same height h that the hand feels at x, plus a *tooth*: the same map, finer and (except
///    for wood) rotated. The tooth is drawn, but not felt, because in a loop of 1 kHz, grain
///    shorter than 1 mm cannot be both stable and strong enough to feel
///    (docs/design/forces.md#texture). s is in units of its own RMS;
/// d  = R / (R + 12 um) for the relief's RMS height R: fine paper is less grainy than canvas;
/// c  the medium's own dust: noise of several octaves without cells, fixed to the page (dust.h);
/// b  the single hairs of a dry brush, by the position y across the line.
/// Within `edge` radii of the rim, alpha fades to 0 and q falls to -1/3. At this q the ink reaches
/// no part of the relief, so the edge of a dusty line frays. Wet ink dries darker at the rim: alpha
/// is multiplied by up to 1 + rim. If a pixel is larger than the grain, alpha is the mean over the
/// detail that the pixel cannot show. The look of a stroke does not depend on earlier strokes, so
/// strokes may be shaded in any order.
///
/// A grain also holds the styles of the media's lines (StrokeStyles), because everything that draws
/// ink needs both.
///
/// A value type. Copies share their tables: 1.4 MB for the relief, 4.2 MB more if it is ever drawn
/// at more than 24 pixels per wavelength, and 32 KiB for each medium and scale. The dust takes 1.4
/// MB once. Safe to use from any thread.
class Grain {
 public:
  /// Creates a plain grain, with which every medium is solid ink, and the styles of the built-in
  /// media.
  Grain() noexcept = default;
  /// Returns a plain grain with the styles of these media.
  static Grain solid(const Materials& materials);
  /// Requires that `field` outlives all copies. If `field` is null, the surface is smooth; the
  /// media still have their own dust, hairs and edges.
  explicit Grain(const HeightField* field, const Materials& materials = Materials::built_in());

  [[nodiscard]] bool is_plain() const noexcept { return !state_; }
  /// Returns true if the surface has no relief: the grain is plain, or the surface is smooth.
  [[nodiscard]] bool is_smooth() const noexcept;
  /// Returns the height at a point: the same value that a Texture uses for the force.
  [[nodiscard]] HeightField::Sample at(Point place) const noexcept;
  /// Returns s in units of its RMS, or 0 if the surface has no relief.
  [[nodiscard]] double relief(Point place) const noexcept;
  /// Returns alpha in the middle of a line, without hairs, for the medium with the id `medium`.
  /// An unknown medium looks like the pencil. Returns 1 if the grain is plain.
  [[nodiscard]] double alpha(Point place, double tone, std::string_view medium) const noexcept;

  /// Returns the look of a medium at one scale as tables, for code that fills pixels (ink_look.h),
  /// or null for solid ink.
  [[nodiscard]] std::shared_ptr<const InkLook> look(std::string_view medium,
                                                    double px_per_mm) const;

  /// Returns the styles of the media's lines.
  [[nodiscard]] const StrokeStyles& styles() const noexcept { return styles_; }

  /// Returns true if both have the same relief and media with the same looks and styles, so that
  /// they draw the same pixels.
  friend bool operator==(const Grain& a, const Grain& b) noexcept;

 private:
  struct State;
  std::shared_ptr<const State> state_;
  StrokeStyles styles_;
};

/// The grain of a file that contains strokes as outlines (.svg, .pdf), and its resolution.
struct GrainPrint {
  static constexpr double kMinDpi = 20.0;
  static constexpr double kMaxDpi = 1200.0;

  Grain grain;
  double dpi = 200.0;  ///< kMinDpi..kMaxDpi
};

}  // namespace felt
