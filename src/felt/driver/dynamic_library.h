#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "felt/base/result.h"

namespace felt {

/// What becomes of a library when its `DynamicLibrary` goes.
enum class LibraryLife : std::uint8_t {
  kAsLongAsUsed,     ///< it is unloaded with its last user
  kAsLongAsProgram,  ///< never: for libraries with threads of their own, whose code must stay
};

/// A library that is loaded while the program runs: a maker's, which may be absent. Its names are
/// not shown to other libraries, and what it needs is bound when it is needed. Edit thread.
///
///   auto library = DynamicLibrary::open(names, LibraryLife::kAsLongAsProgram);
///   if (!library) return fail(library.error()...);
///   SymbolLoader symbols(*library);
///   symbols.require(api.begin_frame, "hdBeginFrame");
///   if (auto all = symbols.done(); !all) ...
class DynamicLibrary {
 public:
  /// Loads the first of `names` that there is: plain names ("libHD.so") are looked for where the
  /// system keeps libraries, names with a slash are paths.
  ///
  /// Error: kNotFound; each name with the loader's own words, since these name what is missing
  /// behind it ("libncurses.so.5: cannot open shared object file ...").
  static Result<DynamicLibrary> open(std::span<const std::string> names, LibraryLife life);

  DynamicLibrary(DynamicLibrary&& other) noexcept
      : handle_(std::exchange(other.handle_, nullptr)), name_(std::move(other.name_)) {}
  DynamicLibrary& operator=(DynamicLibrary&& other) noexcept;
  DynamicLibrary(const DynamicLibrary&) = delete;
  DynamicLibrary& operator=(const DynamicLibrary&) = delete;
  ~DynamicLibrary() { close(); }

  /// The one of the names that was found.
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  /// The file that it came from; its name where the system does not say.
  [[nodiscard]] std::string path() const;
  /// The address of a function, or null.
  [[nodiscard]] void* symbol(const char* name) const noexcept;

 private:
  DynamicLibrary(void* handle, std::string name) noexcept
      : handle_(handle), name_(std::move(name)) {}
  void close() noexcept;

  void* handle_;
  std::string name_;
};

/// Looks functions up by name, each into a pointer of its type, and collects what is missing, so
/// that a person hears of all of it at once.
class SymbolLoader {
 public:
  /// `library` must outlive this.
  explicit SymbolLoader(const DynamicLibrary& library) noexcept : library_(library) {}

  /// A function that must be there; null and noted where it is not.
  template <class Function>
  void require(Function*& function, const char* name) {
    if (!find(function, name)) missing_.emplace_back(name);
  }
  /// One that older versions lack: false, and null, where it is not.
  template <class Function>
  bool find(Function*& function, const char* name) noexcept {
    function = reinterpret_cast<Function*>(library_.symbol(name));
    return function != nullptr;
  }
  /// Error: kUnsupported; names the library's file and all functions that it lacks.
  [[nodiscard]] Result<void> done() const;

 private:
  const DynamicLibrary& library_;
  std::vector<std::string> missing_;
};

}  // namespace felt
