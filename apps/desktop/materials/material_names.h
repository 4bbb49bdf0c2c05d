#pragma once

#include <QString>
#include <compare>
#include <functional>
#include <optional>
#include <string>

#include "felt/material/material_file.h"

namespace felt::desktop {

/// Identifies a surface or a medium; a surface and a medium may have the same id.
struct MaterialKey {
  bool is_surface = true;
  std::string id;

  friend auto operator<=>(const MaterialKey&, const MaterialKey&) = default;
};

MaterialKey key_of(const AnyMaterial& material);
/// These functions return null if `materials` does not contain the key.
const SurfaceMaterial* surface_in(const Materials& materials, const MaterialKey& key);
const Medium* medium_in(const Materials& materials, const MaterialKey& key);
/// Returns nullopt if `materials` does not contain the key.
std::optional<AnyMaterial> find_in(const Materials& materials, const MaterialKey& key);
/// Returns true if the material of this key is built in.
bool is_built_in(const MaterialKey& key);

/// Returns the material's name, translated if it is built in.
QString name_of(const AnyMaterial& material);
/// Returns the material's figures in plain words.
QString words_of(const AnyMaterial& material);

/// Returns an id for a name: "my-soft-chalk" for "My soft chalk". If `is_taken` returns true for
/// that id, appends the lowest number, from 2, that makes an unused id ("my-soft-chalk-2"). If the
/// name has no Latin letter and no digit, uses `fallback` in its place.
std::string id_for(const QString& name, const std::string& fallback,
                   const std::function<bool(const std::string&)>& is_taken);

/// Returns a name that a material may have: without control characters and extra spaces, and at
/// most kMaxMaterialLabelBytes long. Returns "" if nothing is left.
QString label_for(const QString& name);

/// Returns the material with the given id and the name label_for(name). If that name is "", uses
/// the default name of the id.
AnyMaterial renamed(AnyMaterial material, const std::string& id, const QString& name);

}  // namespace felt::desktop
