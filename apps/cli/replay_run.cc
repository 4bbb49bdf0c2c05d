#include "replay_run.h"

#include "input.h"

namespace felt::cli {

ReplayRun::ReplayRun(ReplayMachine& machine, double mm_per_unit, std::uint64_t seed)
    : machine_(machine), feed_({.mm_per_unit = mm_per_unit, .hand = {}, .seed = seed}, sink()) {}

FeedSink ReplayRun::sink() {
  return {
      .event = [this](const Event& event) -> Result<void> {
        const auto* import = std::get_if<ImportEvent>(&event.what);
        if (!import || folder_.empty() || import->path.rfind('/', 0) == 0) {
          return machine_.add(event);
        }
        return machine_.add({event.time_ns, ImportEvent{folder_ + "/" + import->path}});
      },
      .stroke_begins = [this] { machine_.begin_stroke(); },
      .stroke_drawn = [this](const std::vector<Point>& meant) -> Result<void> {
        machine_.stroke_drawn(meant);
        return machine_.is_full() ? play() : Result<void>();
      },
      .hand = [this] { return machine_.hand_options(); },
  };
}

Result<void> ReplayRun::script(const std::string& name, const std::string& folder, ReadBytes read) {
  folder_ = folder;
  return feed_.read(name, std::move(read));
}

Result<void> ReplayRun::file(const std::string& path) {
  const Result<Input> input = Input::open(path);
  if (!input) return fail(input.error().code, input_name(path) + ": " + input.error().message);
  const std::size_t slash = path.find_last_of('/');
  const std::string folder = path == "-" || slash == std::string::npos ? "" : path.substr(0, slash);
  return script(input->name(), folder, input->reader());
}

Result<void> ReplayRun::play() {
  if (Result<void> rested = feed_.rest(); !rested) return rested;
  if (Result<void> played = machine_.play(); !played) return played;
  feed_.begin_play(machine_.next_ns());
  return {};
}

}  // namespace felt::cli
