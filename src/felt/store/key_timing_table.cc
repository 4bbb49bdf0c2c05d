#include "felt/store/key_timing_table.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "felt/document/document.h"
#include "felt/store/byte_writer.h"
#include "felt/store/crc32c.h"
#include "felt/store/layer_rows.h"

namespace felt {
namespace {

constexpr std::uint8_t kKeyTimingVersion = 1;
constexpr std::size_t kMinPairBytes = 2;

}  // namespace

Result<void> append_key_timing_blob(std::string& out, const KeyTiming& timing) {
  if (auto ok = check_key_timing(timing); !ok) return ok;
  ByteWriter writer(out);
  writer.u8(kKeyTimingVersion);
  writer.count(static_cast<std::uint64_t>(timing.between));
  writer.count(static_cast<std::uint64_t>(timing.hold));
  const EaseCurve& ease = timing.ease;
  for (const double number : {ease.x1, ease.y1, ease.x2, ease.y2}) writer.f64(number);
  writer.count(timing.pairs.size());
  for (const KeyPair& pair : timing.pairs) {
    writer.count(pair.from.value);
    writer.count(pair.to.value);
  }
  return {};
}

Result<KeyTimingPtr> read_key_timing_blob(std::string_view bytes) {
  ByteReader in(bytes);
  if (const std::uint8_t version = in.u8(); version != kKeyTimingVersion) {
    return fail(ErrorCode::kUnsupported,
                "has version " + std::to_string(version) + "; this program supports version 1");
  }
  const auto frames = [&in](std::uint64_t largest) {
    return static_cast<int>(std::min(in.count(), largest + 1));
  };
  KeyTiming timing;
  timing.between = frames(KeyTiming::kMaxBetween);
  timing.hold = frames(KeyTiming::kMaxHold);
  EaseCurve& ease = timing.ease;
  for (double* number : {&ease.x1, &ease.y1, &ease.x2, &ease.y2}) *number = in.f64();
  const std::uint64_t pairs = in.count();
  if (!in.has(pairs, kMinPairBytes)) return invalid_data("has fewer pairs than it states");
  for (std::uint64_t i = 0; i < pairs; ++i) {
    const StrokeId from{in.count()}, to{in.count()};
    timing.pairs.push_back({from, to});
  }
  if (!in.ok() || in.left() > 0) return invalid_data("does not have the length that it states");
  if (auto ok = check_key_timing(timing); !ok) return tl::unexpected(ok.error());
  return std::make_shared<const KeyTiming>(std::move(timing));
}

std::int64_t key_timing_checksum(std::int64_t layer, std::string_view bytes) {
  std::string number;
  ByteWriter(number).u64(static_cast<std::uint64_t>(layer));
  return static_cast<std::int64_t>(crc32c(bytes, crc32c(number)));
}

Result<void> write_key_timings(Database& database, const Document& document) {
  const std::span<const Layer> layers = document.layers();
  if (std::none_of(layers.begin(), layers.end(),
                   [](const Layer& l) { return l.timing != nullptr; }))
    return {};
  if (auto ok = database.run(std::string(kKeyTimingTable).c_str()); !ok) return ok;
  const auto row = database.prepare("INSERT INTO key_timing VALUES(?,?,?,?)");
  if (!row) return tl::unexpected(row.error());
  std::int64_t id = 0;
  std::string bytes;
  for (const Layer& layer : layers) {
    if (!layer.timing) continue;
    bytes.clear();
    if (auto ok = append_key_timing_blob(bytes, *layer.timing); !ok) return ok;
    const auto number = static_cast<std::int64_t>(layer.id.value);
    row->bind(1, ++id);
    row->bind_blob(2, bytes);
    row->bind(3, number);
    row->bind(4, key_timing_checksum(number, bytes));
    if (auto done = row->step(); !done) return tl::unexpected(done.error());
    row->reset();
  }
  return {};
}

Result<void> read_key_timings(const Database& database, Edit& edit) {
  std::string why;
  auto done = for_each_layer_row(
      database, "SELECT layer, timing, checksum FROM key_timing", "key_timing", edit,
      [&why](const Statement& row, LayerState& state) {
        if (!row.is_blob(1) || !row.is_integer(2)) return false;
        const std::string name = "the timing of layer " + std::to_string(row.integer(0));
        if (row.integer(2) != key_timing_checksum(row.integer(0), row.blob(1))) {
          why = name + " is damaged: its checksum does not match its bytes";
          return false;
        }
        Result<KeyTimingPtr> timing = read_key_timing_blob(row.blob(1));
        if (!timing) why = name + ": " + timing.error().message;
        if (timing) state.timing = *std::move(timing);
        return state.timing != nullptr;
      });
  if (done || why.empty()) return done;
  return invalid_data(why);
}

}  // namespace felt
