#include "felt/store/felt_file.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "felt/base/atomic_file.h"
#include "felt/base/read_file.h"
#include "felt/store/carried_file.h"
#include "felt/store/database.h"
#include "felt/store/felt_extras.h"
#include "felt/store/felt_schema.h"
#include "felt/store/felt_tables.h"
#include "felt/store/recording_tables.h"

namespace felt {
namespace {

constexpr std::string_view kMagic{"SQLite format 3\0", 16};
constexpr std::size_t kHeaderBytes = 100;
constexpr std::size_t kWriteVersionAt = 18, kReadVersionAt = 19;
constexpr const char* kDamaged = "is damaged or incomplete";
constexpr std::size_t kUserVersionAt = 60, kApplicationIdAt = 68;
/// The type of the first page's b-tree, and the two types of a table
/// (https://www.sqlite.org/fileformat2.html#b_tree_pages).
constexpr std::size_t kTypeOfPageAt = 100;
constexpr char kInnerTablePage = 5, kLeafTablePage = 13;
constexpr std::size_t kSizeOfPageAt = 16, kChangesAt = 24, kPagesAt = 28, kPagesValidForAt = 92;
/// A file that is this many times as long as its header says is not read.
constexpr std::uint64_t kMaxExcess = 2;

std::uint32_t big_endian(std::string_view bytes, std::size_t at) noexcept {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  }
  return value;
}

tl::unexpected<Error> too_large() {
  return fail(ErrorCode::kLimitExceeded,
              "is larger than " + std::to_string(kMaxFeltBytes) + " bytes");
}

/// Fails if a file is far longer than its header says
/// (https://www.sqlite.org/fileformat2.html#1.3), because SQLite would examine every page of it.
Result<void> check_length(std::string_view bytes, std::uint64_t length) {
  if (big_endian(bytes, kChangesAt) != big_endian(bytes, kPagesValidForAt)) return {};
  const std::uint32_t size = big_endian(bytes, kSizeOfPageAt) >> 16;
  const std::uint64_t page_bytes = size == 1 ? 65'536 : size;
  const std::uint64_t stated = page_bytes * big_endian(bytes, kPagesAt);
  if (stated == 0 || length / kMaxExcess <= stated) return {};
  return invalid_data(std::string(kDamaged) + ": it is " + std::to_string(length) +
                      " bytes long, but contains a drawing of " + std::to_string(stated));
}

/// Checks the first bytes of a file of this length before SQLite reads it.
Result<void> check_header(std::string_view bytes, std::uint64_t length) {
  if (length > kMaxFeltBytes) return too_large();
  if (bytes.empty()) return invalid_data("is empty");
  const std::size_t known = std::min(bytes.size(), kMagic.size());
  if (bytes.substr(0, known) != kMagic.substr(0, known)) {
    return invalid_data("is not a Feltline drawing");
  }
  if (bytes.size() < kHeaderBytes) return invalid_data("is incomplete: it ends within its header");
  if (big_endian(bytes, kApplicationIdAt) != kFeltApplicationId) {
    return invalid_data("is a database of another program, not a Feltline drawing");
  }
  const std::uint32_t version = big_endian(bytes, kUserVersionAt);
  if (version > kFeltVersion) {
    return fail(ErrorCode::kUnsupported, "was written by a newer Feltline (format " +
                                             std::to_string(version) + "; this version reads " +
                                             std::to_string(kFeltVersion) + ")");
  }
  if (version != kFeltVersion) return invalid_data("does not state its format version");
  if (bytes[kWriteVersionAt] != 1 || bytes[kReadVersionAt] != 1) {
    return invalid_data("was changed by another program, which did not close it");
  }
  if (bytes.size() > kTypeOfPageAt && bytes[kTypeOfPageAt] != kInnerTablePage &&
      bytes[kTypeOfPageAt] != kLeafTablePage) {
    return invalid_data(std::string(kDamaged) + ": its first page is not a table");
  }
  return check_length(bytes, length);
}

/// Parses a file. If the file has extras, they need the bytes: they keep `keep`, which owns the
/// same bytes, or a copy if `keep` is null.
Result<Drawing> parse(std::string_view bytes, std::shared_ptr<const std::string> keep,
                      std::vector<std::string>* notices = nullptr) {
  if (auto ok = check_header(bytes, bytes.size()); !ok) return tl::unexpected(ok.error());
  const Result<Database> database = Database::open(bytes);
  if (!database) return tl::unexpected(with_context(database.error(), kDamaged));
  const Result<FeltSchema> schema = read_schema(*database);
  if (!schema) return tl::unexpected(schema.error());
  if (auto ok = database->check_pages(); !ok) {
    return tl::unexpected(with_context(ok.error(), kDamaged));
  }
  Result<Drawing> drawing = read_tables(*database, *schema, notices);
  if (drawing && schema->has_extras()) {
    const auto extras = std::make_shared<FeltExtras>();
    extras->file = keep ? std::move(keep) : std::make_shared<const std::string>(bytes);
    drawing->extras = extras;
  }
  return drawing;
}

}  // namespace

Result<std::size_t> check_felt_head(std::string_view head, std::uint64_t size) {
  return check_header(head, size).map([] { return kMaxFeltBytes; });
}

Result<Drawing> parse_felt(std::string_view bytes, std::vector<std::string>* notices) {
  return parse(bytes, nullptr, notices);
}

Result<std::string> felt_bytes(const Drawing& drawing) {
  Result<Database> database = Database::create();
  if (!database) return tl::unexpected(database.error());
  const FeltExtras& extras = felt_extras(drawing);
  const Result<CarriedFile> carried = CarriedFile::open(extras);
  if (!carried) return tl::unexpected(carried.error());
  const std::string setup =
      "PRAGMA page_size=4096; PRAGMA application_id=" + std::to_string(kFeltApplicationId) +
      "; PRAGMA user_version=" + std::to_string(kFeltVersion) + "; BEGIN";
  auto done = database->run(setup.c_str())
                  .and_then([&] { return write_tables(*database, drawing, carried->schema()); })
                  .and_then([&] { return carried->copy_to(*database, drawing.document); })
                  .and_then([&] { return write_recordings(*database, extras, *carried); })
                  .and_then([&] { return database->run("COMMIT"); });
  if (!done) return tl::unexpected(done.error());
  Result<std::string> bytes = database->bytes();
  if (bytes && bytes->size() > kMaxFeltBytes) return too_large();
  return bytes;
}

Result<Drawing> read_felt(const std::string& path) {
  Result<std::string> bytes =
      path == "-" ? read_file(path, check_felt_head) : read_regular_file(path, check_felt_head);
  if (!bytes) return tl::unexpected(bytes.error());
  const auto shared = std::make_shared<const std::string>(*std::move(bytes));
  Result<Drawing> drawing = parse(*shared, shared);
  if (drawing) return drawing;
  return tl::unexpected(with_context(drawing.error(), path == "-" ? "stdin" : path));
}

Result<void> write_felt(const std::string& path, const Drawing& drawing) {
  const Result<std::string> bytes = felt_bytes(drawing);
  if (bytes) return save_file(path, *bytes);
  return tl::unexpected(with_context(bytes.error(), path));
}

}  // namespace felt
