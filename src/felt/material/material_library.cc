#include "felt/material/material_library.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <system_error>
#include <utility>

#include "felt/base/atomic_file.h"
#include "felt/base/read_file.h"

namespace felt {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxFiles = 1000;  // in one folder
constexpr const char* kBelow = "/feltline/materials";

/// Returns the value of an environment variable if it is an absolute path; otherwise "".
std::string folder_in(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value == '/' ? value : "";
}

/// Returns the sorted names of the *.toml files of a folder.
std::vector<std::string> files_of(const std::string& folder, std::vector<std::string>& problems) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    std::error_code unknown;
    const std::string name = at->path().filename().string();
    // Reads only regular files, because reading a pipe could block.
    if (!at->is_regular_file(unknown) || !name.ends_with(".toml") || name[0] == '.') continue;
    if (names.size() == kMaxFiles) {
      problems.push_back(folder + ": only " + std::to_string(kMaxFiles) +
                         " of the materials in this folder are read");
      break;
    }
    names.push_back(name);
  }
  if (error && error != std::errc::no_such_file_or_directory &&
      error != std::errc::not_a_directory) {
    problems.push_back(folder + ": cannot read: " + error.message());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// Adds the materials of one folder, except those with ids in `known`.
void add_folder(const std::string& folder, const LoadPicture& load_picture,
                const std::set<std::string>& known, MaterialLibrary& library) {
  std::set<std::string> here;
  for (const std::string& name : files_of(folder, library.problems)) {
    const std::string path = folder + "/" + name;
    Result<AnyMaterial> material = read_material_file(path, load_picture);
    if (!material) {
      library.problems.push_back(material.error().message);
      continue;
    }
    const std::string id = id_of(*material);
    if (const std::string taken = new_id_error(id); !taken.empty()) {
      library.problems.push_back(path + ": " + taken);
    } else if (!here.insert(id).second) {
      library.problems.push_back(path + ": another file in this folder has the id " + id);
    } else if (!known.contains(id)) {
      put(library.materials, *material);
      library.own.push_back({*std::move(material), path});
    }
  }
}

const MaterialEntry* find_own(const MaterialLibrary& library, std::string_view id) {
  const auto at = std::find_if(library.own.begin(), library.own.end(),
                               [&](const auto& entry) { return id_of(entry.material) == id; });
  return at == library.own.end() ? nullptr : &*at;
}

MaterialLibrary library_of(const std::string& folder) {
  // Uses a dummy picture for all materials, because only their ids are needed.
  return load_materials(std::span(&folder, 1), [](const std::string&) -> Result<HeightPicture> {
    return HeightPicture{.width = 2, .height = 1, .heights = {0.0F, 1.0F}};
  });
}

}  // namespace

std::vector<std::string> material_folders() {
  std::string own = folder_in("XDG_DATA_HOME");
  if (own.empty()) {
    const std::string home = folder_in("HOME");
    if (!home.empty()) own = home + "/.local/share";
  }
  std::vector<std::string> folders = {own.empty() ? "" : own + kBelow};
  const char* reported = std::getenv("XDG_DATA_DIRS");
  std::string_view dirs =
      reported != nullptr && *reported != '\0' ? reported : "/usr/local/share:/usr/share";
  while (!dirs.empty()) {
    const std::size_t end = std::min(dirs.find(':'), dirs.size());
    std::string folder(dirs.substr(0, end));
    while (folder.size() > 1 && folder.back() == '/') folder.pop_back();
    // Relative paths must be ignored (XDG base directory specification).
    if (folder.starts_with('/')) folders.push_back(folder + kBelow);
    dirs.remove_prefix(std::min(end + 1, dirs.size()));
  }
  return folders;
}

MaterialSource material_source(const std::string& path, const LoadPicture& load_picture) {
  MaterialSource source{.name = path == "-" ? "stdin" : path, .load_picture = {}};
  if (load_picture) {
    source.load_picture = [folder = fs::path(path).parent_path(), load_picture](const auto& file) {
      return load_picture((folder / file).string());
    };
  }
  return source;
}

Result<AnyMaterial> read_material_file(const std::string& path, const LoadPicture& load_picture) {
  const Result<std::string> text =
      path == "-" ? read_file(path, kMaxMaterialBytes) : read_regular_file(path, kMaxMaterialBytes);
  if (!text) return tl::unexpected(text.error());
  return read_material(*text, material_source(path, load_picture));
}

MaterialLibrary load_materials(std::span<const std::string> folders,
                               const LoadPicture& load_picture) {
  MaterialLibrary library;
  std::set<std::string> known;
  for (const std::string& folder : folders) {
    if (folder.empty()) continue;
    add_folder(folder, load_picture, known, library);
    for (const MaterialEntry& entry : library.own) known.insert(id_of(entry.material));
  }
  return library;
}

Result<std::string> save_material(const std::string& folder, const AnyMaterial& material) {
  const std::string& id = id_of(material);
  const auto refuse = [&](const std::string& why) {
    return fail(ErrorCode::kInvalidArgument, "the material cannot be saved: " + why);
  };
  if (folder.empty()) {
    return fail(
        ErrorCode::kNotFound,
        "custom materials cannot be saved: neither XDG_DATA_HOME nor HOME is set to a folder");
  }
  if (const std::string wrong = material_error(material); !wrong.empty()) return refuse(wrong);
  if (const std::string taken = new_id_error(id); !taken.empty()) return refuse(taken);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return fail(ErrorCode::kIo, folder + ": cannot create: " + error.message());
  const MaterialLibrary there = library_of(folder);
  const MaterialEntry* old = find_own(there, id);
  if (old && old->material.index() != material.index()) {
    const std::string other(kind_of(old->material)), kind(kind_of(material));
    return refuse(old->path + " is a " + other + " with the id " + id + "; give the " + kind +
                  " another name");
  }
  const std::string path = old ? old->path : folder + "/" + id + ".toml";
  if (!old && fs::exists(path, error)) {
    return refuse(path + " is another material or cannot be read");
  }
  if (Result<void> saved = save_file(path, write_material(material)); !saved) {
    return tl::unexpected(saved.error());
  }
  return path;
}

std::string material_path(const std::string& folder, const AnyMaterial& material) {
  const MaterialLibrary there = library_of(folder);
  const MaterialEntry* entry = find_own(there, id_of(material));
  return entry && entry->material.index() == material.index() ? entry->path : "";
}

Result<void> delete_material(const std::string& folder, const AnyMaterial& material) {
  const std::string path = material_path(folder, material);
  if (path.empty()) {
    return fail(ErrorCode::kNotFound, "there is no custom " + std::string(kind_of(material)) +
                                          " \"" + id_of(material) + "\" in " + folder);
  }
  std::error_code error;
  if (fs::remove(path, error)) return {};
  return fail(ErrorCode::kIo, path + ": cannot delete: " + error.message());
}

std::string new_id_error(std::string_view id) {
  const std::string name(id);
  if (!is_material_id(id)) return "\"" + name + "\" is not 1 to 64 of a-z, 0-9 and -";
  const char* kind = find_surface(id) ? "surface" : find_medium(id) ? "medium" : nullptr;
  if (!kind) return "";
  return name + " is the id of a " + kind + " that is built in; choose another, for example my-" +
         name;
}

}  // namespace felt
