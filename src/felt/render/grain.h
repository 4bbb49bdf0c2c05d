#pragma once

#include <memory>
#include <string_view>

#include "felt/geometry/height_field.h"
#include "felt/material/materials.h"

namespace felt {

struct InkLook;

/// How media look on a sheet (paper, "future work"; specification 5i; R47): dry ink lies on the
/// hills of the relief and leaves the valleys bare, and the harder it is pressed on, the deeper it
/// goes. For a medium's MediumLook, tone t and push q = t (1 - 0.45 rho^2) at rho radii from the
/// middle of the line, where the tip presses less:
///
///   alpha = opacity(t) (1 - G (1 - seen)),  seen = smoothstep(1/2 + (w r - cut(q)) / (2 soft))
///   r = (grain d s(x) + crumb c(x) + streaks b(n)) / n,   n = |(grain, crumb, streaks)|
///   G = min(1, n),  w = 1 - wear q,  cut = cut_light + (cut_heavy - cut_light) q
///
/// The smoothstep of h - h_cut(p) is the specification's; all that it is made of is our own choice:
/// s  the very height h that the hand feels at x, and a *tooth*: the same map finer and turned.
///    Grain shorter than 1 mm cannot be given to a hand at 1 kHz, stable and strong enough to be
///    felt (decision 10), but an eye misses it. In its own RMS;
/// d  = R / (R + 2 um) of its RMS height R: a sheet of fine paper is not as grainy as canvas;
/// c  the medium's own dust: a map of its own, as coarse as crumb_mm, fixed to the page;
/// b  hairs, by the place n across the line: of a dry brush they are seen one by one.
/// Within `edge` radii of the rim q falls on to -1/3, where nothing is reached any more: dust
/// frays. At the rim wet ink dries darker: alpha (1 + rim). From afar, where a pixel is larger than
/// the grain, alpha is that of the mean over what it no longer shows. Nothing here depends on what
/// was drawn before: any order of painting gives the same picture.
///
/// A value; copies share what was made for them, 1.4 MiB of relief, from 32 pixels a wavelength on
/// 5 MiB more, and 32 KiB a medium and scale. Any thread.
class Grain {
 public:
  /// Plain: every medium is solid ink.
  Grain() noexcept = default;
  /// `field` must outlive all copies; null is a smooth sheet, on which media look like themselves.
  explicit Grain(const HeightField* field, const Materials& materials = Materials::built_in());

  [[nodiscard]] bool is_plain() const noexcept { return !state_; }
  /// There is no relief: plain, or a smooth sheet.
  [[nodiscard]] bool is_smooth() const noexcept;
  /// What it looks at: the same function of the same object that a Texture feels.
  [[nodiscard]] HeightField::Sample at(Point place) const noexcept;
  /// s in its RMS; 0 where there is no relief.
  [[nodiscard]] double relief(Point place) const noexcept;
  /// alpha in the middle of a line of a medium, by its id, without streaks; an unknown one looks
  /// like the pencil. Plain: 1.
  [[nodiscard]] double alpha(Point place, double tone, std::string_view material) const noexcept;

  /// The same as tables for a scale, for whoever fills pixels (ink_look.h). Null: solid ink.
  [[nodiscard]] std::shared_ptr<const InkLook> look(std::string_view material,
                                                    double px_per_mm) const;

  /// Both draw the same pixels: of one relief, and with media that look alike.
  friend bool operator==(const Grain& a, const Grain& b) noexcept;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

/// Grain in a file whose strokes are outlines (.svg, .pdf): on which relief, and how fine.
struct GrainPrint {
  static constexpr double kLeastDpi = 20.0;
  static constexpr double kMostDpi = 1200.0;

  Grain grain;
  double dpi = 200.0;  ///< kLeastDpi..kMostDpi
};

}  // namespace felt
