#include "felt/replay/record_copy.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <optional>
#include <span>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>

#include "felt/base/atomic_file.h"
#include "felt/io/ndjson/ndjson_writer.h"
#include "felt/session/session_medium.h"
#include "felt/tools/overlay.h"

namespace felt {
namespace {

/// Minimum pause before the next copy, as a multiple of the time that the last copy took.
constexpr int kPausePerWork = 50;
constexpr std::string_view kMark = ".unsaved-", kEnding = ".ndjson";

std::string path_for(const std::string& output) {
  std::error_code none;
  const std::filesystem::file_status status = std::filesystem::status(output, none);
  const bool is_file = output != "-" && (!std::filesystem::exists(status) ||
                                         std::filesystem::is_regular_file(status));
  const std::string name = std::filesystem::temp_directory_path(none).string() + "/feltline-record";
  return (is_file ? output : name) + std::string(kMark) + std::to_string(getpid()) +
         std::string(kEnding);
}

/// Returns a stroke of consecutive segments of wet ink. A short segment is joined to the next one.
StrokeData wet_stroke(std::span<const Overlay::InkSegment> ink) {
  StrokeData data;
  for (const Overlay::InkSegment& segment : ink) {
    const Cubic& c = segment.curve;
    if (data.points.empty()) {
      data.points.push_back(c.p[0]);
      data.widths.push_back({0.0, segment.start_width_mm, segment.start_tone});
    }
    const bool is_short = distance(data.points.back(), c.p[3]) < 2.0 * kMinSegmentMm;
    if (is_short && &segment != &ink.back()) continue;
    if (data.points.size() > 1) data.joints.push_back(JointKind::kCorner);
    data.points.insert(data.points.end(), {c.p[1], c.p[2], c.p[3]});
    data.widths.push_back(
        {static_cast<double>(data.widths.size()), segment.end_width_mm, segment.end_tone});
  }
  for (WidthKnot& knot : data.widths) knot.width_mm = std::max(knot.width_mm, kMinWidthMm);
  return data;
}

/// Appends the stroke that the pen is drawing, if any.
void append_stroke_in_progress(std::string& text, const Session& session) {
  Overlay overlay;
  session.draw(overlay);
  if (overlay.ink.empty()) return;
  StrokeData data = wet_stroke(overlay.ink);
  data.color = overlay.ink_color;
  if (std::string medium = drawing_medium(session); !medium.empty()) {
    data.medium = std::move(medium);
  }
  // The last segment may still be too short.
  if (!check_invariants(data) && !data.joints.empty()) {
    data.points.resize(data.points.size() - 3);
    data.joints.pop_back();
    data.widths.pop_back();
  }
  if (check_invariants(data)) append_sketch_line(text, "unfinished", data);
}

/// Returns the id of the process that wrote the copy with this file name; nullopt if it is not the
/// name of a copy.
std::optional<pid_t> writer_of(std::string_view name) {
  const std::size_t mark = name.rfind(kMark);
  if (mark == std::string_view::npos || !name.ends_with(kEnding)) return std::nullopt;
  const char* const first = name.data() + mark + kMark.size();
  const char* const last = name.data() + name.size() - kEnding.size();
  pid_t number = 0;
  const auto [end, error] = std::from_chars(first, last, number);
  if (error != std::errc() || end != last || number <= 0) return std::nullopt;
  return number;
}

/// Returns the start time of a process, in seconds since 1970. Returns nullopt if the process is
/// gone or the time is unknown.
std::optional<double> start_of(pid_t process) {
  // The start time is the 22nd word, in ticks since the boot. The second word is in parentheses and
  // may contain spaces.
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string word;
  std::getline(file, word, '\0');
  std::istringstream words(word.substr(std::min(word.rfind(')'), word.size())));
  double ticks = -1.0, boot_s = -1.0;
  for (int i = 2; i < 22; ++i) words >> word;
  if (!(words >> ticks)) ticks = -1.0;
  std::ifstream machine("/proc/stat");
  while (machine >> word) {
    if (word == "btime" && machine >> boot_s) break;
  }
  if (ticks < 0.0 || boot_s < 0.0) return std::nullopt;
  return boot_s + ticks / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

/// Returns true if this process wrote the copy and may still be running. A process that began after
/// the last write to the copy is a different process with the same id, for example after a restart
/// of the machine.
bool writer_lives(pid_t writer, const std::string& copy) {
  constexpr double kClocksDifferS = 2.0;
  if (::kill(writer, 0) != 0 && errno == ESRCH) return false;
  struct stat info {};
  const std::optional<double> start_s = start_of(writer);
  if (!start_s || ::stat(copy.c_str(), &info) != 0) return true;
  return *start_s < static_cast<double>(info.st_mtime) + kClocksDifferS;
}

}  // namespace

RecordCopy::RecordCopy(const std::string& output, Clock::duration every)
    : path_(path_for(output)), every_(every), next_(Clock::now() + every) {}

void RecordCopy::keep(const Session& session) {
  const Clock::time_point now = Clock::now();
  const bool is_drawing = session.gesture_in_progress();
  if ((!is_changed_ && !is_drawing) || now < next_) return;
  if (writing_.valid() && writing_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
    return;
  }
  is_changed_ = is_drawing;  // the finished stroke will replace the stroke in progress
  std::string text;
  append_sketch_lines(text, session.document());
  append_stroke_in_progress(text, session);
  // Does not write an empty copy, because it would be offered for recovery.
  std::error_code none;
  if (text.empty() && !std::filesystem::exists(path_, none)) return;
  next_ = now + std::max(every_, kPausePerWork * (Clock::now() - now));
  try {
    writing_ = std::async(std::launch::async, [path = path_, text = std::move(text)] {
      return write_file(path, text);  // a failed write is repeated with the next change
    });
  } catch (const std::system_error&) {  // no thread is available now
    is_changed_ = true;
  }
}

void RecordCopy::wait() {
  if (writing_.valid()) writing_.wait();
}

void RecordCopy::remove() {
  wait();
  std::error_code none;
  std::filesystem::remove(path_, none);
}

std::vector<std::string> find_record_copies(const std::vector<std::string>& folders) {
  std::vector<std::string> copies;
  for (const std::string& folder : folders) {
    std::error_code error;
    for (std::filesystem::directory_iterator at(folder, error), end; !error && at != end;
         at.increment(error)) {
      const std::optional<pid_t> writer = writer_of(at->path().filename().string());
      std::error_code none;
      if (!writer || !at->is_regular_file(none)) continue;
      if (!writer_lives(*writer, at->path().string())) copies.push_back(at->path().string());
    }
  }
  std::sort(copies.begin(), copies.end());
  return copies;
}

}  // namespace felt
