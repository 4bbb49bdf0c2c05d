#include "console.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "felt/base/printable.h"
#include "felt/io/import.h"
#include "print.h"

namespace felt::cli {
namespace {

constexpr int kBarCells = 24;
constexpr std::size_t kMaxKinds =
    100;  // maximum number of kinds that are counted; all others share one count

bool can_redraw_stderr() {
  const char* terminal = std::getenv("TERM");
  return isatty(STDERR_FILENO) != 0 && terminal != nullptr && std::string_view(terminal) != "dumb";
}

/// Returns a number with commas, such as "65,997".
std::string with_commas(std::int64_t number) {
  std::string text = std::to_string(number);
  for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, ",");
  return text;
}

/// Returns a progress bar. It does not use colour, so NO_COLOR does not affect it.
std::string bar(double fraction) {
  const int filled = static_cast<int>(std::clamp(fraction, 0.0, 1.0) * kBarCells);
  return "[" + std::string(static_cast<std::size_t>(filled), '#') +
         std::string(static_cast<std::size_t>(kBarCells - filled), '.') + "]";
}

}  // namespace

Console::Console()
    : shows_progress_(can_redraw_stderr()),
      next_draw_(Clock::now() + std::chrono::milliseconds(500)) {}

Console::~Console() {
  end_progress();
}

void Console::error(const std::string& message) {
  end_progress();
  failed_ = true;
  say("feltline: {}\n", printable(message));
}

void Console::notice(const std::string& message) {
  if (strict_) return error(message);
  summary(message);
}

void Console::summary(const std::string& message) {
  if (!shows_notices_) return;
  end_progress();
  say("feltline: {}\n", printable(message));
}

Console::Repeated& Console::repeated(const std::string& name, std::int64_t line,
                                     const std::string& what) {
  std::string kind = notice_kind(what);
  if (repeated_.size() >= kMaxKinds) kind.clear();
  const auto same = std::find_if(repeated_.begin(), repeated_.end(), [&](const Repeated& r) {
    return r.name == name && r.kind == kind;
  });
  if (same != repeated_.end()) return *same;
  return repeated_.emplace_back(Repeated{name, std::move(kind), line, 0});
}

void Console::record_error(const std::string& name, std::int64_t line, const std::string& what) {
  failed_ = true;
  if (++repeated(name, line, what).count > kShownOfAKind) return;
  error(line > 0 ? fmt::format("{}:{}: {}", name, line, what) : name + ": " + what);
}

void Console::end_records() {
  for (const Repeated& r : repeated_) {
    if (r.count <= kShownOfAKind) continue;
    error(fmt::format("{}: ... and {} more like it (line {}{})", r.name,
                      with_commas(r.count - kShownOfAKind), r.first_line,
                      r.kind.empty() ? ", and others" : ""));
  }
  repeated_.clear();
}

void Console::progress(const char* what, std::int64_t done, std::int64_t total,
                       std::int64_t strokes) {
  if (!shows_progress_ || Clock::now() < next_draw_) return;
  next_draw_ = Clock::now() + std::chrono::milliseconds(100);
  std::string line = fmt::format("\r{} ", what);
  if (total > 0) {
    const double fraction = static_cast<double>(done) / static_cast<double>(total);
    line += fmt::format("{} {:3.0f} %  ", bar(fraction), std::min(100.0, 100.0 * fraction));
  }
  say("{}{} strokes\x1b[K", line, strokes);
  drawn_ = true;
}

void Console::status(const std::string& line) {
  if (!shows_progress_ || Clock::now() < next_draw_) return;
  next_draw_ = Clock::now() + std::chrono::milliseconds(100);
  say("\r{}\x1b[K", line);
  drawn_ = true;
}

void Console::end_progress() {
  if (!drawn_) return;
  say("\r\x1b[K");
  drawn_ = false;
}

}  // namespace felt::cli
