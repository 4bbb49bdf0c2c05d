#include "desktop/trial/unfinished_trials.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include "desktop/trial/session_steps.h"
#include "felt/base/read_file.h"
#include "felt/io/events/event_reader.h"
#include "felt/session/session.h"
#include "felt/store/felt_recording.h"
#include "felt/tools/tool.h"

namespace felt::desktop {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxUnfinishedBytes = std::size_t{1} << 30;

struct UnfinishedTrial {
  int trial = 0;
  int attempt = 0;
  fs::path path;
};

std::vector<UnfinishedTrial> find_unfinished(const fs::path& folder) {
  std::vector<UnfinishedTrial> found;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    UnfinishedTrial one;
    const std::string name = entry.path().filename().string();
    if (std::sscanf(name.c_str(), "unfinished-%d-%d", &one.trial, &one.attempt) != 2) continue;
    if (name != unfinished_name(one.trial, one.attempt)) continue;
    one.path = entry.path();
    found.push_back(std::move(one));
  }
  std::sort(found.begin(), found.end(), [](const UnfinishedTrial& a, const UnfinishedTrial& b) {
    return std::pair(a.trial, a.attempt) < std::pair(b.trial, b.attempt);
  });
  return found;
}

/// Reads the whole lines of a file of events; the crash may have cut the last line.
Result<std::vector<Event>> read_unfinished(const fs::path& path) {
  Result<std::string> text = read_regular_file(path.string(), kMaxUnfinishedBytes);
  if (!text) return tl::unexpected(text.error());
  text->resize(text->rfind('\n') == std::string::npos ? 0 : text->rfind('\n') + 1);
  return read_events(path.string(), read_text(*text));
}

bool has_sample(std::span<const Event> events) {
  return std::any_of(events.begin(), events.end(), [](const Event& event) {
    return std::holds_alternative<PenEvent>(event.what);
  });
}

}  // namespace

std::string unfinished_name(int trial, int attempt) {
  return "unfinished-" + std::to_string(trial) + '-' + std::to_string(attempt) + ".ndjson";
}

Result<Drawing> drawing_of_events(std::span<const Event> events, const std::string& device) {
  Session session(make_tools(), {});
  for (const Event& event : events) {
    if (auto done = session.apply(event); !done) return tl::unexpected(done.error());
  }
  static_cast<void>(session.finish());
  FeltRecorder recorder(device, session.device().period_ns);
  for (const Event& event : events) recorder.event(event);
  Drawing drawing;
  drawing.document = session.document();
  if (auto done = add_recording(drawing, recorder.take()); !done) {
    return tl::unexpected(done.error());
  }
  return drawing;
}

Result<int> recover_unfinished_trials(StudyFolder& folder, StudySession& session) {
  int count = 0;
  const fs::path inside = folder.file_of(session.info, unfinished_name(1, 1));
  for (const UnfinishedTrial& one : find_unfinished(inside.parent_path())) {
    const bool is_saved = std::any_of(
        session.results.begin(), session.results.end(),
        [&](const TrialResult& r) { return r.trial == one.trial && r.attempt == one.attempt; });
    if (!is_saved) {
      const Result<std::vector<Event>> events = read_unfinished(one.path);
      if (!events) return tl::unexpected(events.error());
      if (has_sample(*events)) {
        const Result<Drawing> drawing = drawing_of_events(*events, session.info.device);
        if (!drawing) return tl::unexpected(with_context(drawing.error(), one.path.string()));
        const Result<void> added = folder.add_trial(
            session, {one.trial, one.attempt, std::string(kInterrupted), {}}, *drawing);
        if (!added) return tl::unexpected(added.error());
        ++count;
      }
    }
    std::error_code ignored;  // the file is deleted at the next start
    fs::remove(one.path, ignored);
  }
  return count;
}

}  // namespace felt::desktop
