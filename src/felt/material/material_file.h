#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "felt/base/result.h"
#include "felt/geometry/height_picture.h"
#include "felt/material/materials.h"

namespace felt {

/// A surface or a medium, as read from one text. Format: docs/formats/material.md.
using AnyMaterial = std::variant<SurfaceMaterial, Medium>;

/// Limits of a text: its size in bytes, and the length of an id and of a label.
inline constexpr std::size_t kMaxMaterialBytes = std::size_t{64} << 10;
inline constexpr std::size_t kMaxMaterialIdChars = 64;
inline constexpr std::size_t kMaxMaterialLabelBytes = 80;

/// The origin of a text.
struct MaterialSource {
  /// The name of the file; messages start with it.
  std::string name = "material";
  /// Reads the picture that `grain.picture` names (see io/png.h). If this function is empty, a text
  /// that names a picture is an error, because a session reads no files: the text must contain
  /// everything.
  std::function<Result<HeightPicture>(const std::string& file)> load_picture = {};
};

/// Reads one material. Fails if the text is not TOML, has no kind or id, has an unknown key, or is
/// too long, or if a line is too long. Also fails if a value has the wrong type or is out of range
/// (NaN and infinity always are). Reports the first error with its line: "my-paper.toml:7:
/// grain.height_um is 900, it must be 0 to 200 um".
Result<AnyMaterial> read_material(std::string_view text, const MaterialSource& source = {});

/// Returns all errors of a text in the order of their lines; empty if read_material accepts it.
std::vector<Error> material_problems(std::string_view text, const MaterialSource& source = {});

/// Returns the text of a material: every field, with its range and its meaning as a comment. A
/// custom relief is included as numbers, so that the text is complete. For this text,
/// `read_material` returns an equal material. The same material always gives the same text.
///
/// Requires that material_error() is "". This is always true in the editor, because the editor
/// allows only values in range.
std::string write_material(const SurfaceMaterial& surface);
std::string write_material(const Medium& medium);
std::string write_material(const AnyMaterial& material);

/// Returns the reason why read_material would reject the text of this material, or "" if it would
/// accept the text.
std::string material_error(const AnyMaterial& material);

/// Returns true for 1 to 64 characters of a-z, 0-9 and '-'.
bool is_material_id(std::string_view id) noexcept;

const std::string& id_of(const AnyMaterial& material) noexcept;
const std::string& label_of(const AnyMaterial& material) noexcept;
/// Returns "surface" or "medium".
std::string_view kind_of(const AnyMaterial& material) noexcept;

/// Returns the label for a material without a label: "My paper" for "my-paper".
std::string label_of_id(std::string_view id);
/// Returns the kind and id, which together identify a material: "surface my-paper".
std::string material_key(const AnyMaterial& material);

/// Calls Materials::put with the surface or medium.
void put(Materials& materials, AnyMaterial material);

/// Returns the materials that are not built in, or that differ from the built-in material with the
/// same id. A recording or a document must contain these. Surfaces first, in the order of
/// `materials`.
std::vector<AnyMaterial> not_built_in(const Materials& materials);

}  // namespace felt
