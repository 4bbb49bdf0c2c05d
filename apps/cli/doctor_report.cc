#include "doctor_report.h"

#include <fmt/core.h>

#include <algorithm>

#include "felt/io/ndjson/json_text.h"

namespace felt::cli {
namespace {

constexpr std::size_t kTextColumn = 9;  // column at which sentences begin, after the mark
constexpr std::size_t kPlainWidth = 80;
constexpr std::size_t kWidest = 100;

struct Mark {
  const char* word;
  const char* color;  // SGR
};

Mark mark_of(FindingLevel level) {
  switch (level) {
    case FindingLevel::kOk:
      return {"fine", "32"};
    case FindingLevel::kAbsent:
      return {"none", "2"};
    case FindingLevel::kWarning:
      return {"better", "33"};
    case FindingLevel::kProblem:
      return {"MEND", "1;31"};
  }
  return {"", "0"};
}

std::string marked(const Mark& mark, const TextStyle& style) {
  const std::string word = mark.word;
  const std::string blanks(kTextColumn - 2 - word.size(), ' ');
  return "  " + (style.emphasis ? fmt::format("\x1b[{}m{}\x1b[0m", mark.color, word) : word) +
         blanks;
}

std::size_t width_of(const TextStyle& style) {
  return style.width == 0 ? kPlainWidth : std::min(style.width, kWidest);
}

/// Returns a wrapped sentence for a line that is already filled up to `column`.
std::string sentence(const std::string& text, std::size_t column, const TextStyle& style) {
  const std::size_t width = std::max<std::size_t>(width_of(style), column + 24) - column;
  return wrapped(text, width, column) + "\n";
}

/// Indents each line to `column` and leaves its text unchanged. Omits a line that repeats the
/// previous one.
std::string verbatim(const std::string& text, std::size_t column) {
  std::string lines, last;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string line = std::string(column, ' ') + text.substr(at, end - at) + "\n";
    if (line != last) lines += line;
    last = std::move(line);
    at = end + 1;
  }
  return lines;
}

std::string step_text(const std::string& step, const std::string& number, const TextStyle& style) {
  const std::size_t column = kTextColumn + number.size();
  const std::size_t end = std::min(step.find('\n'), step.size());
  std::string text = std::string(kTextColumn, ' ') + number;
  text += sentence(step.substr(0, end), column, style);
  if (end < step.size()) text += verbatim(step.substr(end + 1), column + 2);
  return text;
}

std::string finding_text(const Finding& finding, const TextStyle& style) {
  std::string text = marked(mark_of(finding.level), style);
  text += sentence(finding.what, kTextColumn, style);
  if (!finding.details.empty()) {
    text += std::string(kTextColumn, ' ') + "Details:\n";
    text += verbatim(finding.details, kTextColumn + 2);
  }
  const bool is_numbered = finding.steps.size() > 1;
  for (std::size_t i = 0; i < finding.steps.size(); ++i) {
    text += step_text(finding.steps[i], is_numbered ? fmt::format("{}. ", i + 1) : "", style);
  }
  return text;
}

bool has(const std::vector<Finding>& findings, FindingLevel level) {
  return std::any_of(findings.begin(), findings.end(),
                     [level](const Finding& finding) { return finding.level == level; });
}

bool is_absent(const DriverReport& look) {
  return look.devices.empty() &&
         std::all_of(look.findings.begin(), look.findings.end(),
                     [](const Finding& finding) { return finding.level == FindingLevel::kAbsent; });
}

std::string device_words(const DeviceDescriptor& device) {
  std::string words = device.label + ", " + device.id;
  if (!device.serial.empty()) words += ", serial number " + device.serial;
  if (!device.version.empty()) words += ", version " + device.version;
  return words;
}

std::string section(const std::string& title, const std::vector<Finding>& findings,
                    const std::vector<DeviceDescriptor>& devices, const TextStyle& style) {
  std::string text = heading(title, style) + "\n";
  for (const DeviceDescriptor& device : devices) {
    text += marked({device.is_connected ? "here" : "ask", "1"}, style);
    text += sentence(device.is_connected
                         ? device_words(device) + "."
                         : device_words(device) + ": open it to check whether it is connected.",
                     kTextColumn, style);
    if (!device.is_connected) {
      text += verbatim("feltline device-test --level 1 " + device.id, kTextColumn + 2);
    }
  }
  for (const FindingLevel level :
       {FindingLevel::kProblem, FindingLevel::kWarning, FindingLevel::kOk, FindingLevel::kAbsent}) {
    for (const Finding& finding : findings) {
      if (finding.level == level) text += finding_text(finding, style);
    }
  }
  return text + "\n";
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  }
  return text;
}

/// Returns a paragraph about the families of devices that are not on this computer.
std::string absent_text(const DoctorReport& report, const TextStyle& style) {
  if (report.is_named) return {};
  std::size_t longest = 0;
  const DriverReport* first = nullptr;
  for (const DriverReport& look : report.drivers) {
    if (!is_absent(look)) continue;
    longest = std::max(longest, look.name.size());
    if (first == nullptr) first = &look;
  }
  if (first == nullptr) return {};
  std::string text = heading("Not on this computer", style) + "\n";
  for (const DriverReport& look : report.drivers) {
    if (is_absent(look)) text += fmt::format("  {:<{}}  {}\n", look.name, longest, look.label);
  }
  text += sentence(
      "That is fine unless you own such a device. If you do, ask for it by its name, and "
      "the next steps are shown:",
      0, style);
  return text + verbatim("feltline doctor " + first->name, 2);
}

std::string findings_json(const std::vector<Finding>& findings) {
  std::vector<std::string> all;
  for (const Finding& finding : findings) {
    JsonObject object;
    static constexpr const char* kLevels[] = {"ok", "absent", "warning", "problem"};
    object.add_text("level", kLevels[static_cast<std::size_t>(finding.level) % 4]);
    object.add_text("what", finding.what);
    object.add_text("details", finding.details);
    std::vector<std::string> steps;
    for (const std::string& step : finding.steps) steps.push_back(json_string(step));
    object.add_raw("steps", json_array(steps));
    if (finding.fix) {
      JsonObject fix;
      fix.add_text("path", finding.fix->path);
      fix.add_text("content", finding.fix->content);
      fix.add_text("activate", finding.fix->activate);
      object.add_raw("fix", fix.text());
    }
    all.push_back(object.text());
  }
  return json_array(all);
}

}  // namespace

std::size_t count_problems(const DoctorReport& report) {
  const auto count = [](const std::vector<Finding>& findings) {
    return static_cast<std::size_t>(std::count_if(
        findings.begin(), findings.end(),
        [](const Finding& finding) { return finding.level == FindingLevel::kProblem; }));
  };
  std::size_t problems = count(report.machine);
  for (const DriverReport& look : report.drivers) problems += count(look.findings);
  return problems;
}

std::string doctor_summary(const DoctorReport& report) {
  std::vector<std::string> ready, unknown;
  for (const DriverReport& look : report.drivers) {
    if (has(look.findings, FindingLevel::kProblem)) continue;
    for (const DeviceDescriptor& device : look.devices) {
      (device.is_connected ? ready : unknown).push_back(device.label);
    }
  }
  const std::size_t problems = count_problems(report);
  std::string text;
  if (!ready.empty()) text = "Ready to draw with: " + joined(ready) + ". ";
  if (problems > 0) {
    return text +
           (problems == 1
                ? "One thing needs fixing. It is marked MEND below, with instructions."
                : fmt::format(
                      "{} things need fixing. They are marked MEND below, with instructions.",
                      problems));
  }
  if (ready.empty() && !unknown.empty()) {
    return "Possibly connected: " + joined(unknown) + " (open it to check). Nothing needs fixing.";
  }
  if (!ready.empty()) return text + "Nothing needs fixing.";
  if (report.is_named) return "No such device is connected.";
  return "No haptic device is connected. You can draw with mouse and tablet; nothing needs fixing.";
}

std::string doctor_text(const DoctorReport& report, const TextStyle& style) {
  std::string text = sentence(doctor_summary(report), 0, style) + "\n";
  const auto families = [&](bool with_problems) {
    for (const DriverReport& look : report.drivers) {
      if (!report.is_named && is_absent(look)) continue;
      if (has(look.findings, FindingLevel::kProblem) != with_problems) continue;
      text += section(look.label + " - " + look.name, look.findings, look.devices, style);
    }
  };
  families(true);
  const bool machine_first = has(report.machine, FindingLevel::kProblem);
  if (machine_first) text += section("This computer", report.machine, {}, style);
  families(false);
  if (!machine_first && !report.machine.empty()) {
    text += section("This computer", report.machine, {}, style);
  }
  text += absent_text(report, style);
  while (text.ends_with("\n\n")) text.pop_back();
  return text;
}

std::string doctor_json(const DoctorReport& report) {
  std::vector<std::string> drivers;
  for (const DriverReport& look : report.drivers) {
    JsonObject object;
    object.add_text("name", look.name);
    object.add_text("label", look.label);
    std::vector<std::string> devices;
    for (const DeviceDescriptor& device : look.devices) {
      JsonObject entry;
      entry.add_text("id", device.id);
      entry.add_text("label", device.label);
      entry.add_text("serial", device.serial);
      entry.add_text("version", device.version);
      entry.add_raw("connected", device.is_connected ? "true" : "null");
      devices.push_back(entry.text());
    }
    object.add_raw("devices", json_array(devices));
    object.add_raw("findings", findings_json(look.findings));
    drivers.push_back(object.text());
  }
  JsonObject all;
  all.add_text("summary", doctor_summary(report));
  all.add_number("problems", static_cast<double>(count_problems(report)));
  all.add_raw("machine", findings_json(report.machine));
  all.add_raw("drivers", json_array(drivers));
  return all.text() + "\n";
}

}  // namespace felt::cli
