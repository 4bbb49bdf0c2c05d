#pragma once

#include <QString>

#include "felt/haptics/material.h"

namespace felt::desktop {

/// "Paper", translated.
QString material_label(const SurfaceMaterial& material);
/// "Firm, some friction, fine grain.": its figures in plain words.
QString material_words(const SurfaceMaterial& material);

}  // namespace felt::desktop
