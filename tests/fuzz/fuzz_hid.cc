// Reads any bytes as data of a HID device: its report descriptor, and the answers of its haptic
// controller to feature requests. The first byte gives the length of the descriptor, in 16ths of
// the other bytes. The bytes after the descriptor are the answers, repeated as often as needed.
#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "felt/base/check.h"
#include "felt/devices/cue/haptic_reports.h"
#include "felt/devices/cue/hid_descriptor.h"

namespace {

using namespace felt;

class Answers final : public HidrawPort {
 public:
  explicit Answers(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  tl::expected<void, int> write(std::span<const std::uint8_t>) noexcept override { return {}; }
  tl::expected<std::size_t, int> read(std::span<std::uint8_t>, std::int64_t) noexcept override {
    return 0;
  }
  tl::expected<std::size_t, int> feature(std::span<std::uint8_t> room) noexcept override {
    FELT_CHECK(!room.empty());
    if (bytes_.empty()) return tl::unexpected(EPIPE);
    for (std::uint8_t& byte : room.subspan(1)) byte = bytes_[at_++ % bytes_.size()];
    return room.size();
  }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

void check_fields(const HidDescriptor& descriptor, std::span<const std::uint8_t> answers) {
  FELT_CHECK(descriptor.fields.size() <= kMaxHidFields);
  std::vector<std::uint8_t> report(64);
  for (const HidField& field : descriptor.fields) {
    FELT_CHECK(field.bits >= 1 && field.bits <= 32 && field.minimum <= field.maximum);
    FELT_CHECK(field.bit + field.bits <= kMaxReportBits);
    const std::size_t bytes = descriptor.report_bytes(field.kind, field.report);
    FELT_CHECK(1 + (field.bit + field.bits + 7) / 8 <= bytes && bytes <= 1 + kMaxReportBits / 8);
    for (std::size_t i = 0; i < report.size() && !answers.empty(); ++i) {
      report[i] = answers[i % answers.size()];
    }
    // Writes the value of a field back into it. set_hid_value() limits it to the field's range, so
    // the second time the value must be unchanged.
    set_hid_value(report, field, hid_value(report, field));
    const std::int64_t value = hid_value(report, field);
    set_hid_value(report, field, value);
    FELT_CHECK(hid_value(report, field) == value);
  }
}

void play_all(HapticReports& haptics, const HidDescriptor& descriptor) {
  for (int waveform = 0; waveform <= static_cast<int>(CueWaveform::kError); ++waveform) {
    for (const double intensity : {0.0, 0.5, 1.0}) {
      const Cue cue{static_cast<CueWaveform>(waveform), intensity};
      static_cast<void>(haptics.duration_ms(haptics.ordinal(cue.waveform)));
      const auto report = haptics.play(cue, 400);
      if (report.empty()) continue;
      FELT_CHECK(report.size() == descriptor.report_bytes(HidReportKind::kOutput, report[0]));
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 1) return 0;
  const std::span<const std::uint8_t> rest = std::span(data, size).subspan(1);
  const std::size_t length = std::min(rest.size(), rest.size() * (data[0] & 0x1FU) / 16);
  const auto answers = rest.subspan(length);
  const Result<HidDescriptor> descriptor = read_hid_descriptor(rest.first(length));
  if (!descriptor) {
    FELT_CHECK(!descriptor.error().message.empty());
    return 0;
  }
  check_fields(*descriptor, answers);
  auto haptics = HapticReports::find(*descriptor);
  if (!haptics) return 0;
  play_all(*haptics, *descriptor);
  Answers port(answers);
  static_cast<void>(haptics->ask(port));
  play_all(*haptics, *descriptor);
  return 0;
}
