#include <unistd.h>

#include <memory>

#include "commands.h"
#include "felt/devices/simulated/simulated_stylus.h"
#include "felt/io/ndjson/json_text.h"
#include "felt/replay/real_device.h"
#include "felt/validate/driver_subject.h"
#include "felt/validate/simulated_subject.h"
#include "felt/validate/validator.h"
#include "interrupt.h"
#include "output.h"
#include "print.h"
#include "text_table.h"

namespace felt::cli {
namespace {

struct DeviceTestArguments {
  std::string name;
  int level = 10;
  std::uint64_t seed = 1;
  std::string report;
  double soak_s = 60.0;
  bool yes = false;
  bool json = false;
};

/// The user at the terminal. With `agrees_to_all` (--yes) no questions are asked, and if stdin is
/// no terminal, tasks that need hands on cables are skipped.
class ConsolePerson final : public TestPerson {
 public:
  explicit ConsolePerson(bool agrees_to_all) : agrees_to_all_(agrees_to_all) {}
  bool does(PersonTask task, const std::string& words) override {
    const bool is_consent = task == PersonTask::kAgreeToForces || task == PersonTask::kFindHome;
    const bool needs_hands = task == PersonTask::kUnplug || task == PersonTask::kReplug;
    say("\n{}\n", wrapped(words, 80, 0));
    if (agrees_to_all_) return !needs_hands || somebody_is_there();
    return ask(is_consent ? "Do you agree?" : "Ready?");
  }

 private:
  bool agrees_to_all_;
};

constexpr const char* kDeviceTestExamples =
    "feltline device-test openhaptics:default --level 4\n"
    "feltline device-test forcedimension:2 --report test.txt\n"
    "feltline device-test touch\n"
    "feltline device-test premium --level 6 --seed 7 --json";

std::string report_json(const ValidationReport& report) {
  std::vector<std::string> checks;
  for (const CheckResult& check : report.checks) {
    JsonObject object;
    object.add_text("id", check.id);
    object.add_number("level", check.level);
    object.add_text("title", check.title);
    static constexpr const char* kVerdicts[] = {"passed", "failed", "not_possible", "not_run"};
    object.add_text("verdict", kVerdicts[static_cast<std::size_t>(check.verdict) % 4]);
    object.add_text("measured", check.measured);
    object.add_text("words", check.words);
    checks.push_back(object.text());
  }
  JsonObject all;
  all.add_text("device", report.device.id);
  all.add_text("label", report.device.label);
  all.add_text("serial", report.device.serial);
  all.add_text("version", report.device.version);
  all.add_text("program", report.program);
  all.add_text("time", report.loop);
  all.add_raw("seed", std::to_string(report.seed));
  all.add_number("level", report.level);
  all.add_bool("interrupted", report.was_interrupted);
  all.add_raw("passed", report.passed() ? "true" : "false");
  all.add_raw("checks", json_array(checks));
  return all.text() + "\n";
}

ValidationOptions test_options_of(const DeviceTestArguments& args) {
  ValidationOptions options;
  options.program = "feltline " FELT_VERSION;
  options.level = args.level;
  options.seed = args.seed;
  options.soak_s = args.soak_s;
  options.is_cancelled = Interrupt::was_asked;
  if (isatty(STDERR_FILENO) != 0) {
    options.on_begin = [](const CheckResult& check) {
      say("level {}: {} ...\n", check.level, check.title);
    };
  }
  return options;
}

ValidationReport test_simulated(const StylusPreset& preset, const DeviceTestArguments& args) {
  SimulatedStylus stylus(preset);
  DeviceDescriptor device;
  device.id = std::string(preset.name);
  device.driver = "simulated";
  device.label = std::string(preset.label) + ", simulated";
  device.capabilities = preset.capabilities;
  SimulatedSubject subject(stylus, stylus, device);
  VirtualTestLoop loop([&subject](std::int64_t now_ns) { subject.before_tick(now_ns); });
  return validate(subject, loop, subject, test_options_of(args));
}

Result<ValidationReport> test_real(const DeviceTestArguments& args) {
  const std::vector<std::unique_ptr<Driver>> drivers = make_drivers();
  const Result<RealDevice> device = find_real_device(drivers, args.name);
  if (!device) return tl::unexpected(device.error());
  DriverSubject subject(*device->driver, device->found, OpenOptions(), device->profile);
  ThreadTestLoop loop;
  ConsolePerson person(args.yes);
  return validate(subject, loop, person, test_options_of(args));
}

Result<void> write_report(const std::string& path, const ValidationReport& report) {
  Result<Output> output = Output::create(path);
  if (!output) return tl::unexpected(output.error());
  const std::string text = path.ends_with(".json") ? report_json(report) : report_text(report);
  if (Result<void> written = output->write(text); !written) return written;
  return output->commit();
}

void run_device_test(const DeviceTestArguments& args, Console& console) {
  const Interrupt interrupt;
  const StylusPreset* const preset = find_stylus_preset(args.name);
  const Result<ValidationReport> report =
      preset != nullptr ? Result<ValidationReport>(test_simulated(*preset, args)) : test_real(args);
  if (!report) return console.error(report.error().message);
  print("{}", args.json ? report_json(*report) : report_text(*report));
  if (!report->passed()) console.set_failed();
  if (args.report.empty()) return;
  if (Result<void> written = write_report(args.report, *report); !written) {
    console.error(written.error().message);
  }
}

}  // namespace

void add_device_test_command(CLI::App& app, Console& console) {
  CLI::App* command = app.add_subcommand(
      "device-test", "Test a device, level by level, and report what was measured");
  const auto args = std::make_shared<DeviceTestArguments>();
  command
      ->add_option("NAME", args->name, "A real or simulated device that 'feltline devices' lists")
      ->required();
  command
      ->add_option("--level", args->level,
                   "Run levels 1 to N: 1 opening, 2 identity, 3 rate, 4 positions, 5 forces, 6 a "
                   "step, 7 limits, 8 watchdog, 9 unplugging, 10 soak")
      ->check(CLI::Range(1, 10))
      ->capture_default_str();
  command->add_option("--seed", args->seed, "Seed of the order of axes in the checks that push")
      ->check(whole_number())
      ->capture_default_str();
  command->add_option("--report", args->report,
                      "Also write the report to this file: text, or .json");
  command->add_option("--soak", args->soak_s, "Duration of level 10 in seconds")
      ->check(number_between(1.0, 86'400.0))
      ->capture_default_str();
  command->add_flag("--yes", args->yes,
                    "Do not ask: you agree to forces up to 0.3 N, and that the arm may move");
  command->add_flag("--json", args->json, "Print the report as one line of JSON");
  command->footer(
      "From level 5 on the device pushes, with at most 0.3 N, and only after you agreed.\n"
      "Ctrl-C switches the force off and reports the results so far.\n"
      "Exit code: 0 if nothing failed, 1 if something failed or the test was interrupted.\n" +
      examples(kDeviceTestExamples));
  command->callback([args, &console] { run_device_test(*args, console); });
}

}  // namespace felt::cli
