#include "felt/replay/script_run.h"

#include <algorithm>
#include <filesystem>

namespace felt {

ScriptRun::ScriptRun(ReplayMachine& machine, double mm_per_unit, std::uint64_t seed)
    : machine_(machine), feed_({.mm_per_unit = mm_per_unit, .hand = {}, .seed = seed}, sink()) {}

FeedSink ScriptRun::sink() {
  return {
      .event = [this](const Event& event) -> Result<void> {
        const auto* import = std::get_if<ImportEvent>(&event.what);
        if (!import || folder_.empty() || import->path.rfind('/', 0) == 0) {
          return machine_.add(event);
        }
        return machine_.add({event.time_ns, ImportEvent{folder_ + import->path, import->select}});
      },
      .stroke_begins = [this] { machine_.begin_stroke(); },
      .stroke_drawn = [this](const std::vector<Point>& meant) -> Result<void> {
        machine_.stroke_drawn(meant);
        return machine_.is_full() ? play() : Result<void>();
      },
      .hand = [this] { return machine_.hand_options(); },
  };
}

Result<void> ScriptRun::script(const std::string& name, const std::string& folder, ReadBytes read) {
  name_ = name;
  folder_ = folder;
  return feed_.read(name, [this, read = std::move(read)](std::span<char> into) {
    Result<std::size_t> count = read(into);
    if (count) read_bytes_ += static_cast<double>(*count);
    return count;
  });
}

void ScriptRun::expect(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    std::error_code error;
    const auto bytes = std::filesystem::file_size(path, error);
    if (!error) expected_bytes_ += static_cast<double>(bytes);
  }
}

double ScriptRun::progress(double part) const noexcept {
  const double done = played_bytes_ + part * (read_bytes_ - played_bytes_);
  return std::clamp(done / std::max({expected_bytes_, read_bytes_, 1.0}), 0.0, 1.0);
}

Result<void> ScriptRun::play() {
  if (Result<void> rested = feed_.rest(); !rested) return rested;
  if (Result<void> played = machine_.play(); !played) {
    return tl::unexpected(with_context(played.error(), name_));
  }
  feed_.begin_play(machine_.next_ns());
  played_bytes_ = read_bytes_;
  return {};
}

}  // namespace felt
