#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "felt/base/result.h"

namespace felt {

/// A folder that gets its name when it is complete. Until then it is a hidden folder beside it,
/// ".NAME.PROCESS.export", which is locked. Without commit(), nothing is left behind; if the
/// process is killed, the next export to the same name removes the hidden folder. Internal.
class ExportFolder {
 public:
  /// Creates the hidden folder. Fails if `out` exists and is not an empty folder, or if the folder
  /// cannot be created; the message names it and the reason.
  static Result<ExportFolder> create(const std::string& out);
  ExportFolder(ExportFolder&& other) noexcept;
  ExportFolder& operator=(ExportFolder&&) = delete;
  ~ExportFolder();

  /// Writes a file and the folders above it. `path` is relative to the folder.
  [[nodiscard]] Result<void> write(const std::string& path, std::string_view bytes) const;
  /// Gives the folder its name. Replaces an empty folder.
  Result<void> commit();

 private:
  ExportFolder(std::filesystem::path target, std::filesystem::path hidden, int lock)
      : target_(std::move(target)), hidden_(std::move(hidden)), lock_(lock) {}

  std::filesystem::path target_, hidden_;
  int lock_ = -1;  ///< the open hidden folder
};

}  // namespace felt
