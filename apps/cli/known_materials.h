#pragma once

#include "console.h"
#include "felt/material/material_library.h"

namespace felt::cli {

/// Sheets and media that are known here: those that Feltline brings, and what lies in the folders
/// of material_folders().
MaterialLibrary own_materials();
/// The same, read when first asked for; what is wrong with a file is a notice, once.
const MaterialLibrary& known_materials(Console& console);

/// One of these sheets by its id, or one from a file NAME.toml. Error: there is none; the message
/// begins with it.
Result<SurfaceMaterial> find_sheet(const std::string& text, const Materials& known);

/// A picture beside the text of a material.
Result<HeightPicture> load_height_picture(const std::string& path);

}  // namespace felt::cli
