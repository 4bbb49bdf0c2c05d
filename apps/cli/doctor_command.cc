#include <unistd.h>

#include <memory>

#include "commands.h"
#include "doctor_report.h"
#include "felt/devices/drivers.h"
#include "felt/driver/machine_checks.h"
#include "print.h"
#include "system_fix.h"

namespace felt::cli {
namespace {

struct DoctorArguments {
  std::vector<std::string> drivers;
  bool json = false;
  bool fix = false;
  bool dry_run = false;
  bool yes = false;
  std::string prefix;
};

constexpr const char* kDoctorExamples =
    "feltline doctor\n"
    "feltline doctor openhaptics\n"
    "feltline doctor --fix --dry-run\n"
    "feltline doctor --fix";

/// Returns the drivers that the user named, or all drivers.
std::vector<std::unique_ptr<Driver>> wanted_drivers(const std::vector<std::string>& names) {
  std::vector<std::unique_ptr<Driver>> all = make_drivers();
  if (names.empty()) return all;
  std::vector<std::unique_ptr<Driver>> wanted;
  for (auto& driver : all) {
    if (std::find(names.begin(), names.end(), driver->name()) != names.end()) {
      wanted.push_back(std::move(driver));
    }
  }
  return wanted;
}

std::vector<std::string> driver_names() {
  std::vector<std::string> names;
  for (const auto& driver : make_drivers()) names.emplace_back(driver->name());
  return names;
}

DoctorReport examine(const DoctorArguments& args) {
  DoctorReport report;
  report.is_named = !args.drivers.empty();
  report.drivers =
      query_drivers(wanted_drivers(args.drivers), this_system(), DriverQuery::kFindings);
  if (!report.is_named) report.machine = diagnose_machine(this_system());
  return report;
}

/// Returns true if this file may be written. For a file that Feltline did not write, asks the user
/// separately.
bool is_agreed(const PlannedFix& fix, bool agreed_to_all, Console& console) {
  if (fix.state == PlannedFix::State::kSame) return false;
  if (fix.state != PlannedFix::State::kForeign) return agreed_to_all;
  if (ask("Replace " + fix.path + ", which Feltline did not write?")) return true;
  console.error(fix.path + ": not changed, because Feltline did not write it");
  return false;
}

void say_that_nothing_is_missing() {
  print("Feltline cannot repair anything here by writing a file.\n");
  if (geteuid() != 0) return;
  print(
      "Root already has every permission. Run this as the user who draws; it asks for root "
      "permission when it needs it.\n");
}

void fix(const DoctorReport& report, const DoctorArguments& args, Console& console) {
  const Result<std::vector<PlannedFix>> plan = plan_fixes(report, this_system(), args.prefix);
  if (!plan) return console.error(plan.error().message);
  const bool is_done = std::all_of(plan->begin(), plan->end(), [](const PlannedFix& fix) {
    return fix.state == PlannedFix::State::kSame;
  });
  print("{}", plan_text(*plan));
  if (is_done) return say_that_nothing_is_missing();
  if (args.dry_run) {
    print("Nothing was written (--dry-run).\n");
    return;
  }
  std::fflush(stdout);
  if (!args.yes && !somebody_is_there()) {
    return console.error(
        "nothing was written, because consent can be asked only in a terminal; use --yes to agree");
  }
  const bool agreed = args.yes || ask("Write this?");
  std::vector<PlannedFix> written;
  for (const PlannedFix& next : *plan) {
    if (!is_agreed(next, agreed, console)) continue;
    if (Result<void> done = write_fix(next, !args.prefix.empty()); !done) {
      return console.error(done.error().message);
    }
    written.push_back(next);
  }
  if (written.empty()) {
    print("Nothing was written.\n");
    return;
  }
  if (Result<void> done = activate_fixes(written); !done) console.error(done.error().message);
  for (const PlannedFix& next : written) print("Written: {}\n", next.path);
  print("Unplug the device and plug it in again, then run 'feltline doctor' once more.\n");
}

void run_doctor(const DoctorArguments& args, Console& console) {
  if ((args.dry_run || args.yes || !args.prefix.empty()) && !args.fix) {
    throw UsageError("--dry-run, --yes and --prefix can only be used with --fix");
  }
  if (args.fix && args.json) throw UsageError("--fix cannot be used with --json");
  const DoctorReport report = examine(args);
  if (args.fix) return fix(report, args, console);
  print("{}", args.json ? doctor_json(report) : doctor_text(report, TextStyle::of_stdout()));
  if (count_problems(report) > 0) console.set_failed();
}

}  // namespace

void add_doctor_command(CLI::App& app, Console& console) {
  CLI::App* command =
      app.add_subcommand("doctor", "Check what haptic devices need on this computer");
  const auto args = std::make_shared<DoctorArguments>();
  command->add_option("DRIVER", args->drivers, "Check only these, and show all details")
      ->check(CLI::IsMember(driver_names()));
  command->add_flag("--json", args->json, "One line of JSON");
  command->add_flag("--fix", args->fix,
                    "Write the missing permissions (udev rules, limits), after asking");
  command->add_flag("--dry-run", args->dry_run, "With --fix: only show what it would write");
  command->add_flag("--yes", args->yes, "With --fix: do not ask");
  command->add_option("--prefix", args->prefix,
                      "With --fix: write the files below this folder instead of the system's");
  command->footer("Exit code: 0 if nothing needs fixing, 1 otherwise.\n" +
                  examples(kDoctorExamples));
  command->callback([args, &console] { run_doctor(*args, console); });
}

}  // namespace felt::cli
