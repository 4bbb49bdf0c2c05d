#include "felt/validate/validation_report.h"

#include <algorithm>

namespace felt {
namespace {

std::string padded(std::string_view text, std::size_t width) {
  return std::string(text) + std::string(width - std::min(width, text.size()), ' ');
}

std::string count_words(const ValidationReport& report) {
  const auto count = [&report](Verdict verdict) {
    return std::count_if(report.checks.begin(), report.checks.end(),
                         [verdict](const CheckResult& check) { return check.verdict == verdict; });
  };
  std::string words;
  for (const auto& [verdict, name] :
       {std::pair{Verdict::kPassed, "passed"}, std::pair{Verdict::kFailed, "failed"},
        std::pair{Verdict::kNotPossible, "not possible"}, std::pair{Verdict::kNotRun, "not run"}}) {
    if (count(verdict) == 0) continue;
    words += (words.empty() ? "" : ", ") + std::to_string(count(verdict)) + " " + name;
  }
  return words;
}

void add_line(std::string& text, const char* name, const std::string& value) {
  if (!value.empty()) text += padded(name, 9) + value + "\n";
}

}  // namespace

std::string_view name_of(Verdict verdict) noexcept {
  switch (verdict) {
    case Verdict::kPassed:
      return "pass";
    case Verdict::kFailed:
      return "FAIL";
    case Verdict::kNotPossible:
      return "not possible";
    case Verdict::kNotRun:
      return "not run";
  }
  return "";
}

bool ValidationReport::passed() const noexcept {
  return !was_interrupted &&
         std::none_of(checks.begin(), checks.end(),
                      [](const CheckResult& check) { return check.verdict == Verdict::kFailed; });
}

std::string report_text(const ValidationReport& report) {
  std::string text = "Device test: " + report.device.label + "\n";
  add_line(text, "device", report.device.id);
  add_line(text, "serial", report.device.serial);
  add_line(text, "version", report.device.version);
  add_line(text, "program", report.program);
  add_line(text, "time", report.loop);
  add_line(text, "seed",
           std::to_string(report.seed) + ", levels 1 to " + std::to_string(report.level));
  std::size_t title = 0;
  for (const CheckResult& check : report.checks) title = std::max(title, check.title.size());
  text += "\n";
  for (const CheckResult& check : report.checks) {
    text += padded(std::to_string(check.level), 3) + padded(name_of(check.verdict), 14);
    text += check.measured.empty() ? check.title : padded(check.title, title + 2) + check.measured;
    text += "\n";
    if (!check.words.empty()) text += "   -> " + check.words + "\n";
  }
  text += "\n";
  if (report.was_interrupted) text += "The test was interrupted; forces are off.\n";
  return text + count_words(report) + ".\n";
}

}  // namespace felt
