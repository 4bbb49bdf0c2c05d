#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "felt/document/drawing.h"
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
  std::size_t guides = 0;
  std::size_t symmetries = 0;  ///< groups of strokes that are mirror images of each other
  std::size_t opacities = 0;   ///< layers and groups whose opacity goes to each of their strokes
  std::size_t layers = 0;      ///< layers whose strokes become lines without layers
  std::size_t locks = 0;       ///< locked layers, which become unlocked
  std::size_t hidden_strokes = 0;  ///< strokes of hidden layers, which are left out
  std::size_t shown_strokes = 0;   ///< strokes of hidden layers, which become visible
  std::size_t sharp_ends = 0;      ///< strokes whose flat ends and pointed corners become round
  std::size_t media = 0;           ///< strokes of a medium that becomes a plain pen
  std::size_t materials = 0;       ///< texts of custom materials
  std::size_t names = 0;           ///< strokes with a name that the format cannot hold

  friend bool operator==(const LostObjects&, const LostObjects&) noexcept = default;
};

/// Counts the objects of a drawing that a file of this format cannot contain. Counts those of
/// hidden layers only if the format holds hidden layers, groups and locks only if the format holds
/// layers, and timings, guides, symmetry groups and body edits only if the file is more than a
/// picture. `compact` is WriteOptions::compact. Pictures that the format can show, but that were
/// not asked for, are not lost. The page, the palette, the view and the recordings are not
/// objects of the picture and are not counted.
LostObjects lost_objects(const Drawing& drawing, FileFormat format, bool compact = false);

/// Returns the losses as sentences without a subject, such as "2 fills were left out, because the
/// format has only lines": one for each kind that was lost.
std::vector<std::string> loss_texts(const LostObjects& lost);

}  // namespace felt
