#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/material/material_file.h"

namespace felt {

/// Reads a greyscale picture from a file, for example read_height_png of io/png.h. If the function
/// is empty, a material that names a picture is an error.
using LoadPicture = std::function<Result<HeightPicture>(const std::string& path)>;

/// A material that is not built in, and the path of its file.
struct MaterialEntry {
  AnyMaterial material;
  std::string path;
};

/// All available materials.
struct MaterialLibrary {
  Materials materials = Materials::built_in();  ///< built-in materials, then those of the folders
  std::vector<MaterialEntry> own;  ///< materials of the folders, ordered by folder, then by file
                                   ///< name
  /// One message for each file that could not be read. The other files are still loaded.
  std::vector<std::string> problems;
};

/// Returns the folders that may contain materials: feltline/materials in XDG_DATA_HOME (default
/// ~/.local/share), then in each of XDG_DATA_DIRS (default /usr/local/share and /usr/share). The
/// first element is the user's folder; it is "" if neither XDG_DATA_HOME nor HOME is set. Reads the
/// environment, so no other thread may change it meanwhile.
std::vector<std::string> material_folders();

/// Loads all *.toml files of these folders (not of their subfolders). Skips missing folders.
///
/// The id of a material must differ from the ids of the built-in surfaces and media, so that a
/// drawing looks the same on every computer. If two files of a folder have the same id, the second
/// file is skipped and reported in `problems`. If an earlier folder already has the id, the file is
/// skipped without a report.
MaterialLibrary load_materials(std::span<const std::string> folders,
                               const LoadPicture& load_picture = {});

/// Reads one file. If the material names a picture, also reads the picture from the same folder.
/// Fails if the file cannot be read or read_material fails; the error names the file.
Result<AnyMaterial> read_material_file(const std::string& path,
                                       const LoadPicture& load_picture = {});

/// Returns the MaterialSource for the text of a file. It contains the name of the file and loads
/// pictures from the same folder.
MaterialSource material_source(const std::string& path, const LoadPicture& load_picture = {});

/// Returns the path of the file in `folder` that has a material of the same kind and id as
/// `material`, even if the other fields differ; returns "" if no such file can be read.
std::string material_path(const std::string& folder, const AnyMaterial& material);

/// Saves a user-defined material in a folder, which is created if necessary. If a file in the
/// folder has the same kind and id, replaces that file; otherwise writes ID.toml. The file is
/// replaced completely or not at all. Returns the path of the file. Fails if the id is built in,
/// material_error() is not "", a file has the same id but the other kind, ID.toml has another
/// material, or the disk fails.
Result<std::string> save_material(const std::string& folder, const AnyMaterial& material);

/// Deletes the file with the kind and id of this material. Fails if the folder has no such file, or
/// the disk fails.
Result<void> delete_material(const std::string& folder, const AnyMaterial& material);

/// Returns "" if a user-defined material may have this id; otherwise the reason why not.
std::string new_id_error(std::string_view id);

/// The text of a built-in material, with comments that name the sources of its values.
struct BuiltInText {
  std::string_view id;
  std::string_view text;
};
/// Returns the texts of all built-in materials, surfaces first, in the order of
/// Materials::built_in().
std::span<const BuiltInText> built_in_texts() noexcept;

}  // namespace felt
