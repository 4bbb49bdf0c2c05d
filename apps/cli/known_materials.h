#pragma once

#include "console.h"
#include "felt/material/material_library.h"

namespace felt::cli {

/// Returns the surfaces and media that are known: the built-in ones, and those in the folders of
/// material_folders().
MaterialLibrary own_materials();
/// Same, but reads them on first use. Prints a notice for each invalid file, once.
const MaterialLibrary& known_materials(Console& console);

/// Returns one of these surfaces by its id, or one from a file NAME.toml. Fails if there is none;
/// the message begins with `text`.
Result<SurfaceMaterial> find_sheet(const std::string& text, const Materials& known);

/// Loads a picture that is next to the text of a material.
Result<HeightPicture> load_height_picture(const std::string& path);

}  // namespace felt::cli
