#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/geometry/height_picture.h"

namespace felt {

/// Side of the square of heights that the text of a material holds; the finest wave of a relief has
/// three of them (HeightField::kBand).
inline constexpr int kOwnReliefSide = 128;

/// A person's own relief, for SurfaceMaterial::picture, as a text can hold it: kOwnReliefSide^2
/// heights of 16 bits, whatever the picture had. The same heights are the same object, so that
/// materials of equal texts are equal and a relief is made once (60 ms). Any thread but the haptic
/// one. Error: what height_field_of refuses.
Result<std::shared_ptr<const HeightField>> own_relief(const HeightPicture& picture);

/// The same from what own_relief_text wrote; white space counts for nothing. Error: anything else.
Result<std::shared_ptr<const HeightField>> own_relief(std::string_view text);

/// Its heights, 16 bits each, high byte first, row by row, in base64 (RFC 4648) of 76 letters a
/// line. One that was not made here is looked at where the heights lie.
std::string own_relief_text(const HeightField& relief);

}  // namespace felt
