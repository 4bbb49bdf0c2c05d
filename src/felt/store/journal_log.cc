#include "felt/store/journal_log.h"

#include "felt/store/byte_stream.h"
#include "felt/store/crc32c.h"

namespace felt {
namespace {

constexpr std::size_t kHeadBytes = 5, kTailBytes = 4;

}  // namespace

void append_log_record(std::string& out, std::uint8_t type, std::string_view bytes) {
  ByteWriter writer(out);
  writer.u32(static_cast<std::uint32_t>(bytes.size()));
  const std::size_t begin = out.size();
  writer.u8(type);
  out += bytes;
  writer.u32(crc32c(std::string_view(out).substr(begin)));
}

std::vector<LogRecord> read_log(std::string_view text) {
  std::vector<LogRecord> records;
  while (text.size() >= kHeadBytes + kTailBytes) {
    const std::size_t size = ByteReader(text).u32();
    if (size > text.size() - kHeadBytes - kTailBytes) break;
    const std::string_view covered = text.substr(4, 1 + size);
    if (ByteReader(text.substr(kHeadBytes + size)).u32() != crc32c(covered)) break;
    records.push_back({static_cast<std::uint8_t>(covered[0]), covered.substr(1)});
    text.remove_prefix(kHeadBytes + size + kTailBytes);
  }
  return records;
}

}  // namespace felt
