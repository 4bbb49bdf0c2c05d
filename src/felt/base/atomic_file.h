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
///      file system can do that (else hidden), so that a killed process leaves nothing behind;
///   2. `write` any number of times; `overwrite` mends what was written;
///   3. `commit` makes it durable and puts it in the place of `path`: flush, fsync, rename,
///      fsync of the folder.
/// Destroyed without `commit`, it leaves nothing behind and `path` as it was.
///
/// A symbolic link is followed. An existing file keeps its permissions and extended attributes, and
/// its owner where the system allows it; one that may not be written is not replaced. What is not a
/// regular file (a pipe, /dev/stdout) cannot be replaced; it gets the bytes at `commit`, and so
/// does stdout, which is named "-". Every error names the file and the reason. An fsync that fails
/// is not tried again, for the system may have dropped the bytes: another call makes another file.
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
  /// The same with more care, for what a person made and has nowhere else (save_file). `bytes`: all
  /// that was written.
  Result<void> commit_verified(std::string_view bytes);

 private:
  AtomicFile() = default;
  Result<void> open_beside_target(unsigned permissions);
  Result<void> open_spool();
  Result<void> take_after_target();
  Result<void> flush();
  Result<void> commit(const std::string_view* expected);
  Result<void> copy_to_target();
  Result<void> replace_target(const std::string_view* expected);
  Result<void> put_in_place();
  Result<void> check_in_place(std::string_view expected);
  void discard() noexcept;
  tl::unexpected<Error> error(const char* doing) const;

  std::string shown_name_;  ///< for messages
  std::string target_;      ///< links resolved; empty for stdout
  std::string temporary_;   ///< name of the file in work; empty while it has none
  std::string previous_;    ///< another name of the old file, until the new one is verified
  bool is_spool_ = false;   ///< to be copied at `commit`, not renamed
  std::string buffer_;
  int fd_ = -1;
  int old_fd_ = -1;  ///< the file that is there; locked, so that nobody takes it for litter
};

/// Writes a whole file at once, or bytes to stdout for "-".
Result<void> write_file(const std::string& path, std::string_view bytes);

/// Writes a document. What write_file() does, and: the new file is opened again and compared with
/// `bytes` before the rename and after it, from the disk where the system can; until then the file
/// that was there keeps a second, hidden name, and it comes back where the new one is not what was
/// written; then what saves of killed processes left is removed. No error means: `bytes` are on the
/// disk under this name.
Result<void> save_file(const std::string& path, std::string_view bytes);

}  // namespace felt
