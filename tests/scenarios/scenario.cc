#include "tests/scenarios/scenario.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <sstream>

#include "felt/base/hash.h"
#include "felt/devices/simulated/simulated_stylus.h"
#include "felt/document/visible_strokes.h"
#include "felt/io/events/event_writer.h"
#include "felt/io/ndjson/ndjson_writer.h"
#include "felt/session/recorder.h"
#include "felt/stroke/color_text.h"

namespace felt {
namespace {

void add_tick(Fnv1a& hash, const TickReport& tick) {
  hash.add_value(tick.sample.time_ns);
  for (const Vec3& v : {tick.sample.position, tick.sample.velocity}) {
    hash.add_value(v.x);
    hash.add_value(v.y);
    hash.add_value(v.z);
  }
  const auto add_force = [&hash](const Force& f) {
    hash.add_value(f.x);
    hash.add_value(f.y);
    hash.add_value(f.z);
  };
  add_force(tick.asked);
  add_force(tick.sent);
  for (const ForceTerms::Term& term : tick.terms) add_force(term.force);
}

Result<const StylusPreset*> find_device(const std::string& name) {
  const StylusPreset* preset = find_stylus_preset(name);
  if (!preset) return fail(ErrorCode::kNotFound, "no device \"" + name + "\"");
  return preset;
}

Result<std::size_t> count_redo(Session& session) {
  std::size_t count = 0;
  for (; session.history().can_redo(); ++count) {
    if (Result<void> done = session.apply({0, RedoEvent{}}); !done) {
      return tl::unexpected(done.error());
    }
  }
  return count;
}

/// Returns the stroke with the number `rank`, counted from 1, or null if it does not exist.
const Stroke* stroke_of(const ScenarioResult& result, const std::string& rank) {
  const std::size_t k = static_cast<std::size_t>(std::stoul(rank));
  return k >= 1 && k <= result.strokes.size() ? result.strokes[k - 1].get() : nullptr;
}

namespace fs = std::filesystem;

std::string content_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

using Words = std::vector<std::string>;

std::string expect_count(std::size_t got, const Words& words) {
  return std::to_string(got) == words[1] ? "" : "there are " + std::to_string(got);
}

std::string expect_between(double got, double smallest, double largest) {
  return got >= smallest && got <= largest ? "" : "it is " + std::to_string(got);
}

std::string expect_place(const ScenarioResult& result, const Words& words) {
  const Stroke* stroke = stroke_of(result, words[1]);
  if (!stroke) return "there is no such line";
  const Point at = stroke->position(words[0] == "start" ? 0.0 : stroke->segment_count());
  const double away_mm = distance(at, {std::stod(words[2]), std::stod(words[3])});
  if (away_mm <= std::stod(words[4])) return "";
  return "it is at " + std::to_string(at.x) + " " + std::to_string(at.y);
}

std::string expect_width(const ScenarioResult& result, const Words& words) {
  const Stroke* stroke = stroke_of(result, words[1]);
  if (!stroke) return "there is no such line";
  double smallest = std::numeric_limits<double>::infinity(), largest = 0.0;
  for (int i = 10; i <= 90; ++i) {
    const double width_mm = stroke->width_mm(0.01 * i * stroke->segment_count());
    smallest = std::min(smallest, width_mm);
    largest = std::max(largest, width_mm);
  }
  if (smallest >= std::stod(words[2]) && largest <= std::stod(words[3])) return "";
  return "it is from " + std::to_string(smallest) + " to " + std::to_string(largest);
}

std::string expect_color(const ScenarioResult& result, const Words& words) {
  const Stroke* stroke = stroke_of(result, words[1]);
  if (!stroke) return "there is no such line";
  const std::string color = color_to_text(stroke->color());
  return color == words[2] ? "" : "it is " + color;
}

struct Kind {
  std::size_t words;
  std::string (*check)(const ScenarioResult&, const Words&);
};

const std::map<std::string, Kind>& kinds() {
  static const std::map<std::string, Kind> all = {
      {"device", {2, [](const ScenarioResult&, const Words&) { return std::string(); }}},
      {"strokes",
       {2,
        [](const ScenarioResult& r, const Words& w) { return expect_count(r.strokes.size(), w); }}},
      {"closed",
       {2,
        [](const ScenarioResult& r, const Words& w) {
          return expect_count(static_cast<std::size_t>(std::count_if(
                                  r.strokes.begin(), r.strokes.end(),
                                  [](const StrokePtr& stroke) { return stroke->closed(); })),
                              w);
        }}},
      {"undo",
       {2, [](const ScenarioResult& r, const Words& w) { return expect_count(r.undo_count, w); }}},
      {"redo",
       {2, [](const ScenarioResult& r, const Words& w) { return expect_count(r.redo_count, w); }}},
      {"hard_faults",
       {2, [](const ScenarioResult& r,
              const Words& w) { return expect_count(r.report.safety.hard_faults, w); }}},
      {"force",
       {3,
        [](const ScenarioResult& r, const Words& w) {
          return expect_between(r.report.largest_sent_n, std::stod(w[1]), std::stod(w[2]));
        }}},
      {"start", {5, expect_place}},
      {"end", {5, expect_place}},
      {"width", {4, expect_width}},
      {"color", {3, expect_color}},
  };
  return all;
}

}  // namespace

std::string text_of(const Document& document) {
  std::string text;
  append_sketch_lines(text, document);
  return text;
}

Result<ScenarioResult> play_scenario(const std::vector<Event>& events,
                                     const ScenarioOptions& scenario) {
  const Result<const StylusPreset*> preset = find_device(scenario.device);
  if (!preset) return tl::unexpected(preset.error());
  SimulatedStylus stylus(**preset);
  return play_scenario_on(stylus, stylus, events, scenario);
}

Result<ScenarioResult> play_scenario_on(Device& device, HandInput& hand,
                                        const std::vector<Event>& events,
                                        const ScenarioOptions& scenario) {
  ScenarioResult result;
  Recorder recorder([&result](std::span<const Event> batch) {
    for (const Event& event : batch) append_event_line(result.recording, event);
  });
  Session session(make_tools(), {.device = device.capabilities(), .on_event = std::ref(recorder)});
  Fnv1a ticks;
  PlayerOptions options;
  options.forces = scenario.forces;
  options.edit_period_ns = scenario.edit_period_ns;
  options.period_ns = device.capabilities().period_ns;
  options.on_tick = [&ticks](const TickReport& tick) { add_tick(ticks, tick); };
  Player player(device, &hand, session, std::move(options));
  const Result<PlayReport> report = player.play(events);
  if (!report) return tl::unexpected(report.error());
  recorder.flush();
  result.report = *report;
  result.strokes = visible_strokes(session.document());
  result.sketch_text = text_of(session.document());
  result.ticks = ticks.value();
  result.undo_count = session.history().undo_count();
  const Result<std::size_t> redo = count_redo(session);
  if (!redo) return tl::unexpected(redo.error());
  result.redo_count = *redo;
  return result;
}

Result<Document> report_session(const std::vector<Event>& events, const std::string& device) {
  const Result<const StylusPreset*> preset = find_device(device);
  if (!preset) return tl::unexpected(preset.error());
  Session session(make_tools(), {.device = (*preset)->capabilities});
  for (const Event& event : events) {
    if (Result<void> done = session.apply(event); !done) return tl::unexpected(done.error());
  }
  return session.document();
}

Expectations parse_expectations(const std::string& text) {
  Expectations all;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream in(line);
    Words words;
    for (std::string word; in >> word;) words.push_back(word);
    if (!words.empty()) all.push_back(std::move(words));
  }
  return all;
}

bool Scenario::has_hand() const {
  return std::any_of(events.begin(), events.end(), [](const Event& event) {
    return std::holds_alternative<HandEvent>(event.what);
  });
}

Result<std::vector<Scenario>> read_scenarios() {
  std::map<std::string, fs::path> scripts;
  const auto find = [&scripts](const fs::path& folder) {
    if (!fs::is_directory(folder)) return;
    for (const auto& entry : fs::directory_iterator(folder)) {
      const fs::path& path = entry.path();
      if (path.extension() == ".ndjson") scripts.emplace(path.stem().string(), path);
    }
  };
  find("tests/scenarios");
  for (const auto& tool : fs::directory_iterator("src/felt/tools")) find(tool.path() / "scenarios");
  std::vector<Scenario> all;
  for (const auto& [name, path] : scripts) {
    Scenario scenario{name, {}, {}};
    const std::string text = content_of(path);
    Result<std::vector<Event>> events = read_events(path.string(), read_text(text));
    if (!events) return tl::unexpected(events.error());
    scenario.events = std::move(*events);
    fs::path expected = path;
    scenario.expected = parse_expectations(content_of(expected.replace_extension(".expect")));
    for (const auto& words : scenario.expected) {
      if (words[0] == "device" && words.size() > 1) scenario.device = words[1];
    }
    all.push_back(std::move(scenario));
  }
  return all;
}

std::string check_expectation(const std::vector<std::string>& words, const ScenarioResult& result) {
  const auto found = kinds().find(words[0]);
  if (found == kinds().end()) return "nothing is known of " + words[0];
  if (words.size() != found->second.words) return "wrong number of words";
  return found->second.check(result, words);
}

}  // namespace felt
