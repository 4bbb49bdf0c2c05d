#include "felt/driver/dynamic_library.h"

#include <dlfcn.h>
#include <link.h>

namespace felt {

Result<DynamicLibrary> DynamicLibrary::open(std::span<const std::string> names, LibraryLife life) {
  const int mode =
      RTLD_LAZY | RTLD_LOCAL | (life == LibraryLife::kAsLongAsProgram ? RTLD_NODELETE : 0);
  std::string tries;
  for (const std::string& name : names) {
    // dlopen() of an empty name would return this program itself.
    void* handle = name.empty() ? nullptr : dlopen(name.c_str(), mode);
    if (handle != nullptr) return DynamicLibrary(handle, name);
    const char* words = name.empty() ? nullptr : dlerror();
    tries += tries.empty() ? "" : "; ";
    tries += "\"" + name + "\": " + (words != nullptr ? words : "no name");
  }
  return fail(ErrorCode::kNotFound,
              "no library could be loaded (" + (tries.empty() ? "no name was given" : tries) + ")");
}

DynamicLibrary& DynamicLibrary::operator=(DynamicLibrary&& other) noexcept {
  if (this == &other) return *this;
  close();
  handle_ = std::exchange(other.handle_, nullptr);
  name_ = std::move(other.name_);
  return *this;
}

void DynamicLibrary::close() noexcept {
  if (handle_ != nullptr) dlclose(handle_);
  handle_ = nullptr;
}

std::string DynamicLibrary::path() const {
  const link_map* map = nullptr;
  if (handle_ == nullptr || dlinfo(handle_, RTLD_DI_LINKMAP, &map) != 0) return name_;
  return map != nullptr && map->l_name != nullptr && *map->l_name != '\0' ? map->l_name : name_;
}

void* DynamicLibrary::symbol(const char* name) const noexcept {
  return handle_ != nullptr ? dlsym(handle_, name) : nullptr;
}

Result<void> SymbolLoader::done() const {
  if (missing_.empty()) return {};
  std::string names;
  for (const std::string& name : missing_) names += (names.empty() ? "" : ", ") + name;
  return fail(ErrorCode::kUnsupported,
              library_.path() + " is not the required library, or is too old: it lacks " + names);
}

}  // namespace felt
