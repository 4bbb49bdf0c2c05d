#include "tests/reliability/power_cut/write_log.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <random>
#include <stdexcept>

namespace felt::power_cut {
namespace {

constexpr std::size_t kMaxRecords = std::size_t{1} << 20;
constexpr std::size_t kMaxBytes = std::size_t{2} << 30;
constexpr std::size_t kSectorBytes = 512;
constexpr std::size_t kChunkBytes = std::size_t{1} << 16;

template <class T>
T* shared_memory(std::size_t count) {
  void* memory = ::mmap(nullptr, count * sizeof(T), PROT_READ | PROT_WRITE,
                        MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory == MAP_FAILED) throw std::runtime_error("no memory for the log");
  return static_cast<T*>(memory);
}

bool is_zero(const char* bytes, std::size_t size) noexcept {
  return size == 0 || (bytes[0] == 0 && std::memcmp(bytes, bytes + 1, size - 1) == 0);
}

bool put(int fd, const char* bytes, std::size_t size, std::uint64_t offset) noexcept {
  return ::pwrite(fd, bytes, size, static_cast<off_t>(offset)) == static_cast<ssize_t>(size);
}

/// Writes `base` to the file. Skips blocks of zeros, because a new file reads as zeros anyway.
bool put_base(int fd, const std::vector<char>& base) noexcept {
  for (std::size_t at = 0; at < base.size(); at += kChunkBytes) {
    const std::size_t size = std::min(kChunkBytes, base.size() - at);
    if (!is_zero(base.data() + at, size) && !put(fd, base.data() + at, size, at)) return false;
  }
  return true;
}

}  // namespace

const char* cut_name(CutKind kind) noexcept {
  return kind == CutKind::kPrefix ? "prefix" : kind == CutKind::kDrop ? "drop" : "tear";
}

WriteLog::WriteLog()
    : header_(shared_memory<Header>(1)),
      records_(shared_memory<Record>(kMaxRecords)),
      data_(shared_memory<char>(kMaxBytes)) {}

WriteLog::~WriteLog() {
  ::munmap(header_, sizeof(Header));
  ::munmap(records_, kMaxRecords * sizeof(Record));
  ::munmap(data_, kMaxBytes);
}

bool WriteLog::add(const Record& record) {
  const std::uint64_t count = header_->records;
  if (count >= kMaxRecords) return false;
  records_[count] = record;
  header_->records = count + 1;  // after the record, so that readers see complete records only
  return true;
}

bool WriteLog::add_write(std::uint64_t offset, const char* bytes, std::size_t size) {
  const std::uint64_t at = header_->bytes;
  if (size == 0) return true;
  if (at + size > kMaxBytes) return false;
  std::memcpy(data_ + at, bytes, size);
  header_->bytes = at + size;
  return add({offset, static_cast<std::uint32_t>(size), 0, at});
}

bool WriteLog::add_flush() {
  return add({0, 0, 0, 0});
}

std::uint64_t WriteLog::count() const noexcept {
  return header_->records;
}

std::uint64_t WriteLog::bytes() const noexcept {
  return header_->bytes;
}

void WriteLog::clear() noexcept {
  header_->records = 0;
  header_->bytes = 0;
  ::madvise(data_, kMaxBytes, MADV_REMOVE);
}

std::string WriteLog::replay(const std::vector<char>& base, const std::string& image,
                             const Cut& cut) const {
  const int fd = ::open(image.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  if (fd < 0) return image + ": " + std::strerror(errno);
  bool ok = ::ftruncate(fd, static_cast<off_t>(base.size())) == 0 && put_base(fd, base);
  std::uint64_t flushed = std::min(cut.at, count());
  while (flushed > 0 && records_[flushed - 1].size != 0) --flushed;
  std::mt19937_64 random(cut.seed);
  for (std::uint64_t i = 0; ok && i < std::min(cut.at, count()); ++i) {
    const Record& record = records_[i];
    const char* bytes = data_ + record.at;
    if (record.size == 0) continue;
    if (i < flushed || cut.kind == CutKind::kPrefix) {
      ok = put(fd, bytes, record.size, record.offset);
    } else if (cut.kind == CutKind::kDrop) {
      if (random() % 2 == 0) ok = put(fd, bytes, record.size, record.offset);
    } else {
      for (std::size_t at = 0; ok && at < record.size; at += kSectorBytes) {
        const std::size_t size = std::min<std::size_t>(kSectorBytes, record.size - at);
        if (random() % 2 == 0) ok = put(fd, bytes + at, size, record.offset + at);
      }
    }
  }
  if (!ok) {
    const std::string reason = std::strerror(errno);
    ::close(fd);
    return image + ": " + reason;
  }
  ::close(fd);
  return "";
}

}  // namespace felt::power_cut
