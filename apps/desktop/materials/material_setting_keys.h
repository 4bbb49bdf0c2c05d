#pragma once

namespace felt::desktop::material_keys {

/// A list of texts: materials that were changed and not saved (OwnMaterials).
inline constexpr auto kUnsaved = "materials/unsaved";
/// Place and size of the editor's window, and of its parts.
inline constexpr auto kGeometry = "materials/geometry";
inline constexpr auto kParts = "materials/parts";

}  // namespace felt::desktop::material_keys
