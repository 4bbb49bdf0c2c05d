#pragma once

#include <QString>
#include <compare>
#include <functional>
#include <optional>
#include <string>

#include "felt/material/material_file.h"

namespace felt::desktop {

/// Which sheet or medium: two of one id may be both.
struct MaterialKey {
  bool is_sheet = true;
  std::string id;

  friend auto operator<=>(const MaterialKey&, const MaterialKey&) = default;
};

MaterialKey key_of(const AnyMaterial& material);
/// Null where there is none.
const SurfaceMaterial* sheet_in(const Materials& materials, const MaterialKey& key);
const Medium* medium_in(const Materials& materials, const MaterialKey& key);
/// Nothing where there is none.
std::optional<AnyMaterial> find_in(const Materials& materials, const MaterialKey& key);
/// One that Feltline brings.
bool is_built_in(const MaterialKey& key);

/// Its name, translated where Feltline brings it.
QString name_of(const AnyMaterial& material);
/// Its figures in plain words.
QString words_of(const AnyMaterial& material);

/// An id for a name: "My soft chalk" is "my-soft-chalk"; with a number behind it while `is_taken`
/// says so. `fallback` where the name has no letter of the Latin alphabet.
std::string id_for(const QString& name, const std::string& fallback,
                   const std::function<bool(const std::string&)>& is_taken);

/// A name as a material may have it: without control characters and needless spaces, and no longer
/// than kMaxMaterialLabelBytes; "" where nothing is left.
QString label_for(const QString& name);

/// The same material with another id and name (label_for, else what people call that id).
AnyMaterial renamed(AnyMaterial material, const std::string& id, const QString& name);

}  // namespace felt::desktop
