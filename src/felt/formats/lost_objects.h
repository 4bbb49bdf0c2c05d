#pragma once

#include <cstddef>

#include "felt/document/document.h"
#include "felt/formats/file_format.h"

namespace felt {

/// The numbers of objects that a written file does not contain because its format cannot.
struct LostObjects {
  std::size_t fills = 0;
  std::size_t pictures = 0;  ///< pictures to draw over
  std::size_t blends = 0;    ///< layers and groups with a blend mode, which becomes normal
  std::size_t groups = 0;    ///< groups of layers
  std::size_t timings = 0;   ///< layers with a timing as a key drawing
  std::size_t body_edits = 0;

  friend bool operator==(const LostObjects&, const LostObjects&) noexcept = default;
};

/// Counts the fills, pictures, blend modes, groups, timings and body edits of a document that a
/// file of this format cannot contain. Counts those of hidden layers only if the format holds
/// hidden layers, groups only if the format holds layers, and timings and body edits only if the
/// file is more than a picture. `compact` is WriteOptions::compact. Pictures that the format can
/// show, but that were not asked for, are not lost.
LostObjects lost_objects(const Document& document, FileFormat format, bool compact = false);

}  // namespace felt
