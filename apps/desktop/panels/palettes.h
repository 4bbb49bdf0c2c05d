#pragma once

#include <QString>
#include <QStringList>
#include <vector>

#include "felt/io/gpl_palette.h"

namespace felt::desktop {

/// A palette in a list: a built-in one, or a file that is read when the user chooses it.
struct PaletteSource {
  QString title;
  QString path = {};     ///< "" for a built-in palette
  Palette palette = {};  ///< only for a built-in palette
};

/// Returns the built-in palettes: a box of pencils, the colours of Okabe and Ito, which people
/// with any colour vision can distinguish, and greys. Names are translated.
std::vector<PaletteSource> built_in_palettes();

/// Returns the .gpl files in the data folders (feltline/palettes in XDG_DATA_HOME and
/// XDG_DATA_DIRS), and then the files `opened`. Each path is returned once; files that do not exist
/// are skipped.
std::vector<PaletteSource> palette_files(const QStringList& opened);

/// Reads a .gpl file. The error names the file, the line and the reason.
Result<Palette> load_palette(const QString& path);
/// Writes a .gpl file completely or not at all. The error names the file and the reason.
Result<void> save_palette(const QString& path, const Palette& palette);

}  // namespace felt::desktop
