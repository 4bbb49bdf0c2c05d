#include "replay_stats.h"

#include "felt/io/ndjson/json_text.h"

namespace felt::cli {

std::string stats_json(const ReplayStats& stats) {
  const auto count = [](std::int64_t n) { return std::to_string(n); };
  JsonObject object;
  object.add_raw("ticks", count(stats.ticks));
  object.add_number("simulated_s", stats.simulated_s);
  object.add_number("wall_s", stats.wall_s);
  object.add_number("times_real_time", stats.times_real_time());
  object.add_raw("touches", count(stats.touches));
  object.add_raw("strokes_meant", count(stats.strokes_meant));
  object.add_raw("strokes", count(stats.strokes));
  object.add_raw("strokes_changed", count(stats.strokes_changed));
  object.add_raw("segments", count(stats.segments));
  object.add_raw("edits", count(stats.edits));
  object.add_raw("soft_faults", count(stats.soft_faults));
  object.add_raw("hard_faults", count(stats.hard_faults));
  object.add_number("max_asked_n", stats.max_asked_n);
  object.add_number("max_force_n", stats.max_sent_n);
  object.add_number("mean_contact_force_n", stats.mean_sent_n());
  if (stats.distance.count() == 0) {
    object.add_raw("intended_to_ink_mm", "null");
  } else {
    JsonObject distance;
    distance.add_number("mean", stats.distance.mean_mm());
    distance.add_number("p95", stats.distance.p95_mm());
    distance.add_number("max", stats.distance.max_mm());
    object.add_raw("intended_to_ink_mm", distance.text());
  }
  return object.text() + "\n";
}

}  // namespace felt::cli
