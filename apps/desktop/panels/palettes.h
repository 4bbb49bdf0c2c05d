#pragma once

#include <QString>
#include <QStringList>
#include <vector>

#include "felt/io/gpl_palette.h"

namespace felt::desktop {

/// A palette by what people call it: one of ours, or a file that is read when it is chosen.
struct PaletteSource {
  QString title;
  QString path = {};     ///< "" for ours
  Palette palette = {};  ///< of ours
};

/// Ours: a box of pencils, the colours of Okabe and Ito, which people with any colour vision tell
/// apart, and greys. Names are translated.
std::vector<PaletteSource> built_in_palettes();

/// The .gpl files of the data folders (feltline/palettes in XDG_DATA_HOME and XDG_DATA_DIRS), then
/// `opened`; each path once, what is not there left out.
std::vector<PaletteSource> palette_files(const QStringList& opened);

/// Reads a .gpl file. Error: the message names the file, the line and the reason.
Result<Palette> load_palette(const QString& path);
/// Writes one, all of it or nothing. Error: the message names the file and the reason.
Result<void> save_palette(const QString& path, const Palette& palette);

}  // namespace felt::desktop
