#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/material/material_file.h"

namespace felt {

/// Reads a grey picture from a file; io/png.h, read_height_png. Without one, a material that names
/// a picture is a problem.
using LoadPicture = std::function<Result<HeightPicture>(const std::string& path)>;

/// A material that is not built in, and where it is.
struct MaterialEntry {
  AnyMaterial material;
  std::string path;
};

/// What there is to draw on and with.
struct MaterialLibrary {
  Materials materials = Materials::built_in();  ///< the built-in ones, then those of the folders
  std::vector<MaterialEntry> own;               ///< by folder, then by file name
  /// One sentence each, by file: the others are there all the same.
  std::vector<std::string> problems;
};

/// Where materials are looked for, the first one a person's own: feltline/materials in
/// XDG_DATA_HOME (else ~/.local/share), then in each of XDG_DATA_DIRS (else /usr/local/share and
/// /usr/share). The first is "" where neither XDG_DATA_HOME nor HOME says where. Reads the
/// environment: not while another thread changes it.
std::vector<std::string> material_folders();

/// All *.toml of these folders (not of folders in them). A folder that is not there is none.
///
/// Ids: a material has one of its own, which no built-in one has, sheet or medium, so that a
/// drawing says the same to everybody who gets it. Where two files of a folder have one id, the
/// second is a problem; what an earlier folder has is left out of a later one.
MaterialLibrary load_materials(std::span<const std::string> folders,
                               const LoadPicture& load_picture = {});

/// Reads one file, with the picture beside it that it may name. Error: it cannot be read, or what
/// read_material refuses; names the file.
Result<AnyMaterial> read_material_file(const std::string& path,
                                       const LoadPicture& load_picture = {});

/// For the text of a file: its name, and pictures beside it.
MaterialSource material_source(const std::string& path, const LoadPicture& load_picture = {});

/// The file of a folder that has a material of this one's kind and id, whatever its figures; ""
/// where none has, that can be read.
std::string material_path(const std::string& folder, const AnyMaterial& material);

/// Writes a person's own into a folder, which is made: over the file that has its kind and id, else
/// as ID.toml. The old file or the new one, whole. Returns its path. Error: the id of a built-in
/// one, what material_error says, a file that has its id and is of the other kind, another material
/// in ID.toml, or the disk.
Result<std::string> save_material(const std::string& folder, const AnyMaterial& material);

/// Deletes the file that has this one's kind and id. Error: no file of this folder has them, or the
/// disk.
Result<void> delete_material(const std::string& folder, const AnyMaterial& material);

/// "" for an id that a material of one's own may have; else why it may not.
std::string own_id_error(std::string_view id);

/// The text of a built-in material as Feltline brings it, with where its figures come from.
struct BuiltInText {
  std::string_view id;
  std::string_view text;
};
/// Sheets first, in the order of Materials::built_in().
std::span<const BuiltInText> built_in_texts() noexcept;

}  // namespace felt
