#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "felt/material/materials.h"

namespace felt {

/// The type of a field of a material.
enum class MaterialFieldKind : std::uint8_t {
  kNumber,
  kWhole,   ///< a whole number
  kSwitch,  ///< true or false, as 1 and 0
  kChoice,  ///< one of `choices`, as its index
  kColor,   ///< "#rrggbb", as 0xRRGGBB
};

/// One field of a material. Each field is a line of the material's text, a row of the editor and a
/// line of docs/formats/material.md. Besides these fields, a text has `kind`, `id` and `label`. The
/// text of a surface may also have a custom relief (`grain.picture`, `grain.heights`), and the text
/// of a medium may have the table `pairs` and the shape of its style (`style.shape`).
template <class Material>
struct MaterialField {
  std::string_view id;     ///< table and key, with the unit in the name: "grain.height_um"
  std::string_view label;  ///< the name in the user interface: "Height of the grain"
  std::string_view unit;   ///< "um"; "" if there is none
  MaterialFieldKind kind = MaterialFieldKind::kNumber;
  double min = 0.0;  ///< smallest allowed value, for kNumber and kWhole
  double max = 0.0;  ///< largest allowed value
  std::span<const std::string_view> choices = {};
  std::string_view help;  ///< one sentence for the user
  double (*get)(const Material&) noexcept = nullptr;
  /// Sets the field. Requires a value that allows() accepts.
  void (*set)(Material&, double) noexcept = nullptr;

  /// Returns the value that the field has if the text leaves it out.
  [[nodiscard]] double fallback() const { return get(Material{}); }
  /// Returns true if the value is in range. The wavelength 0, which means "no grain", is out of
  /// range, so it is not written to a text.
  [[nodiscard]] bool allows(double value) const noexcept;
};

using SurfaceField = MaterialField<SurfaceMaterial>;
using MediumField = MaterialField<Medium>;

/// Returns all fields in the order of the text: first the fields without a table, then the others
/// table by table.
std::span<const SurfaceField> surface_fields() noexcept;
std::span<const MediumField> medium_fields() noexcept;

/// Returns the field with this id, or null.
const SurfaceField* find_surface_field(std::string_view id) noexcept;
const MediumField* find_medium_field(std::string_view id) noexcept;

/// Returns the allowed values, for messages and documents: "0 to 200 um", "one of grain, rough".
std::string allowed_text(const SurfaceField& field);
std::string allowed_text(const MediumField& field);

/// The names of the values of HeightCharacter, in the order of the enumeration.
inline constexpr std::array<std::string_view, 6> kGrainCharacters = {"grain",  "rough", "weave",
                                                                     "fibres", "wood",  "picture"};

inline constexpr std::size_t kMaxPairs = 64;

/// The key of MediumStyle::shape.
inline constexpr std::string_view kStyleShapeKey = "style.shape";

template <class Material>
bool MaterialField<Material>::allows(double value) const noexcept {
  switch (kind) {
    case MaterialFieldKind::kSwitch:
      return value == 0.0 || value == 1.0;
    case MaterialFieldKind::kChoice:
      for (std::size_t i = 0; i < choices.size(); ++i) {
        if (value == static_cast<double>(i)) return true;
      }
      return false;
    case MaterialFieldKind::kColor:
      return value >= 0.0 && value <= 0xFFFFFF && value == static_cast<std::uint32_t>(value);
    case MaterialFieldKind::kWhole:
      return value >= min && value <= max &&
             value == static_cast<double>(static_cast<std::int64_t>(value));
    case MaterialFieldKind::kNumber:
      break;
  }
  return value >= min && value <= max;  // false for NaN
}

}  // namespace felt
