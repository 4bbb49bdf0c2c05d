#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "felt/base/result.h"

namespace felt {

/// Tells when a library is unloaded.
enum class LibraryLife : std::uint8_t {
  kAsLongAsUsed,     ///< with its last user
  kAsLongAsProgram,  ///< never: for libraries with threads of their own, whose code must stay
                     ///< loaded
};

/// A library that is loaded at run time, because it may be absent: a device maker's. Its symbols
/// are invisible to other libraries and bound lazily. Used on the edit thread.
///
///   auto library = DynamicLibrary::open(names, LibraryLife::kAsLongAsProgram);
///   if (!library) return fail(library.error()...);
///   SymbolLoader symbols(*library);
///   symbols.require(api.begin_frame, "hdBeginFrame");
///   if (auto all = symbols.done(); !all) ...
class DynamicLibrary {
 public:
  /// Loads the first of `names` that can be loaded. Plain names ("libHD.so") are searched where the
  /// system keeps libraries; names with a slash are paths.
  ///
  /// Fails with kNotFound; the message has each name with the loader's text, because it names
  /// missing dependencies ("libncurses.so.5: cannot open shared object file ...").
  static Result<DynamicLibrary> open(std::span<const std::string> names, LibraryLife life);

  DynamicLibrary(DynamicLibrary&& other) noexcept
      : handle_(std::exchange(other.handle_, nullptr)), name_(std::move(other.name_)) {}
  DynamicLibrary& operator=(DynamicLibrary&& other) noexcept;
  DynamicLibrary(const DynamicLibrary&) = delete;
  DynamicLibrary& operator=(const DynamicLibrary&) = delete;
  ~DynamicLibrary() { close(); }

  /// Returns the name that was loaded.
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  /// Returns the file that was loaded; the name if the system does not say.
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

/// Looks up functions by name, each into a pointer of its type, and collects the missing ones, so
/// that the message names all of them.
class SymbolLoader {
 public:
  /// `library` must outlive this.
  explicit SymbolLoader(const DynamicLibrary& library) noexcept : library_(library) {}

  /// Looks up a required function; null and remembered as missing if it is absent.
  template <class Function>
  void require(Function*& function, const char* name) {
    if (!find(function, name)) missing_.emplace_back(name);
  }
  /// Looks up a function that older versions lack; null, and false, if it is absent.
  template <class Function>
  bool find(Function*& function, const char* name) noexcept {
    function = reinterpret_cast<Function*>(library_.symbol(name));
    return function != nullptr;
  }
  /// Fails with kUnsupported if required functions are missing; names the library's file and all of
  /// them.
  [[nodiscard]] Result<void> done() const;

 private:
  const DynamicLibrary& library_;
  std::vector<std::string> missing_;
};

}  // namespace felt
