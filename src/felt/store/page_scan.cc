#include "felt/store/page_scan.h"

#include <algorithm>
#include <bit>
#include <optional>
#include <utility>

#include "felt/store/felt_schema.h"
#include "felt/store/stroke_blob.h"

namespace felt {
namespace {

constexpr std::size_t kDatabaseHeaderBytes = 100, kPageSizeAt = 16, kReservedAt = 20;
constexpr std::size_t kUsualPage = 4096;  // the page size of all our files
constexpr std::uint8_t kLeafOfRows = 0x0d;
constexpr std::size_t kLeafHeaderBytes = 8;
constexpr std::size_t kMinBudget = std::size_t{1} << 20;

/// Reads big-endian numbers. Bytes beyond the end read as 0.
class Bytes {
 public:
  explicit Bytes(std::string_view bytes) noexcept : bytes_(bytes) {}

  [[nodiscard]] std::uint8_t at(std::size_t i) const noexcept {
    return i < bytes_.size() ? static_cast<std::uint8_t>(bytes_[i]) : 0;
  }
  [[nodiscard]] std::uint64_t number(std::size_t at_byte, std::size_t size) const noexcept {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i) value = value << 8 | at(at_byte + i);
    return value;
  }
  /// Reads an SQLite varint of 1 to 9 bytes and advances `i`. Returns nullopt if it is cut off.
  [[nodiscard]] std::optional<std::uint64_t> varint(std::size_t& i) const noexcept {
    std::uint64_t value = 0;
    for (std::size_t k = 0; k < 9 && i < bytes_.size(); ++k) {
      const std::uint8_t byte = at(i++);
      if (k == 8) return value << 8 | byte;
      value = value << 7 | (byte & 0x7f);
      if ((byte & 0x80) == 0) return value;
    }
    return std::nullopt;
  }
  [[nodiscard]] std::size_t size() const noexcept { return bytes_.size(); }

 private:
  std::string_view bytes_;
};

std::uint64_t value_size(std::uint64_t type) noexcept {
  constexpr std::uint64_t kSizes[] = {0, 1, 2, 3, 4, 6, 8, 8, 0, 0, 0, 0};
  return type < 12 ? kSizes[type] : (type - 12) / 2;
}

ScannedRow::Value value_of(std::uint64_t type, std::string_view record, std::size_t at) {
  const auto size = static_cast<std::size_t>(value_size(type));
  if (type == 0 || type == 10 || type == 11) return {};
  if (type == 8 || type == 9) return static_cast<std::int64_t>(type - 8);
  if (type >= 12) {
    return ScannedRow::Bytes{std::string(record.substr(at, size)), type % 2 == 1};
  }
  const std::uint64_t bits = Bytes(record).number(at, size);
  if (type == 7) return std::bit_cast<double>(bits);
  const auto shift = static_cast<unsigned>(64 - 8 * size);  // extends the sign
  return static_cast<std::int64_t>(bits << shift) >> shift;
}

bool read_record(std::string_view record, std::vector<ScannedRow::Value>& values) {
  const Bytes bytes(record);
  std::size_t at = 0;
  const auto header = bytes.varint(at);
  if (!header || *header > record.size()) return false;
  auto body = static_cast<std::size_t>(*header);
  while (at < *header) {
    const auto type = bytes.varint(at);
    if (!type || at > *header || values.size() == kMaxColumns) return false;
    const std::uint64_t size = value_size(*type);
    if (size > record.size() - body) return false;
    values.push_back(value_of(*type, record, body));
    body += static_cast<std::size_t>(size);
  }
  return body == record.size();
}

/// Reads the leaf pages of tables: a header with the number of cells, their offsets in the page,
/// and the cells. A cell has the size of its record, the row id and the record: a header with the
/// types of the columns, then their values. A record that is too long for the page continues on a
/// chain of overflow pages; the size of its first part follows from the page size and the record's
/// size.
class Scan {
 public:
  explicit Scan(std::string_view bytes) : file_(bytes) {
    const Bytes header(bytes);
    const std::uint64_t page = header.number(kPageSizeAt, 2);
    page_ = page == 1 ? 65'536 : static_cast<std::size_t>(page);
    const bool is_size = page_ >= 512 && std::has_single_bit(page_);
    if (!is_size) page_ = kUsualPage;
    const std::size_t reserved = is_size ? header.at(kReservedAt) : 0;
    usable_ = page_ - reserved >= 480 ? page_ - reserved : page_;
    budget_ = kMinBudget + 2 * bytes.size();
  }

  void rows(const std::function<void(ScannedRow)>& report) {
    for (std::size_t begin = 0; begin < file_.size() && budget_ > 0; begin += page_) {
      const std::string_view page = file_.substr(begin, page_);
      leaf(page, begin == 0 ? kDatabaseHeaderBytes : 0, report);
    }
  }

 private:
  void leaf(std::string_view page, std::size_t header,
            const std::function<void(ScannedRow)>& report) {
    const Bytes bytes(page);
    if (bytes.at(header) != kLeafOfRows) return;
    const auto largest = (page.size() - std::min(page.size(), header + kLeafHeaderBytes)) / 2;
    const auto cells = std::min<std::size_t>(bytes.number(header + 3, 2), largest);
    for (std::size_t i = 0; i < cells && budget_ > 0; ++i) {
      const auto at = static_cast<std::size_t>(bytes.number(header + kLeafHeaderBytes + 2 * i, 2));
      ScannedRow row;
      if (cell(page, at, row)) report(std::move(row));
    }
  }

  bool cell(std::string_view page, std::size_t at, ScannedRow& row) {
    const Bytes bytes(page);
    const auto size = bytes.varint(at);
    const auto id = bytes.varint(at);
    if (!size || !id || *size == 0 || *size > kMaxStrokeBlobBytes + kMaxColumns * 10) return false;
    row.id = static_cast<std::int64_t>(*id);
    const auto total = static_cast<std::size_t>(*size);
    const std::size_t largest_here = usable_ - 35;
    if (total <= largest_here) {
      if (at + total > page.size()) return false;
      spend(total);
      return read_record(page.substr(at, total), row.values);
    }
    const std::size_t smallest = (usable_ - 12) * 32 / 255 - 23;
    const std::size_t wished = smallest + (total - smallest) % (usable_ - 4);
    const std::size_t here = wished <= largest_here ? wished : smallest;
    if (at + here + 4 > page.size() || total > file_.size()) return false;
    std::string record(page.substr(at, here));
    const bool is_there = overflow(bytes.number(at + here, 4), total, record);
    spend(record.size());
    return is_there && read_record(record, row.values);
  }

  /// Counts what was really read, because a damaged row may claim a size that would use up the
  /// budget and end the scan for all other rows.
  void spend(std::size_t read) noexcept { budget_ -= std::min(budget_, read); }

  /// Appends the rest of a row from its overflow pages. Their number is bounded by the row's size.
  bool overflow(std::uint64_t next, std::size_t total, std::string& record) const {
    while (record.size() < total) {
      if (next < 2 || next > file_.size() / page_) return false;
      const std::string_view page = file_.substr(static_cast<std::size_t>(next - 1) * page_, page_);
      record += page.substr(4, std::min(usable_ - 4, total - record.size()));
      next = Bytes(page).number(0, 4);
    }
    return true;
  }

  std::string_view file_;
  std::size_t page_ = kUsualPage, usable_ = kUsualPage;
  std::size_t budget_ = 0;  // bytes of rows that may still be read, because cells may repeat
};

}  // namespace

void scan_rows(std::string_view bytes, const std::function<void(ScannedRow)>& report) {
  Scan(bytes).rows(report);
}

}  // namespace felt
