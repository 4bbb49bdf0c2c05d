#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/geometry/height_picture.h"

namespace felt {

/// Number of heights along each side of a custom relief, which the text of a material stores as a
/// square of heights. The shortest wave of a relief spans about three heights (HeightField::kBand).
inline constexpr int kOwnReliefSide = 128;

/// Converts a picture to a custom relief for SurfaceMaterial::picture. Resamples the picture to
/// kOwnReliefSide^2 heights of 16 bits, as in the text of a material. Returns the same object for
/// the same heights, so that materials with equal texts compare equal and each relief is computed
/// only once, which takes 60 ms. Call on any thread except the haptic thread. Fails if
/// height_field_of fails.
Result<std::shared_ptr<const HeightField>> custom_relief(const HeightPicture& picture);

/// Returns the custom relief of a text written by custom_relief_text; white space is ignored. Fails
/// if the text is anything else.
Result<std::shared_ptr<const HeightField>> custom_relief(std::string_view text);

/// Returns the heights of a relief, 16 bits each, high byte first, row by row, in base64 (RFC 4648)
/// with 76 letters on each line. If custom_relief() did not make the relief, it is sampled first.
std::string custom_relief_text(const HeightField& relief);

}  // namespace felt
