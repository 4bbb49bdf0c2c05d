#pragma once

#include <QString>
#include <QStringList>
#include <vector>

#include "felt/io/gpl_palette.h"

namespace felt::desktop {

/// A palette as listed for the user: one of ours, or a file that is read when it is chosen.
struct PaletteSource {
  QString title;
  QString path = {};     ///< "" for one of ours
  Palette palette = {};  ///< of one of ours
};

/// Returns our palettes: a box of pencils, the colours of Okabe and Ito, which people with any
/// colour vision can distinguish, and greys. Names are translated.
std::vector<PaletteSource> built_in_palettes();

/// Returns the .gpl files of the data folders (feltline/palettes in XDG_DATA_HOME and
/// XDG_DATA_DIRS), then `opened`; each path once, without files that do not exist.
std::vector<PaletteSource> palette_files(const QStringList& opened);

/// Reads a .gpl file. The error names the file, the line and the reason.
Result<Palette> load_palette(const QString& path);
/// Writes a .gpl file whole or not at all. The error names the file and the reason.
Result<void> save_palette(const QString& path, const Palette& palette);

}  // namespace felt::desktop
