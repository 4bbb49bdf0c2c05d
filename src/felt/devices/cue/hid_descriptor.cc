#include "felt/devices/cue/hid_descriptor.h"

#include <algorithm>
#include <array>
#include <string>

namespace felt {
namespace {

constexpr std::size_t kMaxDepth = 16;
constexpr std::size_t kMaxPushed = 8;
constexpr std::size_t kMaxUsages = 256;  // maximum number of usages before one main item
constexpr std::uint32_t kMaxCount = 4096;
constexpr std::uint32_t kMaxSize = 4096;

/// Global items keep their value from one main item to the next.
struct Globals {
  std::uint16_t page = 0;
  std::int32_t minimum = 0, maximum = 0, physical_minimum = 0, physical_maximum = 0;
  std::uint32_t maximum_unsigned = 0;
  int exponent = 0;
  std::uint32_t unit = 0, size = 0, count = 0;
  std::uint8_t report = 0;
};

struct Collection {
  std::uint32_t usage = 0;
  bool is_application = false;
};

class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  Result<HidDescriptor> read() {
    if (bytes_.size() > kMaxHidBytes) return wrong("it exceeds the maximum length of a descriptor");
    while (at_ < bytes_.size()) {
      if (Result<void> done = item(); !done) return tl::unexpected(done.error());
    }
    if (!collections_.empty()) return wrong("a collection does not end");
    return std::move(descriptor_);
  }

 private:
  [[nodiscard]] tl::unexpected<Error> wrong(const std::string& what) const {
    return fail(ErrorCode::kInvalidData,
                "HID report descriptor: " + what + ", at byte " + std::to_string(at_));
  }

  Result<void> item() {
    const std::uint8_t prefix = bytes_[at_];
    constexpr std::uint8_t kLong = 0xFE;
    if (prefix == kLong) return skip_long();
    const std::size_t size = (prefix & 3) == 3 ? 4 : prefix & 3;
    if (bytes_.size() - at_ <= size) return wrong("it ends within an item");
    std::uint32_t data = 0;
    for (std::size_t i = 0; i < size; ++i) data |= std::uint32_t{bytes_[at_ + 1 + i]} << (8 * i);
    Result<void> done;
    switch (prefix >> 2 & 3) {
      case 0:
        done = main_item(prefix >> 4, data);
        break;
      case 1:
        done = global_item(prefix >> 4, data, size);
        break;
      case 2:
        done = local_item(prefix >> 4, data, size);
        break;
      default:
        break;  // reserved
    }
    if (!done) return done;
    at_ += size + 1;
    return {};
  }

  Result<void> skip_long() {
    if (bytes_.size() - at_ < 3) return wrong("it ends within a long item");
    const std::size_t size = 3 + std::size_t{bytes_[at_ + 1]};
    if (bytes_.size() - at_ < size) return wrong("it ends within a long item");
    at_ += size;
    return {};
  }

  static std::int32_t with_sign(std::uint32_t data, std::size_t size) noexcept {
    if (size == 1) return static_cast<std::int8_t>(data);
    if (size == 2) return static_cast<std::int16_t>(data);
    return static_cast<std::int32_t>(data);
  }

  Result<void> global_item(int tag, std::uint32_t data, std::size_t size) {
    const std::int32_t number = with_sign(data, size);
    switch (tag) {
      case 0:
        globals_.page = static_cast<std::uint16_t>(data);
        return {};
      case 1:
        globals_.minimum = number;
        return {};
      case 2:
        globals_.maximum = number;
        globals_.maximum_unsigned = data;
        return {};
      case 3:
        globals_.physical_minimum = number;
        return {};
      case 4:
        // If the minimum is not negative, a value such as 0xFF in one byte means 255 and not -1.
        globals_.physical_maximum = number < 0 && globals_.physical_minimum >= 0 && size < 4
                                        ? static_cast<std::int32_t>(data)
                                        : number;
        return {};
      case 5:
        globals_.exponent = exponent_of(data, size);
        return {};
      case 6:
        globals_.unit = data;
        return {};
      case 7:
        if (data > kMaxSize) return wrong("a field is too wide");
        globals_.size = data;
        return {};
      case 8:
        if (data == 0 || data > 0xFF) return wrong("the number of a report is invalid");
        globals_.report = static_cast<std::uint8_t>(data);
        descriptor_.is_numbered = true;
        return {};
      case 9:
        if (data > kMaxCount) return wrong("too many fields");
        globals_.count = data;
        return {};
      case 10:
        if (pushed_.size() == kMaxPushed) return wrong("too many nested pushes");
        pushed_.push_back(globals_);
        return {};
      case 11:
        if (pushed_.empty()) return wrong("a pop without a push");
        globals_ = pushed_.back();
        pushed_.pop_back();
        return {};
      default:
        return {};
    }
  }

  /// Returns the exponent: four signed bits in the standard, but many devices write a whole byte
  /// (0xFD).
  static int exponent_of(std::uint32_t data, std::size_t size) noexcept {
    const std::uint32_t low = data & 0xF;
    if (size > 1 || (data & 0xF0) == 0 || (data & 0xF0) == 0xF0) {
      return static_cast<int>(low) - (low > 7 ? 16 : 0);
    }
    return 0;
  }

  [[nodiscard]] std::uint32_t usage_of(std::uint32_t data, std::size_t size) const noexcept {
    return size == 4 ? data : hid_usage(globals_.page, static_cast<std::uint16_t>(data));
  }

  Result<void> local_item(int tag, std::uint32_t data, std::size_t size) {
    if (tag == 0) {
      if (usages_.size() == kMaxUsages) return wrong("too many usages");
      usages_.push_back(usage_of(data, size));
    } else if (tag == 1) {
      first_ = usage_of(data, size);
    } else if (tag == 2) {
      const std::uint32_t last = usage_of(data, size);
      if (last < first_ || last - first_ >= kMaxUsages - usages_.size()) {
        return wrong("an invalid range of usages");
      }
      // The loop counts the usages instead of comparing with `last`, because `last` may be the
      // largest number of its type.
      const std::uint32_t count = last - first_ + 1;
      for (std::uint32_t i = 0; i < count; ++i) usages_.push_back(first_ + i);
    }
    return {};
  }

  Result<void> main_item(int tag, std::uint32_t data) {
    Result<void> done;
    switch (tag) {
      case 8:
        done = add(HidReportKind::kInput, data);
        break;
      case 9:
        done = add(HidReportKind::kOutput, data);
        break;
      case 11:
        done = add(HidReportKind::kFeature, data);
        break;
      case 10:
        done = open(data);
        break;
      case 12:
        done = close();
        break;
      default:
        break;
    }
    usages_.clear();
    first_ = 0;
    return done;
  }

  Result<void> open(std::uint32_t type) {
    if (collections_.size() == kMaxDepth) return wrong("collections are too deep");
    if (collections_.empty()) ++group_;
    constexpr std::uint32_t kApplication = 1;
    collections_.push_back({usages_.empty() ? 0 : usages_.front(), type == kApplication});
    return {};
  }

  Result<void> close() {
    if (collections_.empty()) return wrong("a collection ends that has not started");
    collections_.pop_back();
    return {};
  }

  /// Returns the maximum as the kernel interprets it: if the minimum is not negative, a negative
  /// maximum is read as an unsigned number. If the result is below the minimum, the range is
  /// invalid.
  [[nodiscard]] std::int32_t maximum() const noexcept {
    if (globals_.maximum >= globals_.minimum || globals_.minimum < 0) return globals_.maximum;
    return static_cast<std::int32_t>(std::min<std::uint32_t>(globals_.maximum_unsigned, INT32_MAX));
  }

  Result<void> add(HidReportKind kind, std::uint32_t flags) {
    std::uint32_t& used = descriptor_.report_bits[static_cast<std::size_t>(kind)][globals_.report];
    const std::size_t all = std::size_t{globals_.size} * globals_.count;
    if (all > kMaxReportBits || used + all > kMaxReportBits) return wrong("a report is too long");
    const bool is_kept = globals_.size >= 1 && globals_.size <= 32 && !usages_.empty();
    if (is_kept && maximum() < globals_.minimum) return wrong("an invalid range of values");
    for (std::size_t i = 0; is_kept && i < globals_.count; ++i) {
      if (descriptor_.fields.size() == kMaxHidFields) break;
      HidField& field = descriptor_.fields.emplace_back();
      field.kind = kind;
      field.report = globals_.report;
      field.usage = usages_[std::min(i, usages_.size() - 1)];
      for (const Collection& collection : collections_) {
        if (collection.usage != 0) field.collection = collection.usage;
      }
      field.application = collections_.empty() ? 0 : collections_.front().usage;
      field.group = group_;
      field.is_constant = (flags & 1) != 0;
      field.is_array = (flags & 2) == 0;
      field.bit = used + i * globals_.size;
      field.bits = globals_.size;
      field.minimum = globals_.minimum;
      field.maximum = maximum();
      field.physical_minimum = globals_.physical_minimum;
      field.physical_maximum = globals_.physical_maximum;
      field.exponent = globals_.exponent;
      field.unit = globals_.unit;
    }
    used += static_cast<std::uint32_t>(all);
    return {};
  }

  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  Globals globals_;
  std::vector<Globals> pushed_;
  std::vector<std::uint32_t> usages_;
  std::uint32_t first_ = 0;
  std::vector<Collection> collections_;
  std::uint32_t group_ = 0;
  HidDescriptor descriptor_;
};

}  // namespace

std::size_t HidDescriptor::report_bytes(HidReportKind kind, std::uint8_t report) const noexcept {
  const std::size_t bits = report_bits[static_cast<std::size_t>(kind)][report];
  return bits == 0 ? 0 : 1 + (bits + 7) / 8;
}

Result<HidDescriptor> read_hid_descriptor(std::span<const std::uint8_t> bytes) {
  return Reader(bytes).read();
}

std::int64_t hid_value(std::span<const std::uint8_t> report, const HidField& field) noexcept {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < field.bits; ++i) {
    const std::size_t bit = field.bit + i, byte = 1 + bit / 8;
    if (byte >= report.size()) return 0;
    value |= std::uint64_t{report[byte] >> (bit % 8) & 1U} << i;
  }
  const bool is_negative = field.minimum < 0 && (value >> (field.bits - 1) & 1) != 0;
  return static_cast<std::int64_t>(value) -
         (is_negative ? std::int64_t{1} << field.bits : std::int64_t{0});
}

void set_hid_value(std::span<std::uint8_t> report, const HidField& field,
                   std::int64_t value) noexcept {
  // Limits the value to the field's range and to the range of its bits, because a device may
  // declare a larger range than the bits can hold.
  const bool has_sign = field.minimum < 0;
  const std::int64_t largest = (std::int64_t{1} << (field.bits - (has_sign ? 1 : 0))) - 1;
  const std::int64_t smallest = has_sign ? -largest - 1 : 0;
  const std::int64_t low = std::clamp<std::int64_t>(field.minimum, smallest, largest);
  const std::int64_t high = std::clamp<std::int64_t>(field.maximum, low, largest);
  const auto bits = static_cast<std::uint64_t>(std::clamp(value, low, high));
  for (std::size_t i = 0; i < field.bits; ++i) {
    const std::size_t bit = field.bit + i, byte = 1 + bit / 8;
    if (byte >= report.size()) return;
    const auto mask = static_cast<std::uint8_t>(1U << (bit % 8));
    report[byte] = static_cast<std::uint8_t>((bits >> i & 1) != 0 ? report[byte] | mask
                                                                  : report[byte] & ~mask);
  }
}

}  // namespace felt
