#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "felt/io/events/event_reader.h"
#include "felt/session/player.h"

namespace felt {

/// All results of playing a script, so that two plays can be compared.
struct ScenarioResult {
  PlayReport report;
  std::vector<StrokePtr> strokes;  ///< strokes of visible layers
  std::string sketch_text;         ///< the strokes as the text of a file
  std::string recording;           ///< the recording as the text of a script
  std::uint64_t ticks = 0;         ///< hash of the poses and forces of all ticks
  std::size_t undo_count = 0;
  std::size_t redo_count = 0;
};

struct ScenarioOptions {
  std::string device = "touch";  ///< name of a simulated stylus; a typical hand holds it
  bool forces = true;
  std::int64_t edit_period_ns = 4'000'000;
};

/// Plays a script on `device` with `hand`. Starts with an empty document.
Result<ScenarioResult> play_scenario_on(Device& device, HandInput& hand,
                                        const std::vector<Event>& events,
                                        const ScenarioOptions& options);

/// Same as play_scenario_on(), with the simulated stylus that `options` names.
Result<ScenarioResult> play_scenario(const std::vector<Event>& events,
                                     const ScenarioOptions& options);

/// Applies the events of a recording to a session directly, without device and loop. Returns its
/// document.
Result<Document> report_session(const std::vector<Event>& events, const std::string& device);

/// Returns the visible strokes as an .ndjson file.
std::string text_of(const Document& document);

/// The expected results of a script: the lines of a .expect file, split into words.
using Expectations = std::vector<std::vector<std::string>>;

/// Returns the words of each line, without comments and empty lines.
Expectations parse_expectations(const std::string& text);

/// A script with its expected results.
struct Scenario {
  std::string name;
  std::vector<Event> events;
  Expectations expected;
  std::string device = "touch";

  [[nodiscard]] bool has_hand() const;
};
/// Reads the scenarios of this folder and of the tools' folders, sorted by name. Fails if a file
/// cannot be read.
Result<std::vector<Scenario>> read_scenarios();

/// Returns "" if the expectation `words` is met, otherwise a description of the difference.
std::string check_expectation(const std::vector<std::string>& words, const ScenarioResult& result);

}  // namespace felt
