#pragma once

#include <cstdint>

#include "felt/geometry/triangle_tree.h"
#include "felt/haptics/bricks/friction.h"
#include "felt/haptics/bricks/plane.h"
#include "felt/haptics/bricks/texture.h"
#include "felt/haptics/capabilities.h"
#include "felt/haptics/force.h"
#include "felt/haptics/force_memory.h"
#include "felt/haptics/pen_sample.h"
#include "felt/material/materials.h"

namespace felt {

/// How the surface of a body feels.
struct SolidSurfaceOptions {
  PlaneOptions plane{};        ///< across the surface
  FrictionOptions friction{};  ///< along the surface
  double max_force_n = 0.0;    ///< largest force across the surface; 0 = no bound
  /// Differs for every body, and every time that touching begins. Not 0.
  std::uint32_t number = 1;
};

/// The surface of bodies in front of a device, felt through a proxy (SurfaceProxy;
/// docs/design/solids.md#touch):
///
///   offset = proxy - pen = depth n + t     n: the normal that holds the proxy, t along the surface
///   Fn = max(0, min(K depth, max_force_n) - B vn),  at most max_force_n    vn: velocity along n
///   F  = Fn n + (k t - d vt, shortened to mu Fn)                   vt: known part of the velocity
///
/// The velocity is computed from the positions, as that of the Plane. With the reported one, a
/// device that reports a wrong velocity, or none, would make the surface active or let it hum. It
/// stays while the device repeats its sample, for up to 20 ms.
///
/// K and B are those of a plane, k, d and mu those of Friction. The proxy sticks while k |t| <= mu
/// K depth and otherwise follows at that distance. So Fn never pulls the pen in, the friction
/// removes energy like that of a plane, and no speed carries the pen through.
///
/// The force is zero until the pen has been where nothing of the body is between it and the hand,
/// straight above. So a body that appears around the pen does not throw it out; the user pulls the
/// pen out of it first. The same holds after a gap in the samples of more than kLostMm or 20 ms. If
/// the body changes (another `number`) while the pen touches it, the proxy stays or is lifted by up
/// to kFollowMm onto the new surface; if it would have to be lifted farther, the force ends until
/// the pen has left the body. Publish a changed body with another fade_id.
///
/// The body must outlive the loop (Servo::oldest_in_use); its triangles are in mm in the frame of
/// the page. The grain is projected onto the body along z. Do not combine with Plane or Friction.
class SolidSurface {
 public:
  static constexpr double kLostMm = 4.0;
  static constexpr double kFollowMm = 1.0;

  SolidSurface(const TriangleTree& body, const SolidSurfaceOptions& options,
               const Texture& grain = Texture()) noexcept
      : body_(&body), options_(options), grain_(grain) {}

  Force operator()(const PenSample& sample, ForceMemory& memory) const noexcept;
  /// Returns the largest stiffness. A flank of a body turns the stiffness across the surface into
  /// one along the page.
  [[nodiscard]] Slopes slopes() const noexcept;
  [[nodiscard]] const SolidSurfaceOptions& options() const noexcept { return options_; }

 private:
  [[nodiscard]] bool is_free_in_front(const Vec3& point) const noexcept;
  void change_body(SolidTouch& touch) const noexcept;
  [[nodiscard]] bool follow(const PenSample& sample, double friction,
                            ForceMemory& memory) const noexcept;
  [[nodiscard]] Force across_and_along(const PenSample& sample, double across_n_per_mm,
                                       double along_n_per_mm, ForceMemory& memory) const noexcept;

  const TriangleTree* body_;
  SolidSurfaceOptions options_;
  Texture grain_;
};

/// Returns the force of a body of this material under a medium, on a device: stiffness and damping
/// of plane_for(), friction of friction_for(), grain of texture_for(). `grain` is usually
/// surface_grain(surface) and must outlive the haptic loop; null for a smooth body.
SolidSurface make_solid_surface(const TriangleTree& body, const SurfaceMaterial& surface,
                                const Medium& tool, const Capabilities& device,
                                std::uint32_t number, const HeightField* grain = nullptr) noexcept;

}  // namespace felt
