#include "felt/replay/forces_csv.h"

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "felt/io/ndjson/ndjson_writer.h"

namespace felt {
namespace {

constexpr std::size_t kCsvBufferBytes = std::size_t{256} << 10;
constexpr std::string_view kFixedColumns =
    "t_ms,x,y,z,vx,vy,vz,pressure,ask_x,ask_y,ask_z,sent_x,sent_y,sent_z";

tl::unexpected<Error> csv_error(const char* doing) {
  return fail(ErrorCode::kIo, std::string("temporary file: cannot ") + doing + ": " +
                                  std::generic_category().message(errno));
}

/// Adds 0, which turns a negative zero into a positive one, because that is less surprising to
/// read.
void append(std::string& row, double value) {
  append_number(row, value + 0.0);
  row += ',';
}

void append(std::string& row, double x, double y, double z) {
  append(row, x);
  append(row, y);
  append(row, z);
}

}  // namespace

Result<ForcesCsv> ForcesCsv::create() {
  ForcesCsv file;
  file.spool_.reset(std::tmpfile());
  if (!file.spool_) return csv_error("create");
  return file;
}

std::size_t ForcesCsv::group_of(std::string_view name) {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found != names_.end()) return static_cast<std::size_t>(found - names_.begin());
  names_.emplace_back(name);
  forces_.emplace_back();
  growth_.push_back({row_count_, names_.size()});
  return names_.size() - 1;
}

Result<void> ForcesCsv::add(const TickReport& tick, std::optional<double> pressure) {
  std::fill(forces_.begin(), forces_.end(), Force{});
  for (const ForceTerms::Term& term : tick.terms) {
    const std::size_t group = group_of(term.name);
    forces_[group] += term.force;
  }
  const PenSample& pen = tick.sample;
  append(rows_, static_cast<double>(pen.time_ns) / 1e6);
  append(rows_, pen.position.x, pen.position.y, pen.position.z);
  append(rows_, pen.velocity.x, pen.velocity.y, pen.velocity.z);
  if (pressure) {
    append(rows_, *pressure);
  } else {
    rows_ += ',';
  }
  append(rows_, tick.asked.x, tick.asked.y, tick.asked.z);
  append(rows_, tick.sent.x, tick.sent.y, tick.sent.z);
  for (const Force& force : forces_) append(rows_, force.x, force.y, force.z);
  rows_.back() = '\n';
  ++row_count_;
  return rows_.size() < kCsvBufferBytes ? Result<void>() : spool();
}

Result<void> ForcesCsv::spool() {
  if (std::fwrite(rows_.data(), 1, rows_.size(), spool_.get()) != rows_.size()) {
    return csv_error("write");
  }
  rows_.clear();
  return {};
}

std::string ForcesCsv::padding_of(std::int64_t row) const {
  std::size_t terms = 0;
  for (const Growth& growth : growth_) {
    if (growth.row <= row) terms = growth.terms;
  }
  std::string padding;
  for (std::size_t i = 3 * terms; i < 3 * names_.size(); ++i) padding += ",0";
  return padding;
}

void ForcesCsv::pad_rows(std::span<const char> bytes, std::int64_t& row, std::string& text) const {
  std::string padding = padding_of(row);
  for (const char c : bytes) {
    if (c == '\n') {
      text += padding;
      ++row;
      if (!padding.empty()) padding = padding_of(row);
    }
    text += c;
  }
}

Result<void> ForcesCsv::copy_rows(const Write& write) {
  std::vector<char> buffer(kCsvBufferBytes);
  std::string text;
  std::int64_t row = 0;
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), spool_.get())) {
    text.clear();
    pad_rows(std::span(buffer.data(), count), row, text);
    if (Result<void> written = write(text); !written) return written;
  }
  return std::ferror(spool_.get()) ? csv_error("read") : Result<void>();
}

Result<void> ForcesCsv::finish(const Write& write) {
  if (Result<void> spooled = spool(); !spooled) return spooled;
  if (std::fflush(spool_.get()) != 0 || std::fseek(spool_.get(), 0, SEEK_SET) != 0) {
    return csv_error("read");
  }
  std::string header(kFixedColumns);
  for (const std::string& name : names_) {
    for (const char* axis : {"_x", "_y", "_z"}) header += "," + name + axis;
  }
  if (Result<void> written = write(header + "\n"); !written) return written;
  return copy_rows(write);
}

}  // namespace felt
