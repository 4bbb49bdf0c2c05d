#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "felt/base/result.h"

namespace felt {

/// A file that is written completely or not at all.
///
/// Life cycle:
///   1. `create(path)` opens a temporary file in the folder of `path`. The file has no name if the
///      file system supports that, so that a killed process leaves nothing behind; otherwise it
///      has a hidden name.
///   2. `write` appends, any number of times; `overwrite` corrects bytes already written.
///   3. `commit` makes the file durable and replaces `path`: flush, fsync, rename, fsync of the
///      folder.
/// If the object is destroyed without `commit`, nothing is left behind and `path` is unchanged.
///
/// Symbolic links are followed. An existing file keeps its permissions and extended attributes, and
/// its owner if the system allows it; if it is read-only, it is not replaced. If `path` is not a
/// regular file (a pipe or /dev/stdout, for example), it cannot be replaced, so `commit` copies the
/// bytes into it. Stdout, named "-", is handled in the same way. Every error names the file and the
/// reason. A failed fsync is not retried, because the system may have dropped the bytes. In that
/// case, start again with a new AtomicFile.
class AtomicFile {
 public:
  /// Opens the temporary file. Fails if `path` is empty, is a folder, or may not be written. Fails
  /// with kInvalidArgument if `path` is a file that this process has read (input_files.h); so does
  /// commit() if it was read since.
  static Result<AtomicFile> create(const std::string& path);
  /// Does the same for a file that the program itself keeps, such as the session of a study: the
  /// new content may replace the content that was read.
  static Result<AtomicFile> create_for_save(const std::string& path);

  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&& other) noexcept;
  ~AtomicFile();

  /// Appends bytes; small pieces are buffered.
  Result<void> write(std::string_view bytes);
  /// Replaces bytes written before, for example a header once its values are known.
  /// Requires offset + bytes.size() <= bytes written so far.
  Result<void> overwrite(std::uint64_t offset, std::string_view bytes);
  /// Returns the descriptor of the temporary file, for a child process that writes the file instead
  /// of write() and overwrite(). It is closed by the destructor and is not inherited by default.
  [[nodiscard]] int descriptor() const noexcept { return fd_; }
  /// Completes the file. Call once; nothing may be written afterwards.
  Result<void> commit();
  /// Completes the file like commit(), and verifies it as described for save_file(). Used for
  /// drawings, because no other copy of a drawing exists. Requires `bytes` to be everything that
  /// was written.
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
  [[nodiscard]] Result<void> check_not_read() const;
  Result<void> put_in_place();
  Result<void> check_in_place(std::string_view expected);
  void discard() noexcept;
  tl::unexpected<Error> error(const char* doing) const;

  std::string shown_name_;     ///< for messages
  std::string target_;         ///< links resolved; empty for stdout
  std::string temporary_;      ///< name of the temporary file; empty if it has no name
  std::string previous_;       ///< another name of the old file, until the new one is verified
  bool keeps_inputs_ = false;  ///< never replaces a file of input_files.h
  bool is_spool_ = false;      ///< `commit` copies the file instead of renaming it
  std::string buffer_;
  int fd_ = -1;
  int old_fd_ = -1;  ///< the existing file; locked, so that no process removes it as a leftover
};

/// Writes a complete file, or writes to stdout if the path is "-". Fails like AtomicFile::create().
Result<void> write_file(const std::string& path, std::string_view bytes);

/// Writes a complete file that the program itself keeps (create_for_save()), and verifies it.
/// Success means that `bytes` are on the disk under this name.
///  * The new file is reopened and compared with `bytes` before and after the rename. The
///    comparison reads from the disk, not from the page cache, if the system allows it.
///  * Until the second comparison has succeeded, the old file is kept under a hidden name. If the
///    second comparison finds a difference, the old file is restored.
///  * Afterwards, temporary files that killed processes left beside the new file are removed.
Result<void> save_file(const std::string& path, std::string_view bytes);

}  // namespace felt
