#include "felt/store/recording_tables.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "felt/base/utf8.h"
#include "felt/io/events/event_reader.h"
#include "felt/io/events/event_writer.h"
#include "felt/store/byte_writer.h"
#include "felt/store/crc32c.h"
#include "felt/store/felt_extras.h"
#include "felt/store/felt_file.h"

namespace felt {
namespace {

constexpr std::size_t kMaxRecordings = 10'000;
constexpr std::size_t kMaxDeviceBytes = 4096;
/// Largest number in a recording, so that no sum of them overflows 64 bits.
constexpr std::int64_t kMaxNumber = std::int64_t{1} << 53;

/// Converts a force to its number in the tables: a whole multiple of kRecordedForceStepN.
std::int64_t steps_of(double n) noexcept {
  return std::llround(n / kRecordedForceStepN);
}

/// Computes the checksum of a recording piece by piece.
class Checksum {
 public:
  void sample(const RecordedSample& s) {
    ByteWriter out(bytes_);
    out.u64(static_cast<std::uint64_t>(s.time_ns));
    for (const double v : {s.pen.position.x, s.pen.position.y, s.pen.position.z}) out.f64(v);
    out.u8(static_cast<std::uint8_t>((s.pen.pressure ? 1 : 0) | (s.forces ? 2 : 0)));
    if (s.pen.pressure) out.f64(*s.pen.pressure);
    out.u32(s.pen.buttons);
    if (s.forces) {
      for (const Force& f : {s.forces->asked, s.forces->sent}) {
        for (const double v : {f.x, f.y, f.z}) out.u64(static_cast<std::uint64_t>(steps_of(v)));
      }
    }
    if (bytes_.size() > kPieceBytes) fold();
  }
  /// Adds a tilt. Tilts have a separate checksum: older programs do not know tilt, and for them the
  /// checksum of the other values must be the same as without it.
  void tilt(std::int64_t number, double tilt_deg) {
    ByteWriter out(bytes_);
    out.u64(static_cast<std::uint64_t>(number));
    out.f64(tilt_deg);
    if (bytes_.size() > kPieceBytes) fold();
  }
  void event(std::size_t before_sample, std::string_view line) {
    ByteWriter out(bytes_);
    out.u64(before_sample);
    out.text(line);
    fold();
  }
  std::int64_t value() {
    fold();
    return crc_;
  }

 private:
  static constexpr std::size_t kPieceBytes = std::size_t{1} << 16;
  void fold() {
    crc_ = crc32c(bytes_, crc_);
    bytes_.clear();
  }
  std::string bytes_;
  std::uint32_t crc_ = 0;
};

/// The checksums of a recording.
struct Checksums {
  Checksum all, tilts;

  void sample(const RecordedSample& s, std::int64_t number) {
    all.sample(s);
    if (s.pen.tilt_deg) tilts.tilt(number, *s.pen.tilt_deg);
  }
};

bool knows_tilt(const FeltRecording& recording) {
  return std::any_of(recording.samples.begin(), recording.samples.end(),
                     [](const RecordedSample& s) { return s.pen.tilt_deg.has_value(); });
}

/// A row of the table `recording`.
struct RecordingHead {
  std::string device;
  std::int64_t start_ns = 0, period_ns = 0, first_sample = 1, samples = 0, first_event = 1,
               events = 0, end_ns = 0, checksum = 0;
  std::optional<std::int64_t> tilt_checksum{};

  [[nodiscard]] std::int64_t due_ns(std::int64_t sample) const noexcept {
    return start_ns + sample * period_ns;
  }
};

/// Returns the kind of an event line: "tool" for {"t_ms":0,"event":"tool","id":"pencil"}.
std::string_view kind_of(std::string_view line) noexcept {
  constexpr std::string_view kKey = "\"event\":\"";
  const std::size_t at = line.find(kKey);
  if (at == std::string_view::npos) return {};
  line.remove_prefix(at + kKey.size());
  return line.substr(0, line.find('"'));
}

std::string line_of(const Event& event) {
  std::string line;
  append_event_line(line, event);
  if (!line.empty() && line.back() == '\n') line.pop_back();
  return line;
}

// --- Writing

Result<void> write_samples(const Database& to, const FeltRecording& recording,
                           const RecordingHead& head, bool with_tilt, Checksums& checksums) {
  const std::string tilt_name = with_tilt ? ", lean_deg" : "", tilt_mark = with_tilt ? ",?" : "";
  const auto row = to.prepare(("INSERT INTO recording_sample(id, late_ns, x_mm, y_mm, z_mm, "
                               "pressure, buttons, asked_x, asked_y, asked_z, cut_x, cut_y, cut_z" +
                               tilt_name + ") VALUES(?,?,?,?,?,?,?,?,?,?,?,?,?" + tilt_mark + ")")
                                  .c_str());
  if (!row) return tl::unexpected(row.error());
  std::int64_t n = 0;
  for (const RecordedSample& s : recording.samples) {
    checksums.sample(s, n);
    row->bind(1, head.first_sample + n);
    row->bind(2, s.time_ns - head.due_ns(n++));
    row->bind(3, s.pen.position.x);
    row->bind(4, s.pen.position.y);
    row->bind(5, s.pen.position.z);
    s.pen.pressure ? row->bind(6, *s.pen.pressure) : row->bind_null(6);
    row->bind(7, std::int64_t{s.pen.buttons});
    for (int i = 8; i <= (with_tilt ? 14 : 13); ++i) row->bind_null(i);
    if (s.pen.tilt_deg) row->bind(14, *s.pen.tilt_deg);
    if (s.forces) {
      const auto& [asked, sent] = *s.forces;
      const double a[] = {asked.x, asked.y, asked.z}, b[] = {sent.x, sent.y, sent.z};
      for (int i = 0; i < 3; ++i) {
        row->bind(8 + i, steps_of(a[i]));
        row->bind(11 + i, steps_of(a[i]) - steps_of(b[i]));
      }
    }
    if (auto done = row->step(); !done) return tl::unexpected(done.error());
    row->reset();
  }
  return {};
}

Result<void> write_events(const Database& to, const FeltRecording& recording,
                          const RecordingHead& head, Checksum& checksum) {
  const auto row = to.prepare(
      "INSERT INTO recording_event(id, before_sample, time_ns, kind, line) VALUES(?,?,?,?,?)");
  if (!row) return tl::unexpected(row.error());
  std::int64_t n = 0;
  for (const RecordedEvent& e : recording.events) {
    const std::string line = line_of(e.event);
    if (!is_utf8(line)) return invalid_data("an event of the recording is not text");
    checksum.event(e.before_sample, line);
    row->bind(1, head.first_event + n++);
    row->bind(2, head.first_sample + static_cast<std::int64_t>(e.before_sample));
    row->bind(3, e.event.time_ns);
    row->bind_text(4, kind_of(line));
    row->bind_text(5, line);
    if (auto done = row->step(); !done) return tl::unexpected(done.error());
    row->reset();
  }
  return {};
}

Result<void> write_head(const Database& to, const RecordingHead& head) {
  const bool tilts = head.tilt_checksum.has_value();
  const auto row = to.prepare(
      tilts ? "INSERT INTO recording(device, start_ns, period_ns, first_sample, samples, "
              "first_event, events, end_ns, checksum, lean_checksum) VALUES(?,?,?,?,?,?,?,?,?,?)"
            : "INSERT INTO recording(device, start_ns, period_ns, first_sample, samples, "
              "first_event, events, end_ns, checksum) VALUES(?,?,?,?,?,?,?,?,?)");
  if (!row) return tl::unexpected(row.error());
  row->bind_text(1, head.device);
  int at = 2;
  for (const std::int64_t value : {head.start_ns, head.period_ns, head.first_sample, head.samples,
                                   head.first_event, head.events, head.end_ns, head.checksum}) {
    row->bind(at++, value);
  }
  if (tilts) row->bind(at, *head.tilt_checksum);
  return row->step().map([](bool) {});
}

Result<std::int64_t> next_id(const Database& db, const char* table) {
  const auto row =
      db.prepare(("SELECT id FROM " + std::string(table) + " ORDER BY id DESC LIMIT 1").c_str());
  if (!row) return tl::unexpected(row.error());
  const Result<bool> any = row->step();
  if (!any) return tl::unexpected(any.error());
  return *any ? row->integer(0) + 1 : 1;
}

Result<void> write_recording(const Database& to, const FeltRecording& recording) {
  const Result<std::int64_t> sample = next_id(to, "recording_sample");
  const Result<std::int64_t> event = next_id(to, "recording_event");
  if (!sample || !event) return tl::unexpected(sample ? event.error() : sample.error());
  if (recording.device.size() > kMaxDeviceBytes || !is_utf8(recording.device)) {
    return invalid_data("the device of the recording has an invalid name");
  }
  RecordingHead head{recording.device};
  head.period_ns = recording.period_ns;
  head.first_sample = *sample;
  head.first_event = *event;
  head.samples = std::int64_t(recording.samples.size());
  head.events = std::int64_t(recording.events.size());
  if (!recording.samples.empty()) {
    head.start_ns = recording.samples.front().time_ns;
    head.end_ns = recording.samples.back().time_ns;
  }
  const bool with_tilt = knows_tilt(recording);
  Checksums checksums;
  if (auto ok = write_samples(to, recording, head, with_tilt, checksums); !ok) return ok;
  if (auto ok = write_events(to, recording, head, checksums.all); !ok) return ok;
  head.checksum = checksums.all.value();
  if (with_tilt) head.tilt_checksum = checksums.tilts.value();
  return write_head(to, head);
}

// --- Reading

Result<std::vector<RecordingHead>> read_heads(const Database& db, bool with_tilt) {
  const auto row = db.prepare(
      with_tilt ? "SELECT device, start_ns, period_ns, first_sample, samples, first_event, events, "
                  "end_ns, checksum, lean_checksum FROM recording NOT INDEXED"
                : "SELECT device, start_ns, period_ns, first_sample, samples, first_event, events, "
                  "end_ns, checksum FROM recording NOT INDEXED");
  if (!row) return tl::unexpected(row.error());
  std::vector<RecordingHead> heads;
  for (;;) {
    const Result<bool> more = row->step();
    if (!more) return tl::unexpected(more.error());
    if (!*more) return heads;
    if (heads.size() == kMaxRecordings) {
      return fail(ErrorCode::kLimitExceeded, "has more than 10000 recordings");
    }
    bool good = row->is_text(0) && row->text(0).size() <= kMaxDeviceBytes && is_utf8(row->text(0));
    for (int i = 1; i <= 8; ++i) {
      good = good && row->is_integer(i) && row->integer(i) >= 0 && row->integer(i) <= kMaxNumber;
    }
    const bool has_tilts = with_tilt && !row->is_null(9);
    good = good && (!has_tilts || row->is_integer(9));
    // Devices have tick periods of 0.2..4 ms. Much larger values are refused, because the products
    // below would overflow.
    if (!good || row->integer(2) > 1'000'000'000 || row->integer(4) > 1'000'000'000) {
      return invalid_data("recording " + std::to_string(heads.size()) +
                          " contains an invalid value");
    }
    RecordingHead head{std::string(row->text(0))};
    int at = 1;
    for (std::int64_t* value : {&head.start_ns, &head.period_ns, &head.first_sample, &head.samples,
                                &head.first_event, &head.events, &head.end_ns, &head.checksum}) {
      *value = row->integer(at++);
    }
    if (has_tilts) head.tilt_checksum = row->integer(9);
    heads.push_back(std::move(head));
  }
}

/// Column of the tilt in the query of samples.
constexpr int kTiltColumn = 13;

bool is_sample_row(const Statement& row) {
  bool good = row.is_integer(1) && std::abs(row.integer(1)) <= kMaxNumber;
  for (const int i : {2, 3, 4}) good = good && row.is_real(i);
  good = good && (row.is_null(5) || row.is_real(5)) && row.is_integer(6) && row.integer(6) >= 0 &&
         row.integer(6) <= std::numeric_limits<std::uint32_t>::max();
  constexpr auto kMaxSteps =
      static_cast<std::int64_t>(2 * kMaxRecordedForceN / kRecordedForceStepN);
  for (int i = 7; i <= 12; ++i) {
    good = good && (row.is_null(7) ? row.is_null(i)
                                   : row.is_integer(i) && row.integer(i) <= kMaxSteps &&
                                         row.integer(i) >= -kMaxSteps);
  }
  if (row.columns() > kTiltColumn) {
    good = good && (row.is_null(kTiltColumn) || row.is_real(kTiltColumn));
  }
  return good;
}

RecordedSample sample_of(const Statement& row, std::int64_t due_ns) {
  RecordedSample s;
  s.time_ns = due_ns + row.integer(1);
  s.pen.position = {row.real(2), row.real(3), row.real(4)};
  if (!row.is_null(5)) s.pen.pressure = row.real(5);
  s.pen.buttons = static_cast<std::uint32_t>(row.integer(6));
  if (row.columns() > kTiltColumn && !row.is_null(kTiltColumn)) {
    s.pen.tilt_deg = row.real(kTiltColumn);
  }
  if (row.is_null(7)) return s;
  const auto force = [&row](int at, bool sent) {
    const auto value = [&](int i) {
      return kRecordedForceStepN *
             static_cast<double>(row.integer(at + i) - (sent ? row.integer(at + i + 3) : 0));
    };
    return Force{value(0), value(1), value(2)};
  };
  s.forces = RecordedForces{force(7, false), force(7, true)};
  return s;
}

Result<void> read_samples(const Database& db, const RecordingHead& head, FeltRecording& recording,
                          Checksums& checksums) {
  const std::string tilt = head.tilt_checksum ? ", lean_deg" : "";
  const auto row = db.prepare(
      ("SELECT id, late_ns, x_mm, y_mm, z_mm, pressure, buttons, asked_x, asked_y, asked_z, cut_x, "
       "cut_y, cut_z" +
       tilt + " FROM recording_sample NOT INDEXED WHERE id >= ? AND id < ?")
          .c_str());
  if (!row) return tl::unexpected(row.error());
  row->bind(1, head.first_sample);
  row->bind(2, head.first_sample + head.samples);
  for (std::int64_t n = 0;; ++n) {
    const Result<bool> more = row->step();
    if (!more) return tl::unexpected(more.error());
    if (!*more)
      return n == head.samples ? Result<void>() : invalid_data("has fewer samples than it states");
    if (row->integer(0) != head.first_sample + n || !is_sample_row(*row)) {
      return invalid_data("sample " + std::to_string(n) + " contains an invalid value");
    }
    recording.samples.push_back(sample_of(*row, head.due_ns(n)));
    checksums.sample(recording.samples.back(), n);
  }
}

Result<Event> event_of(std::string_view text) {
  LineReader lines(read_text(text));
  LineBatch batch;
  const Result<bool> any = lines.fill(batch, text.size() + 1);
  if (!any) return tl::unexpected(any.error());
  if (!*any || batch.size() != 1) return invalid_data("is not a line");
  EventReader reader;
  Event event;
  RawStroke stroke;
  const Result<ScriptLineKind> kind = reader.read(batch.line(0), event, stroke);
  if (!kind) return tl::unexpected(kind.error());
  if (*kind != ScriptLineKind::kEvent) return invalid_data("is not an event");
  return event;
}

Result<void> read_events(const Database& db, const RecordingHead& head, FeltRecording& recording,
                         Checksum& checksum) {
  const auto row = db.prepare(
      "SELECT id, before_sample, time_ns, line FROM recording_event NOT INDEXED "
      "WHERE id >= ? AND id < ?");
  if (!row) return tl::unexpected(row.error());
  row->bind(1, head.first_event);
  row->bind(2, head.first_event + head.events);
  for (std::int64_t n = 0;; ++n) {
    const Result<bool> more = row->step();
    if (!more) return tl::unexpected(more.error());
    if (!*more)
      return n == head.events ? Result<void>() : invalid_data("has fewer events than it states");
    const std::string name = "event " + std::to_string(n);
    if (row->integer(0) != head.first_event + n || !row->is_integer(1) || !row->is_integer(2) ||
        !row->is_text(3) || row->integer(1) < head.first_sample ||
        row->integer(1) > head.first_sample + head.samples) {
      return invalid_data(name + " contains an invalid value");
    }
    Result<Event> event = event_of(row->text(3));
    if (!event) return tl::unexpected(with_context(event.error(), name));
    event->time_ns = row->integer(2);
    const auto before = static_cast<std::size_t>(row->integer(1) - head.first_sample);
    checksum.event(before, row->text(3));
    recording.events.push_back({before, *std::move(event)});
  }
}

Result<FeltRecording> read_one(const Database& db, const RecordingHead& head) {
  FeltRecording recording;
  recording.device = head.device;
  recording.period_ns = head.period_ns;
  Checksums checksums;
  Result<void> done = read_samples(db, head, recording, checksums)
                          .and_then([&] { return read_events(db, head, recording, checksums.all); })
                          .and_then([&] { return check_recording(recording); });
  if (!done) return tl::unexpected(done.error());
  if (checksums.all.value() != head.checksum ||
      (head.tilt_checksum && checksums.tilts.value() != *head.tilt_checksum)) {
    return invalid_data("its checksum does not match its samples");
  }
  return recording;
}

RecordingInfo info_of(const RecordingHead& head) {
  const double s = 1e-9 * static_cast<double>(head.end_ns - head.start_ns);
  return {head.device, head.period_ns, head.samples, head.events, s};
}

RecordingInfo info_of(const FeltRecording& r) {
  const double s =
      r.samples.empty()
          ? 0.0
          : 1e-9 * static_cast<double>(r.samples.back().time_ns - r.samples.front().time_ns);
  return {r.device, r.period_ns, std::ssize(r.samples), std::ssize(r.events), s};
}

/// Returns the recordings of the file; empty if it has no tables of recordings.
Result<std::vector<RecordingHead>> heads_of(const CarriedFile& file) {
  if (!file.database() || file.schema()->recordings.empty()) return std::vector<RecordingHead>();
  const auto& tables = file.schema()->recordings;
  return read_heads(*file.database(), std::count_if(tables.begin(), tables.end(), has_tilt) == 2);
}

}  // namespace

Result<void> write_recordings(Database& to, const FeltExtras& extras, const CarriedFile& carried) {
  const FeltSchema* like = carried.schema();
  const bool has_carried = like && !like->recordings.empty();
  if (!has_carried && extras.added.empty()) return {};
  const bool with_tilt = std::any_of(extras.added.begin(), extras.added.end(),
                                     [](const auto& added) { return knows_tilt(*added); });
  if (auto ok = make_recording_tables(to, like, with_tilt); !ok) return ok;
  if (has_carried) {
    for (const FeltTable& table : like->recordings) {
      const auto all = [](const Statement&) { return true; };
      if (auto ok = copy_rows(*carried.database(), to, table, all); !ok) return ok;
    }
  }
  for (const auto& recording : extras.added) {
    if (auto ok = check_recording(*recording); !ok) return ok;
    if (auto ok = write_recording(to, *recording); !ok) return ok;
  }
  return {};
}

Result<std::vector<RecordingInfo>> recordings_of(const Drawing& drawing) {
  const Result<CarriedFile> file = CarriedFile::open(felt_extras(drawing));
  if (!file) return tl::unexpected(file.error());
  const Result<std::vector<RecordingHead>> heads = heads_of(*file);
  if (!heads) return tl::unexpected(heads.error());
  std::vector<RecordingInfo> all;
  for (const RecordingHead& head : *heads) all.push_back(info_of(head));
  for (const auto& recording : felt_extras(drawing).added) all.push_back(info_of(*recording));
  return all;
}

Result<FeltRecording> read_recording(const Drawing& drawing, std::size_t number) {
  const Result<CarriedFile> file = CarriedFile::open(felt_extras(drawing));
  if (!file) return tl::unexpected(file.error());
  const Result<std::vector<RecordingHead>> heads = heads_of(*file);
  if (!heads) return tl::unexpected(heads.error());
  if (number >= heads->size() + felt_extras(drawing).added.size()) {
    return fail(ErrorCode::kNotFound, "has no recording " + std::to_string(number));
  }
  if (number >= heads->size()) return *felt_extras(drawing).added[number - heads->size()];
  Result<FeltRecording> recording = read_one(*file->database(), (*heads)[number]);
  if (recording) return recording;
  return tl::unexpected(with_context(recording.error(), "recording " + std::to_string(number)));
}

}  // namespace felt
