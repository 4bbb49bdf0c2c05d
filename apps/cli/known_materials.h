#pragma once

#include "console.h"
#include "felt/material/material_library.h"

namespace felt::cli {

/// Returns the known surfaces and media: the built-in ones, and those in the folders of
/// material_folders().
MaterialLibrary user_materials();
/// Returns the result of user_materials(). The first call runs that function and prints one notice
/// for each invalid file; later calls return the same result.
const MaterialLibrary& known_materials(Console& console);

/// Returns the surface that `text` specifies: the id of a known surface, or a file NAME.toml. Fails
/// if neither exists; the message begins with `text`.
Result<SurfaceMaterial> find_surface(const std::string& text, const Materials& known);

/// Loads the height picture to which the text of a material refers.
Result<HeightPicture> load_height_picture(const std::string& path);

}  // namespace felt::cli
