#pragma once

#include <QPointF>
#include <optional>
#include <vector>

#include "felt/document/body_edit.h"
#include "felt/solid/body_edits.h"
#include "felt/solid/solid_picture.h"

namespace felt::desktop {

/// Returns the stroke that the user has drawn over the picture of a solid, in the frame of edits of
/// the body (BodyEdit): on the plane through the origin of the solid that faces the camera.
/// `origin` is that of the solid. Points that are nearer to the one before than a third of a pixel
/// are left out.
std::vector<Vec3> stroke_over_solid(const SolidCamera& camera, const std::vector<QPointF>& px,
                                    Point origin);

/// Returns the profile of an extrusion that the user has drawn over the picture: on the plane
/// through the middle of the ring that contains its normal and faces the camera as much as it can.
/// Returns nullopt if the camera looks along the normal, within kMinProfileDeg, because the profile
/// has no height there. The result is in the frame of edits of the body.
std::optional<std::vector<Vec3>> profile_over_solid(const SolidCamera& camera,
                                                    const std::vector<QPointF>& px,
                                                    const ExtrusionRing& ring, Point origin);
inline constexpr double kMinProfileDeg = 20.0;

}  // namespace felt::desktop
