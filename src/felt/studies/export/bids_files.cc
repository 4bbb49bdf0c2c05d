#include "felt/studies/export/bids_files.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <string_view>

#include "felt/base/csv_value.h"
#include "felt/haptics/pen_sample.h"
#include "felt/io/ndjson/json_text.h"
#include "felt/studies/export/data_table.h"

namespace felt {
namespace {

constexpr double kNanosecondsPerSecond = 1e9;

struct MotionChannel {
  const char* name;
  const char* component;
  const char* type;
  const char* unit;
  const char* description;
};
constexpr std::array<MotionChannel, 9> kMotionChannels = {{
    {"latency", "n/a", "LATENCY", "s", "Time since the first sample"},
    {"pen_x", "x", "POS", "mm", "Position on the page, to the right"},
    {"pen_y", "y", "POS", "mm", "Position on the page, towards the user"},
    {"pen_z", "z", "POS", "mm", "Height above the surface; negative if the pen presses"},
    {"contact", "n/a", "MISC", "n/a", "1 if the pen touches the surface, else 0"},
    {"pressure", "n/a", "MISC", "n/a", "Pressure, 0 to 1"},
    {"force_x", "x", "MISC", "N", "Force that was sent to the device"},
    {"force_y", "y", "MISC", "N", "Force that was sent to the device"},
    {"force_z", "z", "MISC", "N", "Force that was sent to the device"},
}};
constexpr std::size_t kPositionChannels = 3, kMiscChannels = 5;

/// Returns a value of a table: BIDS separates values by tabs, and has n/a for a missing one. Like
/// trials.csv, it holds nothing that a spreadsheet computes.
std::string tsv_value(std::string_view text) {
  if (text.empty()) return "n/a";
  std::string out;
  for (const char c : spreadsheet_text(text)) out += c == '\t' || c == '\n' || c == '\r' ? ' ' : c;
  return out;
}

std::string tsv_line(const std::vector<std::string>& values) {
  std::string line;
  for (const std::string& value : values) line += (line.empty() ? "" : "\t") + tsv_value(value);
  return line + "\n";
}

/// Appends a number with a fixed number of decimals.
void append_fixed(std::string& out, double value, int digits) {
  std::array<char, 64> text{};
  out.append(text.data(), std::to_chars(text.data(), text.data() + text.size(), value,
                                        std::chars_format::fixed, digits)
                              .ptr);
}

/// Appends three values, each after a tab.
void append_three(std::string& out, double x, double y, double z) {
  for (const double value : {x, y, z}) {
    out += '\t';
    append_fixed(out, value, 4);
  }
}

std::string with_zeros(std::size_t number, std::size_t digits) {
  const std::string text = std::to_string(number);
  return std::string(digits > text.size() ? digits - text.size() : 0, '0') + text;
}

std::string subject_of(const SessionInfo& info) {
  return "sub-" + with_zeros(static_cast<std::size_t>(info.participant), 4);
}

std::string motion_text(const FeltRecording& recording) {
  std::string out;
  const std::int64_t start = recording.samples.empty() ? 0 : recording.samples.front().time_ns;
  for (const RecordedSample& sample : recording.samples) {
    const Vec3 position = sample.pen.position;
    append_fixed(out, static_cast<double>(sample.time_ns - start) / kNanosecondsPerSecond, 6);
    append_three(out, position.x, position.y, position.z);
    out += in_contact(sample_of(sample.time_ns, sample.pen)) ? "\t1\t" : "\t0\t";
    if (sample.pen.pressure) {
      append_fixed(out, *sample.pen.pressure, 4);
    } else {
      out += "n/a";
    }
    if (sample.forces) {
      const Force force = sample.forces->sent;
      append_three(out, force.x, force.y, force.z);
    } else {
      out += "\tn/a\tn/a\tn/a";
    }
    out += '\n';
  }
  return out;
}

std::string channels_text(double rate_hz) {
  std::string out = tsv_line(
      {"name", "component", "type", "tracked_point", "units", "sampling_frequency", "description"});
  for (const MotionChannel& channel : kMotionChannels) {
    out += tsv_line({channel.name, channel.component, channel.type, "pen", channel.unit,
                     json_number(rate_hz), channel.description});
  }
  return out;
}

double seconds_of(const FeltRecording& recording) {
  if (recording.samples.empty()) return 0.0;
  return static_cast<double>(recording.samples.back().time_ns - recording.samples.front().time_ns) /
         kNanosecondsPerSecond;
}

std::string motion_json(const MeasuredTrial& trial, const FeltRecording& recording,
                        std::string_view task, double rate_hz) {
  const double seconds = seconds_of(recording);
  JsonObject object;
  object.add_text("TaskName", task);
  object.add_text("TaskDescription",
                  "The participant draws one shape in one condition of a study.");
  object.add_number("SamplingFrequency", rate_hz);
  if (seconds > 0.0) {
    object.add_number("SamplingFrequencyEffective",
                      static_cast<double>(recording.samples.size() - 1) / seconds);
  }
  object.add_number("RecordingDuration", seconds);
  object.add_text("RecordingType", "continuous");
  object.add_text("TrackingSystemName", "pen");
  object.add_text("ManufacturersModelName", trial.info.device);
  object.add_text("SoftwareVersions", trial.info.program);
  object.add_number("MotionChannelCount", static_cast<double>(kMotionChannels.size()));
  object.add_number("POSChannelCount", static_cast<double>(kPositionChannels));
  object.add_number("LATENCYChannelCount", 1);
  object.add_number("MISCChannelCount", static_cast<double>(kMiscChannels));
  object.add_number("TrackedPointsCount", 1);
  return object.text() + "\n";
}

/// The columns of events.tsv after onset and duration, under the names of trials.csv, with the
/// condition as trial_type.
constexpr std::array<std::string_view, 8> kEventColumns = {
    "condition", "shape", "block", "trial", "attempt", "is_practice", "valid", "recording"};

std::string event_name(std::string_view column) {
  return std::string(column == "condition" ? "trial_type" : column);
}

std::vector<DataColumn<MeasuredTrial>> event_columns(const StudyResults& results) {
  std::vector<DataColumn<MeasuredTrial>> columns;
  for (const DataColumn<MeasuredTrial>& column : trial_columns(results)) {
    const auto* const found =
        std::find(kEventColumns.begin(), kEventColumns.end(), column.info.name);
    if (found != kEventColumns.end()) columns.push_back(column);
  }
  for (DataColumn<MeasuredTrial>& column : columns) column.info.name = event_name(column.info.name);
  return columns;
}

std::string events_text(const StudyResults& results, const MeasuredTrial& trial, double seconds) {
  std::vector<std::string> names = {"onset", "duration"};
  std::vector<std::string> values = {"0", json_number(seconds)};
  for (const DataColumn<MeasuredTrial>& column : event_columns(results)) {
    names.push_back(column.info.name);
    values.push_back(column.text(trial));
  }
  return tsv_line(names) + tsv_line(values);
}

std::string_view task_of(const StudyResults& results, const MeasuredTrial& trial) {
  return kStudyTasks[static_cast<std::size_t>(results.shape_of(trial.plan).task)];
}

std::string participants_text(const StudyResults& results) {
  std::string out = tsv_line({"participant_id", "person_seed", "person_model"});
  std::map<std::string, SessionInfo> people;
  for (const MeasuredTrial& trial : results.trials) people[subject_of(trial.info)] = trial.info;
  for (const auto& [subject, info] : people) {
    const std::string seed = info.person_seed ? std::to_string(*info.person_seed) : "";
    out += tsv_line({subject, seed, info.person_model});
  }
  return out;
}

std::string description_json(const StudyResults& results) {
  JsonObject program;
  program.add_text("Name", "Feltline");
  if (!results.trials.empty()) program.add_text("Version", results.trials.front().info.program);
  JsonObject object;
  object.add_text("Name", results.files.study.label);
  object.add_text("BIDSVersion", "1.9.0");
  object.add_text("DatasetType", "raw");
  object.add_raw("GeneratedBy", json_array({program.text()}));
  return object.text() + "\n";
}

}  // namespace

std::vector<ExportFile> bids_run_files(const StudyResults& results, const MeasuredTrial& trial,
                                       const FeltRecording& recording, std::size_t run) {
  const std::string subject = subject_of(trial.info);
  const std::string session =
      "ses-" + std::string(kSessionKinds[static_cast<std::size_t>(trial.plan.session)]);
  const std::string_view task = task_of(results, trial);
  const std::string name = subject + "/" + session + "/motion/" + subject + "_" + session +
                           "_task-" + std::string(task) + "_tracksys-pen_run-" +
                           with_zeros(run, 3) + "_";
  const double rate_hz = std::round(
      kNanosecondsPerSecond / static_cast<double>(std::max<std::int64_t>(recording.period_ns, 1)));
  return {{name + "motion.tsv", motion_text(recording)},
          {name + "motion.json", motion_json(trial, recording, task, rate_hz)},
          {name + "channels.tsv", channels_text(rate_hz)},
          {name + "events.tsv", events_text(results, trial, seconds_of(recording))}};
}

std::vector<ExportFile> bids_dataset_files(const StudyResults& results) {
  std::vector<ColumnInfo> events = infos_of(event_columns(results));
  const std::vector<ColumnInfo> participants = {
      {"person_seed", "Seed of the simulated person; n/a for a real person."},
      {"person_model", "Model of the simulated person; n/a for a real person."}};
  std::vector<ExportFile> files = {
      {"dataset_description.json", description_json(results)},
      {"README",
       "Movements of the pen in the study \"" + results.files.study.label +
           "\".\n\nEach run is one attempt of a trial; its events.tsv says which one. The table "
           "trials.csv,\nwhich was exported with this data set, has the metrics of all trials.\n"},
      {"participants.tsv", participants_text(results)},
      {"participants.json", dictionary_text(participants)}};
  std::set<std::string_view> tasks;
  for (const MeasuredTrial& trial : results.trials) tasks.insert(task_of(results, trial));
  for (const std::string_view task : tasks) {
    files.push_back({"task-" + std::string(task) + "_events.json", dictionary_text(events)});
  }
  return files;
}

}  // namespace felt
