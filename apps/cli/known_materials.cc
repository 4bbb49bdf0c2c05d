#include "known_materials.h"

#include "felt/io/picture/png.h"

namespace felt::cli {

Result<HeightPicture> load_height_picture(const std::string& path) {
  return read_height_png(path);
}

MaterialLibrary user_materials() {
  return load_materials(material_folders(), load_height_picture);
}

const MaterialLibrary& known_materials(Console& console) {
  static const MaterialLibrary kLibrary = [&console] {
    MaterialLibrary read = user_materials();
    for (const std::string& problem : read.problems) console.notice(problem);
    return read;
  }();
  return kLibrary;
}

Result<SurfaceMaterial> find_surface(const std::string& text, const Materials& known) {
  if (const SurfaceMaterial* surface = known.find_surface(text)) return *surface;
  if (text.ends_with(".toml")) {
    Result<AnyMaterial> material = read_material_file(text, load_height_picture);
    if (!material) return tl::unexpected(material.error());
    if (auto* surface = std::get_if<SurfaceMaterial>(&*material)) return std::move(*surface);
    return fail(ErrorCode::kInvalidArgument, text + " is a medium, not a surface");
  }
  std::string names;
  for (const SurfaceMaterial& surface : known.surfaces()) {
    names += (names.empty() ? "" : ", ") + surface.id;
  }
  return fail(ErrorCode::kNotFound,
              "'" + text + "' is not a known surface; the surfaces are " + names);
}

}  // namespace felt::cli
