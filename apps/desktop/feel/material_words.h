#pragma once

#include <QString>

#include "felt/material/materials.h"

namespace felt::desktop {

/// Returns the translated name of the surface, such as "Paper".
QString material_label(const SurfaceMaterial& material);
/// Describes the surface's values in plain words: "Firm, some friction, fine grain.".
QString material_words(const SurfaceMaterial& material);
/// These functions do the same for a medium: "Pencil"; "Dry, some friction, all of the grain.".
QString medium_label(const Medium& medium);
QString medium_words(const Medium& medium);

}  // namespace felt::desktop
