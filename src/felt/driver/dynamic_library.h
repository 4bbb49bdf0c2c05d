#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "felt/base/result.h"

namespace felt {

/// How long a library stays loaded.
enum class LibraryLife : std::uint8_t {
  kAsLongAsUsed,     ///< until its last DynamicLibrary is destroyed
  kAsLongAsProgram,  ///< until the program ends, because threads of the library need its code
};

/// A library of a device maker. It is loaded at run time, because it may be absent. Other libraries
/// do not see its symbols (RTLD_LOCAL), and each function is resolved at its first call
/// (RTLD_LAZY). Used on the edit thread.
///
///   auto library = DynamicLibrary::open(names, LibraryLife::kAsLongAsProgram);
///   if (!library) return fail(library.error()...);
///   SymbolLoader symbols(*library);
///   symbols.require(api.begin_frame, "hdBeginFrame");
///   if (auto all = symbols.done(); !all) ...
class DynamicLibrary {
 public:
  /// Loads the first of `names` that can be loaded. Plain names ("libHD.so") are searched in the
  /// system's library folders; names with a slash are paths.
  ///
  /// Fails with kNotFound if none can be loaded. The message contains each name with the loader's
  /// text, which names missing dependencies ("libncurses.so.5: cannot open shared object file
  /// ...").
  static Result<DynamicLibrary> open(std::span<const std::string> names, LibraryLife life);

  DynamicLibrary(DynamicLibrary&& other) noexcept
      : handle_(std::exchange(other.handle_, nullptr)), name_(std::move(other.name_)) {}
  DynamicLibrary& operator=(DynamicLibrary&& other) noexcept;
  DynamicLibrary(const DynamicLibrary&) = delete;
  DynamicLibrary& operator=(const DynamicLibrary&) = delete;
  ~DynamicLibrary() { close(); }

  /// Returns the name that was loaded.
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  /// Returns the path of the loaded file, or the name if the system does not report the path.
  [[nodiscard]] std::string path() const;
  /// Returns the address of a function, or null.
  [[nodiscard]] void* symbol(const char* name) const noexcept;

 private:
  DynamicLibrary(void* handle, std::string name) noexcept
      : handle_(handle), name_(std::move(name)) {}
  void close() noexcept;

  void* handle_;
  std::string name_;
};

/// Looks up functions by name and stores each in a pointer of its type. Collects the missing ones,
/// so that the error message names all of them.
class SymbolLoader {
 public:
  /// `library` must outlive this.
  explicit SymbolLoader(const DynamicLibrary& library) noexcept : library_(library) {}

  /// Looks up a required function. If it is absent, sets the pointer to null and records the
  /// function as missing.
  template <class Function>
  void require(Function*& function, const char* name) {
    if (!find(function, name)) missing_.emplace_back(name);
  }
  /// Looks up a function that older versions do not have. If it is absent, sets the pointer to null
  /// and returns false.
  template <class Function>
  bool find(Function*& function, const char* name) noexcept {
    function = reinterpret_cast<Function*>(library_.symbol(name));
    return function != nullptr;
  }
  /// Fails with kUnsupported if required functions are missing. The message names the library's
  /// file and all missing functions.
  [[nodiscard]] Result<void> done() const;

 private:
  const DynamicLibrary& library_;
  std::vector<std::string> missing_;
};

}  // namespace felt
