#include "tests/devices/drivers/scenario_suite.h"

#include <algorithm>
#include <charconv>

#include "felt/base/constants.h"
#include "felt/geometry/rect.h"
#include "tests/devices/drivers/bench_device.h"
#include "tests/devices/drivers/ink_difference.h"

namespace felt {
namespace {

constexpr std::int64_t kLeadInNs = 700 * kMs;
constexpr int kSlower = 2;
constexpr double kSuiteMarginMm = 6.0;
constexpr double kSuiteHoverMm = 5.0;

const Vec3* place_of(const Event& event) {
  if (const auto* pen = std::get_if<PenEvent>(&event.what)) return &pen->position;
  if (const auto* hand = std::get_if<HandEvent>(&event.what)) return &hand->target;
  return nullptr;
}

/// Returns the hand's event for an event of the script's pen.
HandEvent by_hand(const PenEvent& pen) {
  const double pressure = pen.pressure.value_or(0.3);
  const bool touches = pen.position.z < 0.0 || pen.pressure.value_or(0.0) > 0.0;
  Vec3 aim = pen.position;
  aim.z = touches ? -1.5 - 4.0 * pressure : std::max(aim.z, kSuiteHoverMm);
  return {aim, {}, pen.buttons};
}

void fit_into(HandScript& script, const Capabilities& device) {
  Rect box;
  for (const Event& event : script.events) {
    if (const Vec3* at = place_of(event)) box.extend(Point{at->x, at->y});
  }
  if (box.empty()) return;
  const Rect space{device.workspace_min.x + kSuiteMarginMm, device.workspace_min.y + kSuiteMarginMm,
                   device.workspace_max.x - kSuiteMarginMm,
                   device.workspace_max.y - kSuiteMarginMm};
  const auto covers = [](double low, double high, double from, double to) {
    return low <= from && to <= high;
  };
  if (covers(space.x0, space.x1, box.x0, box.x1) && covers(space.y0, space.y1, box.y0, box.y1)) {
    return;
  }
  script.scale = std::min({1.0, space.width() / std::max(box.width(), 1.0),
                           space.height() / std::max(box.height(), 1.0)});
  script.shift = {0.5 * (space.x0 + space.x1) - script.scale * 0.5 * (box.x0 + box.x1),
                  0.5 * (space.y0 + space.y1) - script.scale * 0.5 * (box.y0 + box.y1)};
  for (Event& event : script.events) {
    if (auto* hand = std::get_if<HandEvent>(&event.what)) {
      hand->target.x = script.scale * hand->target.x + script.shift.x;
      hand->target.y = script.scale * hand->target.y + script.shift.y;
    }
  }
}

ScenarioResult play(Device& device, HandInput& hand, const std::vector<Event>& events,
                    std::string& broken) {
  Result<ScenarioResult> result = play_scenario_on(device, hand, events, {});
  if (result) return *std::move(result);
  broken = "it cannot be played: " + result.error().message;
  return {};
}

/// Places the pen at the first position of the hand, so that no device begins with a movement.
void place(SimulatedStylus& stylus, const std::vector<Event>& events) {
  for (const Event& event : events) {
    if (const Vec3* at = place_of(event)) return stylus.place(*at);
  }
}

ScenarioResult play_bench(const BenchMaker& make, const std::vector<Event>& events,
                          std::string& broken) {
  const auto bench = make({});
  place(bench->world().stylus(), events);
  BenchDevice device(*bench);
  ScenarioResult result = play(device, bench->hand(), events, broken);
  const Capabilities& can = bench->device()->descriptor().capabilities;
  if (!bench->broken_rule().empty()) broken = std::string(bench->broken_rule());
  if (!(bench->largest_asked_n() <= 0.9 * can.max_force_n + 1e-9)) broken = "asked for too much";
  if (result.report.unread > 0) {
    broken = std::to_string(result.report.unread) + " ticks without a sample to believe";
  }
  if (bench->world().held_force() != Force{}) broken = "a force is held after the end";
  return result;
}

double number(const std::string& word) {
  double value = 0.0;
  std::from_chars(word.data(), word.data() + word.size(), value);
  return value;
}

/// Returns a line of the .expect file for a script that was moved; positions get a larger
/// tolerance.
std::vector<std::string> moved(std::vector<std::string> words, const HandScript& script,
                               double more_mm) {
  if (words[0] != "start" && words[0] != "end") return words;
  words[2] = std::to_string(script.scale * number(words[2]) + script.shift.x);
  words[3] = std::to_string(script.scale * number(words[3]) + script.shift.y);
  words[4] = std::to_string(number(words[4]) + more_mm);
  return words;
}

std::string joined(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : " ") + word;
  return line;
}

std::string compare(const ScenarioResult& plain, const ScenarioResult& driven, double tolerance_mm,
                    double& largest_mm) {
  const InkDifference d = ink_difference(plain.strokes, driven.strokes);
  if (!d.other.empty()) return "plain and driven: " + d.other;
  largest_mm = std::max({d.ends_mm, d.curve_mm, d.width_mm});
  const auto over = [tolerance_mm](const char* what, double mm) {
    return mm <= tolerance_mm ? std::string()
                              : std::string(what) + " differ by " + std::to_string(mm) + " mm";
  };
  for (const std::string& said :
       {over("ends", d.ends_mm), over("curves", d.curve_mm), over("widths", d.width_mm)}) {
    if (!said.empty()) return said;
  }
  if (plain.undo_count != driven.undo_count || plain.redo_count != driven.redo_count) {
    return "steps to undo and redo are " + std::to_string(driven.undo_count) + " and " +
           std::to_string(driven.redo_count) + ", not " + std::to_string(plain.undo_count) +
           " and " + std::to_string(plain.redo_count);
  }
  if (driven.report.safety.hard_faults != plain.report.safety.hard_faults) {
    return std::to_string(driven.report.safety.hard_faults) + " hard faults";
  }
  return "";
}

}  // namespace

HandScript hand_script(const Scenario& scenario, const Capabilities& page_capabilities) {
  HandScript script;
  const bool is_led = !scenario.has_hand();
  for (const Event& event : scenario.events) {
    Event& added = script.events.emplace_back(event);
    if (is_led) added.time_ns = kLeadInNs + kSlower * event.time_ns;
    if (const auto* pen = std::get_if<PenEvent>(&event.what)) added.what = by_hand(*pen);
  }
  fit_into(script, page_capabilities);
  if (!is_led) return script;
  const auto first = std::find_if(script.events.begin(), script.events.end(),
                                  [](const Event& event) { return place_of(event) != nullptr; });
  if (first == script.events.end()) return script;
  Vec3 above = *place_of(*first);
  above.z = std::max(above.z, kSuiteHoverMm);
  script.events.insert(script.events.begin(), Event{0, HandEvent{above, {}, 0}});
  return script;
}

ScenarioVerdict check_scenario(const Scenario& scenario, const BenchMaker& make) {
  ScenarioVerdict verdict;
  const auto bench = make({});
  if (!bench || bench->device() == nullptr) return {.broken = "it cannot be opened"};
  const StylusPreset preset = bench->world().preset();
  const HandScript script = hand_script(scenario, preset.capabilities);
  const double tolerance_mm = bench->tolerance_mm();

  const ScenarioResult driven = play_bench(make, script.events, verdict.broken);
  if (!verdict.broken.empty()) return verdict;
  const ScenarioResult again = play_bench(make, script.events, verdict.broken);
  if (driven.sketch_text != again.sketch_text || driven.ticks != again.ticks ||
      driven.recording != again.recording || !(driven.report == again.report)) {
    verdict.broken = "not the same bytes again";
    return verdict;
  }
  PlainDevice plain(*bench, preset, BenchDevice(*bench).capabilities());
  place(plain.stylus(), script.events);
  const ScenarioResult usual = play(plain, plain.stylus(), script.events, verdict.broken);
  if (verdict.broken.empty()) {
    verdict.broken = compare(usual, driven, tolerance_mm, verdict.difference_mm);
  }
  for (const auto& words : scenario.expected) {
    if (words[0] == "device") continue;
    ++verdict.lines;
    if (!check_expectation(moved(words, script, 0.0), usual).empty()) continue;
    ++verdict.expected;
    const std::string wrong = check_expectation(moved(words, script, tolerance_mm), driven);
    if (verdict.broken.empty() && !wrong.empty()) {
      verdict.broken = joined(words);
      verdict.broken += ": " + wrong;
    }
  }
  return verdict;
}

}  // namespace felt
