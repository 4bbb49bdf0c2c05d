#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "felt/base/result.h"

namespace felt {

/// A file that appears whole or not at all.
///
/// Life-cycle:
///   1. `create(path)` opens a temporary file in the folder of `path`, without a name where the
///   file
///      system can do that (else hidden), so that a killed process leaves nothing behind;
///   2. `write` any number of times; `overwrite` mends what was written;
///   3. `commit` makes it durable and puts it in the place of `path`: flush, fsync, rename,
///      fsync of the folder.
/// Destroyed without `commit`, it leaves nothing behind and `path` as it was.
///
/// A symbolic link is followed. An existing file keeps its permissions. What is not a regular
/// file (a pipe, /dev/stdout) cannot be replaced; it gets the bytes at `commit`, and so does
/// stdout, which is named "-". Every error names the file and the reason.
class AtomicFile {
 public:
  static Result<AtomicFile> create(const std::string& path);

  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&& other) noexcept;
  ~AtomicFile();

  /// Appends bytes; small pieces are gathered.
  Result<void> write(std::string_view bytes);
  /// Replaces bytes that were written before, for example a header once its values are known.
  /// Requires offset + bytes.size() <= bytes written so far.
  Result<void> overwrite(std::uint64_t offset, std::string_view bytes);
  /// Completes the file. Call once; nothing may be written afterwards.
  Result<void> commit();

 private:
  AtomicFile() = default;
  Result<void> open_beside_target();
  Result<void> open_spool();
  Result<void> flush();
  Result<void> copy_to_target();
  Result<void> replace_target();
  Result<void> give_name();
  void discard() noexcept;
  tl::unexpected<Error> error(const char* doing) const;

  std::string shown_name_;  ///< for messages
  std::string target_;      ///< links resolved; empty for stdout
  std::string temporary_;   ///< name of the file in work; empty while it has none
  bool is_spool_ = false;   ///< to be copied at `commit`, not renamed
  std::string buffer_;
  int fd_ = -1;
};

/// Writes a whole file at once, or bytes to stdout for "-".
Result<void> write_file(const std::string& path, std::string_view bytes);

}  // namespace felt
