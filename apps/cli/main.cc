/// The command line program: `feltline COMMAND ...`.
/// Exit codes: 0 success, 1 a failure (described on stderr), 2 wrong usage.

#include <fmt/core.h>

#include <algorithm>
#include <csignal>
#include <exception>
#include <iostream>
#include <new>

#include "commands.h"
#include "felt/base/input_files.h"
#include "felt/base/printable.h"
#include "felt/base/standard_streams.h"
#include "print.h"

namespace felt::cli {
namespace {

constexpr const char* kDescription =
    "From raw pen samples to smooth variable-width curves.\n"
    "stdout carries data, stderr errors and progress; '-' stands for stdin or stdout.";

void add_commands(CLI::App& app, Console& console) {
  app.require_subcommand(1);
  app.fallthrough();
  app.set_help_flag("-h,--help", "Show this help and exit");
  app.set_version_flag("--version", "feltline " FELT_VERSION, "Show the version and exit");
  app.add_flag_callback(
      "-q,--quiet", [&console] { console.set_quiet(); },
      "Print only errors on stderr, no progress and no notices");
  app.add_flag_callback(
      "--strict", [&console] { console.set_strict(); },
      "Treat unsupported content as an error instead of a warning");
  app.footer(
      examples("feltline fit strokes.ndjson -o sketch.svg\n"
               "feltline render sketch.ndjson -o page.png --page A4\n"
               "feltline COMMAND --help"));
  add_fit_command(app, console);
  add_render_command(app, console);
  add_convert_command(app, console);
  add_gather_command(app, console);
  add_inbetween_command(app, console);
#ifdef FELT_SOLIDS
  add_inflate_command(app, console);
#endif
  add_steady_command(app, console);
  add_check_command(app, console);
  add_info_command(app, console);
  add_formats_command(app);
  add_recover_command(app, console);
  add_replay_command(app, console);
  add_timelapse_command(app, console);
  add_demo_command(app, console);
  add_paper_command(app, console);
  add_tools_command(app, console);
  add_materials_command(app, console);
  add_devices_command(app, console);
  add_doctor_command(app, console);
  add_device_test_command(app, console);
  add_record_command(app, console);
  add_trial_command(app, console);
  add_bench_command(app, console);
}

/// Throws a usage error for an unknown command. This is needed because CLI11 itself reports that
/// the command is missing.
void check_command_name(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->check_name(argv[1])) return;
  }
  throw UsageError(fmt::format("there is no command '{}'", argv[1]));
}

/// Returns the lines of an error. Control characters are escaped, because the lines contain text
/// from the command line and from files.
std::string usage_text(const CLI::Error& error) {
  std::string text;
  for (std::string_view rest = error.what();;) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    text += printable(rest.substr(0, end));
    if (end == rest.size()) return text;
    text += '\n';
    rest.remove_prefix(end + 1);
  }
}

int report_usage(const CLI::App& app, const CLI::Error& error) {
  const std::vector<CLI::App*> commands = app.get_subcommands();
  const std::string name = commands.empty() ? "" : " " + commands.front()->get_name();
  say("feltline: {}\nTry 'feltline{} --help'.\n", usage_text(error), name);
  return 2;
}

int run(int argc, char** argv) {
  // If the reader of our output closes the pipe, the program ends silently, even if the parent
  // process ignores SIGPIPE.
  std::signal(SIGPIPE, SIG_DFL);
  std::signal(SIGXFSZ, SIG_IGN);  // beyond `ulimit -f`, writing fails with an error message
  Console console;
  CLI::App app(kDescription, "feltline");
  try {
    add_commands(app, console);
    check_command_name(app, argc, argv);
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    const int code = app.exit(help);
    return std::cout.flush() && stdout_is_whole() ? code : 1;
  } catch (const CLI::Error& error) {
    console.end_progress();
    if (error.get_exit_code() != 1) return report_usage(app, error);
    console.error(error.what());
  } catch (const std::bad_alloc&) {
    console.error("not enough memory");
  } catch (const std::exception& error) {
    console.error(error.what());
  }
  if (!stdout_is_whole()) console.error("stdout: cannot write");
  return console.failed() ? 1 : 0;
}

}  // namespace

}  // namespace felt::cli

int main(int argc, char** argv) {
  felt::open_standard_streams();
  felt::protect_input_files();
  return felt::cli::run(argc, argv);
}
