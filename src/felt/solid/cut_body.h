#pragma once

#include <optional>
#include <span>
#include <vector>

#include "felt/base/result.h"
#include "felt/solid/solid.h"

namespace felt {

/// Cuts a body as Teddy does (Igarashi, Matsuoka, Tanaka 1999,
/// <https://doi.org/10.1145/311535.311602>, section 3): the stroke is swept along the view
/// direction, and the part of the body at the left of the stroke is removed, as when a carpenter
/// saws off a piece of wood. The new faces lie on the swept stroke. find_cut_region() says which
/// part this is.
///
/// `path` is the stroke in the frame of the body, in mm; `view` points from the eye to the body.
/// Returns the bodies that remain, each closed (check_body()), or nullopt if the stroke does not
/// touch the body. Fails if find_cut_region() does, if nothing would remain, or if the new surface
/// would not be closed.
Result<std::optional<std::vector<SolidBody>>> cut_body(const SolidBody& body,
                                                       std::span<const Vec3> path,
                                                       const Vec3& view);

}  // namespace felt
