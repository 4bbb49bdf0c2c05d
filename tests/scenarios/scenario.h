#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "felt/io/events/event_reader.h"
#include "felt/session/player.h"

namespace felt {

/// Everything that came of a script, so that two plays can be compared.
struct ScenarioResult {
  PlayReport report;
  std::vector<StrokePtr> strokes;  ///< of visible layers
  std::string sketch_text;         ///< as a file
  std::string recording;           ///< as a script
  std::uint64_t ticks = 0;         ///< fingerprint of poses and forces
  std::size_t undo_count = 0;
  std::size_t redo_count = 0;
};

struct ScenarioOptions {
  std::string device = "touch";  ///< a simulated stylus, in a typical hand
  bool forces = true;
  std::int64_t edit_period_ns = 4'000'000;
};

/// Plays a script from an empty document on, on this device and in this hand.
Result<ScenarioResult> play_scenario_on(Device& device, HandInput& hand,
                                        const std::vector<Event>& events,
                                        const ScenarioOptions& options);

/// Likewise on the simulated stylus that the options name.
Result<ScenarioResult> play_scenario(const std::vector<Event>& events,
                                     const ScenarioOptions& options);

/// Applies the events of a recording to a session directly, without device and loop. Returns its
/// document.
Result<Document> tell_session(const std::vector<Event>& events, const std::string& device);

/// Returns the visible strokes as an .ndjson file.
std::string text_of(const Document& document);

/// What must come of a script: the lines of a .expect file, in words.
using Expectations = std::vector<std::vector<std::string>>;

/// The words of each line; comments and empty lines left out.
Expectations parse_expectations(const std::string& text);

/// A script with what must come of it.
struct Scenario {
  std::string name;
  std::vector<Event> events;
  Expectations expected;
  std::string device = "touch";

  [[nodiscard]] bool has_hand() const;
};
/// Reads those of this folder and of the tools' folders, in the order of their names. Fails if a
/// file cannot be read.
Result<std::vector<Scenario>> read_scenarios();

/// Empty when this expectation is met, else what is wrong.
std::string check_expectation(const std::vector<std::string>& words, const ScenarioResult& result);

}  // namespace felt
