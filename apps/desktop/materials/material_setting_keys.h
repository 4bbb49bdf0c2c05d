#pragma once

namespace felt::desktop::material_keys {

/// A list of the texts of materials with unsaved changes (UserMaterials).
inline constexpr auto kUnsaved = "materials/unsaved";
/// Position and size of the editor's window, and sizes of its parts.
inline constexpr auto kGeometry = "materials/geometry";
inline constexpr auto kParts = "materials/parts";

}  // namespace felt::desktop::material_keys
