#pragma once

#include <QString>

#include "felt/material/materials.h"

namespace felt::desktop {

/// "Paper", translated.
QString material_label(const SurfaceMaterial& material);
/// "Firm, some friction, fine grain.": its figures in plain words.
QString material_words(const SurfaceMaterial& material);
/// The same of a medium: "Pencil"; "Dry, some friction, all of the grain.".
QString medium_label(const Medium& medium);
QString medium_words(const Medium& medium);

}  // namespace felt::desktop
