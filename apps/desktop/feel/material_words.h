#pragma once

#include <QString>

#include "felt/material/materials.h"

namespace felt::desktop {

/// Returns the translated name: "Paper".
QString material_label(const SurfaceMaterial& material);
/// Returns the surface's figures in plain words: "Firm, some friction, fine grain.".
QString material_words(const SurfaceMaterial& material);
/// Returns the same for a medium: "Pencil"; "Dry, some friction, all of the grain.".
QString medium_label(const Medium& medium);
QString medium_words(const Medium& medium);

}  // namespace felt::desktop
