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

/// A sheet or a medium as one text has it. Format: docs/formats/material.md.
using AnyMaterial = std::variant<SurfaceMaterial, Medium>;

/// Longest text of a material, and longest line of one.
inline constexpr std::size_t kMaxMaterialBytes = std::size_t{64} << 10;
inline constexpr std::size_t kMaxMaterialLine = 500;
inline constexpr std::size_t kMaxMaterialIdChars = 64;
inline constexpr std::size_t kMaxMaterialLabelBytes = 80;

struct MaterialSource {
  /// What messages begin with: the name of the file.
  std::string name = "material";
  /// Reads the picture that `grain.picture` names (io/png.h does). Without it such a text is
  /// refused: a session reads no file, and what it is told must say all.
  std::function<Result<HeightPicture>(const std::string& file)> load_picture = {};
};

/// Reads one material. Error: no TOML, no kind or id, an unknown key, a value of the wrong type or
/// out of its range (NaN and infinity are), a text or line that is too long; the first one, by its
/// place: "my-paper.toml:7: grain.height_um is 900, it must be 0 to 200 um".
Result<AnyMaterial> read_material(std::string_view text, const MaterialSource& source = {});

/// All that is wrong with it, by place; none if read_material takes it.
std::vector<Error> material_problems(std::string_view text, const MaterialSource& source = {});

/// The text of a material: every figure, each with its range and what it is. A relief of one's own
/// is in it as numbers, so that the text says all. `read_material` gives an equal material back;
/// the same material gives the same text.
///
/// Requires one that a text may have (material_error is empty): the editor keeps to the ranges.
std::string write_material(const SurfaceMaterial& surface);
std::string write_material(const Medium& medium);
std::string write_material(const AnyMaterial& material);

/// What a text of it would be refused for; "" for nothing.
std::string material_error(const AnyMaterial& material);

/// 1 to 64 of a-z, 0-9 and '-'.
bool is_material_id(std::string_view id) noexcept;

const std::string& id_of(const AnyMaterial& material) noexcept;
const std::string& label_of(const AnyMaterial& material) noexcept;
/// "sheet" or "medium".
std::string_view kind_of(const AnyMaterial& material) noexcept;

/// What people call one that has no label: "My paper" for "my-paper".
std::string label_of_id(std::string_view id);
/// "sheet my-paper": one of all materials.
std::string material_key(const AnyMaterial& material);

/// Materials::put of either.
void put(Materials& materials, AnyMaterial material);

/// Those of `materials` that the built-in ones do not have, or have otherwise: what a recording or
/// a document must bring along. Sheets first, in their order.
std::vector<AnyMaterial> not_built_in(const Materials& materials);

}  // namespace felt
