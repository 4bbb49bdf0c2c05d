#include <string>
#include <utility>

#include "felt/base/check.h"
#include "felt/material/material_library.h"

namespace felt {

// The values and their sources are in share/materials.
const Materials& Materials::built_in() {
  static const Materials all = [] {
    Materials made;
    for (const BuiltInText& built_in : built_in_texts()) {
      Result<AnyMaterial> material =
          read_material(built_in.text, {.name = std::string(built_in.id), .load_picture = {}});
      FELT_CHECK(material.has_value());  // if it fails, material_library_test says why
      felt::put(made, *std::move(material));
    }
    return made;
  }();
  return all;
}

}  // namespace felt
