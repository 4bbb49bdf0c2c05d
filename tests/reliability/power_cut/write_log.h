#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace felt::power_cut {

/// Model of a power cut. The disk has a cache that only a flush empties. It never writes a part of
/// a sector of 512 bytes.
enum class CutKind : std::uint8_t {
  kPrefix,  ///< every earlier write has reached the disk
  kDrop,    ///< each write since the last flush has reached the disk with probability 1/2
  kTear,    ///< the same as kDrop, but for each sector of the writes
};
inline constexpr int kCutKinds = 3;
const char* cut_name(CutKind kind) noexcept;

/// A moment in a log at which the power fails.
struct Cut {
  std::uint64_t at = 0;  ///< number of records before the power cut
  CutKind kind = CutKind::kPrefix;
  std::uint64_t seed = 0;  ///< random seed that selects the lost writes
};

/// All writes and flushes of a disk, in order. Lies in shared memory, so that the workload can note
/// the number of records when it reports "Saved". Only one process may write.
class WriteLog {
 public:
  WriteLog();
  ~WriteLog();
  WriteLog(const WriteLog&) = delete;
  WriteLog& operator=(const WriteLog&) = delete;

  /// Append a record. Return false if the log is full.
  bool add_write(std::uint64_t offset, const char* bytes, std::size_t size);
  bool add_flush();
  /// Returns the number of records. Safe to call from any process.
  [[nodiscard]] std::uint64_t count() const noexcept;
  [[nodiscard]] std::uint64_t bytes() const noexcept;
  void clear() noexcept;

  /// Writes to the file `image` the content of the disk after the power cut. `base` is the initial
  /// content of the disk. Returns "" or the error.
  std::string replay(const std::vector<char>& base, const std::string& image, const Cut& cut) const;

 private:
  struct Record {
    std::uint64_t offset;
    std::uint32_t size;  ///< 0 for a flush
    std::uint32_t unused;
    std::uint64_t at;  ///< position of the bytes in data_
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
