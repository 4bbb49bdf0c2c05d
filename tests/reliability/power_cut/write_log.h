#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace felt::power_cut {

/// How the power goes. The disk has a cache that only a flush empties, and keeps sectors of 512
/// bytes whole.
enum class CutKind : std::uint8_t {
  kPrefix,  ///< everything that was written before has reached the disk
  kDrop,    ///< of what was written since the last flush, each write with even chance
  kTear,    ///< likewise each sector
};
inline constexpr int kCutKinds = 3;
const char* cut_name(CutKind kind) noexcept;

/// Where in a log the power goes.
struct Cut {
  std::uint64_t at = 0;  ///< so many records have happened
  CutKind kind = CutKind::kPrefix;
  std::uint64_t seed = 0;  ///< decides what is dropped
};

/// Everything that was written to a disk, in order, and every flush. Lies in memory that processes
/// share, so that the workload knows how far the disk is when it says "Saved". One writer.
class WriteLog {
 public:
  WriteLog();
  ~WriteLog();
  WriteLog(const WriteLog&) = delete;
  WriteLog& operator=(const WriteLog&) = delete;

  /// False: the log is full.
  bool add_write(std::uint64_t offset, const char* bytes, std::size_t size);
  bool add_flush();
  /// Records so far. Any process.
  [[nodiscard]] std::uint64_t count() const noexcept;
  [[nodiscard]] std::uint64_t bytes() const noexcept;
  void clear() noexcept;

  /// Makes the file `image` what the disk holds after the cut, which had `base` on it before.
  /// Empty: done; else why not.
  std::string replay(const std::vector<char>& base, const std::string& image, const Cut& cut) const;

 private:
  struct Record {
    std::uint64_t offset;
    std::uint32_t size;  ///< 0: a flush
    std::uint32_t unused;
    std::uint64_t at;  ///< of the bytes in data_
  };
  struct Header {
    std::atomic<std::uint64_t> records, bytes;
  };

  bool add(const Record& record);

  Header* header_ = nullptr;
  Record* records_ = nullptr;
  char* data_ = nullptr;
};

}  // namespace felt::power_cut
