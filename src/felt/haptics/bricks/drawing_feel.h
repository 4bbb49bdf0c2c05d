#pragma once

#include "felt/geometry/height_field.h"
#include "felt/haptics/bricks/friction.h"
#include "felt/haptics/bricks/plane.h"
#include "felt/haptics/bricks/texture.h"
#include "felt/haptics/capabilities.h"
#include "felt/haptics/force_model.h"
#include "felt/material/materials.h"
#include "felt/material/relief.h"

namespace felt {

/// What every drawing tool starts from: the sheet, its grain, and the friction on it. Tools add to
/// it: Compose(make_sheet_force(...), Wells(...)).
using SheetForce = Compose<Plane, Texture, Friction>;

/// Sum of slopes along one axis that a device bears, N/m (R56): 900 up to 2 ms between reading a
/// position and the end of its force, 600 at 3 ms, in proportion to 1/delay. The safety chain's own
/// number: what is built within it is felt as built.
double stiffness_budget_n_per_m(const Capabilities& device) noexcept;

/// The plane of a surface on a device. The hardest K that a device can give is C: 0.9 of its cap
/// (R55), the budget, and what its sensor allows. Where that is less than kHardestNPerM, all
/// surfaces are made softer together, so that felt, paper, board and glass stay apart (R13):
///
///   K = min(K of the surface, C sqrt(K of the surface/kHardestNPerM))
///
/// B is at most the device's, and 2 N s/m on loops faster than 0.5 ms (specification 5b). Where the
/// sensor is coarse both are less: one of its steps may change the spring's push by 0.025 N at
/// most, and the damper's, which sees it as a speed (step over 1.6 ms and a period), by as much
/// again. Otherwise a pen that slides hums between two steps at 60 to 100 Hz (docs/stability.md):
/// 0.03 to 0.06 N on steps of 0.055 mm.
/// The width of a line is made with this K.
PlaneOptions plane_for(const SurfaceMaterial& surface, const Capabilities& device) noexcept;
/// The friction of a pair on a device: k = 600 N/m where the budget leaves 300 N/m for one spring
/// beside it (edit, snap), less on slower loops (300 at 3 ms), d in proportion (300/1); and like
/// the plane less of both on a coarse sensor.
FrictionOptions friction_for(const Medium& tool, const SurfaceMaterial& surface,
                             const Capabilities& device) noexcept;

/// Surfaces up to this stiffness are told apart on every device, N/m: that of glass.
inline constexpr double kHardestNPerM = 800.0;

/// The push that draws a line of full width and tone: F1, 2 N at most and 0.2 N at least. It is a
/// force that the device can hold for as long as one likes (sustained_force_n), beside the friction
/// of a medium that slides with a coefficient up to 0.6. So the width does not depend on how warm
/// the motors are (R14): what draws less than full width is never limited, and more than F1 is full
/// width. A user who lowers the force limit lowers F1 too, if the device is the one that
/// with_force_limit() gives. With a limit below 0.25 N, or forces off, the sheet yields before full
/// width, and the width follows the depth from there. A master strength s below 1 makes the sheet
/// softer for the hand: full width then takes s F1.
double firm_push_n(const Capabilities& device) noexcept;

/// The push that flattens, for the hand, all of a relief that a medium can flatten (relief_left):
/// 1.2 x the continuous force, within 0.2 and 2 N. More than F1 on weak devices, where the grain of
/// rough paper would be too weak to be felt otherwise; the eye sees it flattened at full width.
double flattening_push_n(const Capabilities& device) noexcept;

/// The grain of a surface under a tool, on a device.
TextureOptions texture_for(const Medium& tool, const SurfaceMaterial& surface,
                           const Capabilities& device,
                           TextureLaw law = TextureLaw::kFriction) noexcept;

/// The feel of a tool on a surface. `grain` is usually surface_grain(surface) and must outlive the
/// haptic loop; null is smooth.
SheetForce make_sheet_force(const SurfaceMaterial& surface, const Medium& tool,
                            const Capabilities& device, const HeightField* grain = nullptr,
                            TextureLaw law = TextureLaw::kFriction) noexcept;

}  // namespace felt
