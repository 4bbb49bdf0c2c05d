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

/// The forces of every drawing tool: the surface, its grain, and friction. Tools add other forces:
/// Compose(make_surface_force(...), SnapWells(...)).
using SurfaceForce = Compose<Plane, Texture, Friction>;

/// Returns the largest sum of slopes along one axis that a device can render, N/m (R56): 900 if at
/// most 2 ms pass between reading a position and the end of its force. For a longer delay it is
/// proportional to 1/delay, for example 600 at 3 ms. The safety chain uses the same number, so the
/// chain does not weaken a model that stays within this budget.
double stiffness_budget_n_per_m(const Capabilities& device) noexcept;

/// Returns the options of the plane of a surface on a device: its stiffness K and its damping B. C
/// is the largest K that the device can render: the minimum of 0.9 of the device's maximum (R55),
/// the stiffness budget, and the limit that the position sensor sets (below). If C is less than
/// kHardestNPerM, all surfaces are made softer together, so that paper, felt, board and glass
/// remain distinguishable (R13):
///
///   K = min(K of the surface, C sqrt(K of the surface/kHardestNPerM))
///
/// B is at most the device's maximum and, on loops with periods below 0.5 ms, at most 2 N s/m at
/// the hand (docs/design/forces.md#plane). If the sensor is coarse, C and B are reduced, but not
/// below 200 N/m and 0.5 N s/m. Unless these minima apply, one step of the sensor changes the force
/// of the spring by at most 0.025 N, and the force of the damper by at most another 0.025 N. (To
/// the damper a step is a speed: the step divided by 1.6 ms plus a period.) Without this reduction,
/// a sliding pen would hum between two steps (docs/stability.md): at 60 to 100 Hz, with 0.03 to
/// 0.06 N if a step is 0.055 mm. The width of a line is computed with this K.
PlaneOptions plane_for(const SurfaceMaterial& surface, const Capabilities& device) noexcept;
/// Returns the viscosity b along the page that gives a hand the damping which the mass m of the
/// device takes from it, N s/m: 18/s m (docs/design/forces.md#viscosity). The dry friction f of the
/// device damps, too: at a speed of 100 mm/s, like f/v. What it damps beyond 18/s m is taken from
/// b. At most half of the largest damping of the device, and less if its sensor is coarse, as for
/// the plane; 0 if its mass is unknown.
double matched_viscosity_n_s_per_m(const Capabilities& device) noexcept;

/// Friction of a pencil on paper, the reference of all frictions (share/materials).
inline constexpr double kPencilOnPaper = 0.25;

/// Returns the friction options for a medium on a surface, on a device. The stiffness k of the
/// bristle is the one that the medium specifies (default 600 N/m) if this leaves 300 N/m of the
/// budget for one more spring (edit, snap). On slower loops k is less (300 N/m at 3 ms), and the
/// damping d is reduced in proportion. A coarse sensor also reduces k and d, just as it reduces C
/// and B of the plane. The friction of the device itself is that of the capabilities, for a medium
/// that draws; that of the eraser is added to it. The viscosity is matched_viscosity_n_s_per_m(),
/// proportionally less for a medium that slides with a coefficient below 0.1.
FrictionOptions friction_for(const Medium& tool, const SurfaceMaterial& surface,
                             const Capabilities& device) noexcept;

/// Stiffness of glass, the hardest built-in surface, N/m. Surfaces with a stiffness of up to this
/// value remain distinguishable on every device.
inline constexpr double kHardestNPerM = 800.0;

/// Returns F1, the push that draws a line of full width and tone: 0.2 to 1.2 N
/// (Capabilities::full_push_n), so that a firm push draws broad on a strong device. The device can
/// hold this force permanently (sustained_force_n), together with the friction of a medium that
/// slides with a coefficient of up to 0.6. So the width does not depend on how warm the motors are
/// (R14): a push below F1 is never limited, and any push above F1 draws full width. A user who
/// lowers the force limit lowers F1, too, if `device` comes from with_force_limit(). With a limit
/// below 0.25 N, or with forces off, the surface yields before full width is reached. The width
/// then depends on the depth of the pen. If the user has set a master strength s (a factor on all
/// forces) below 1, the surface feels softer, and a push of s F1 draws full width.
double firm_push_n(const Capabilities& device) noexcept;

/// Returns the push at which the hand feels the relief flattened as far as the medium can flatten
/// it (relief_left): 1.2 x the continuous force, clamped to 0.2..2 N. On weak devices this push is
/// greater than F1, because the grain of rough paper would otherwise be too weak to feel. On
/// screen, the relief is already flattened that far at F1.
double flattening_push_n(const Capabilities& device) noexcept;

/// Returns the texture options for the grain of a surface under a medium, on a device.
TextureOptions texture_for(const Medium& tool, const SurfaceMaterial& surface,
                           const Capabilities& device,
                           TextureLaw law = TextureLaw::kFriction) noexcept;

/// Returns the forces of a medium on a surface. `grain` is usually surface_grain(surface) and must
/// outlive the haptic loop; if it is null, the surface is smooth.
SurfaceForce make_surface_force(const SurfaceMaterial& surface, const Medium& tool,
                                const Capabilities& device, const HeightField* grain = nullptr,
                                TextureLaw law = TextureLaw::kFriction) noexcept;

}  // namespace felt
