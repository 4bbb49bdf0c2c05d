#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "felt/material/materials.h"

namespace felt {

/// What a figure of a material is.
enum class MaterialFieldKind : std::uint8_t {
  kNumber,
  kWhole,   ///< a whole number
  kSwitch,  ///< true or false, as 1 and 0
  kChoice,  ///< one of `choices`, as its index
  kColor,   ///< "#rrggbb", as 0xRRGGBB
};

/// One figure of a material: a line of its text, a row of the editor, a line of
/// docs/formats/material.md. Beside these a text has `kind`, `id`, `label`, a sheet's own relief
/// (`grain.picture`, `grain.heights`) and a medium's table `pairs`.
template <class Material>
struct MaterialField {
  std::string_view id;     ///< "grain.height_um": table and key, the unit in the name
  std::string_view label;  ///< for people: "Height of the grain"
  std::string_view unit;   ///< "um", "" for none
  MaterialFieldKind kind = MaterialFieldKind::kNumber;
  double min = 0.0;  ///< kNumber, kWhole
  double max = 0.0;
  std::span<const std::string_view> choices = {};
  std::string_view help;  ///< one sentence
  double (*get)(const Material&) noexcept = nullptr;
  /// Requires a value within the range.
  void (*set)(Material&, double) noexcept = nullptr;

  /// What a material has whose text does not say.
  [[nodiscard]] double fallback() const { return get(Material{}); }
  /// A wavelength of 0 stands for no grain at all: outside of its range, and not written.
  [[nodiscard]] bool allows(double value) const noexcept;
};

using SheetField = MaterialField<SurfaceMaterial>;
using MediumField = MaterialField<Medium>;

/// In the order of the text: figures of one table follow each other, those of none come first.
std::span<const SheetField> sheet_fields() noexcept;
std::span<const MediumField> medium_fields() noexcept;

/// By id, or null.
const SheetField* find_sheet_field(std::string_view id) noexcept;
const MediumField* find_medium_field(std::string_view id) noexcept;

/// What it may be, for messages and documents: "0 to 200 um", "one of grain, rough".
std::string allowed_text(const SheetField& field);
std::string allowed_text(const MediumField& field);

/// The words of HeightCharacter, in its order.
inline constexpr std::array<std::string_view, 6> kGrainCharacters = {"grain",  "rough", "weave",
                                                                     "fibres", "wood",  "picture"};

inline constexpr std::size_t kMaxPairs = 64;

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
  return value >= min && value <= max;  // NaN is not
}

}  // namespace felt
