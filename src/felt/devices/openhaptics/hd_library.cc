#include "felt/devices/openhaptics/hd_library.h"

#include <locale.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <clocale>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

namespace felt {
namespace {

constexpr std::size_t kMaxErrorsCleared =
    64;  // limit, so that a library with endless errors cannot block us

// Returns the "C" locale. It is never freed, because a thread of the library may still use it.
locale_t plain_locale() noexcept {
  static const locale_t locale = newlocale(LC_NUMERIC_MASK, "C", nullptr);
  return locale;
}

struct Loaded {
  std::mutex mutex;
  std::map<std::string, std::weak_ptr<HdLibrary>> by_path;
};

Loaded& loaded() {
  static Loaded all;
  return all;
}

std::string hexadecimal(unsigned value) {
  std::array<char, 16> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, 16).ptr;
  return "0x" + std::string(digits.data(), end);
}

}  // namespace

Result<std::shared_ptr<HdLibrary>> HdLibrary::load(std::span<const std::string> names) {
  const PlainNumbers plain;  // the library may read its files when it is loaded
  auto library = DynamicLibrary::open(names, LibraryLife::kAsLongAsProgram);
  if (!library) return tl::unexpected(library.error());
  Loaded& all = loaded();
  const std::scoped_lock lock(all.mutex);
  std::weak_ptr<HdLibrary>& known = all.by_path[library->path()];
  if (auto already = known.lock()) return already;
  std::shared_ptr<HdLibrary> made(new HdLibrary(*std::move(library)));
  if (auto found = made->find_functions(); !found) return tl::unexpected(found.error());
  known = made;
  return made;
}

bool HdLibrary::take() noexcept {
  return !std::exchange(is_taken_, true);
}

Result<void> HdLibrary::find_functions() {
  SymbolLoader symbols(library_);
  symbols.require(functions_.init_device, "hdInitDevice");
  symbols.require(functions_.disable_device, "hdDisableDevice");
  symbols.require(functions_.begin_frame, "hdBeginFrame");
  symbols.require(functions_.end_frame, "hdEndFrame");
  symbols.require(functions_.get_error, "hdGetError");
  symbols.require(functions_.error_words, "hdGetErrorString");
  symbols.require(functions_.enable, "hdEnable");
  symbols.require(functions_.disable, "hdDisable");
  symbols.require(functions_.is_enabled, "hdIsEnabled");
  symbols.require(functions_.get_booleans, "hdGetBooleanv");
  symbols.require(functions_.get_integers, "hdGetIntegerv");
  symbols.require(functions_.get_doubles, "hdGetDoublev");
  symbols.require(functions_.set_doubles, "hdSetDoublev");
  symbols.require(functions_.get_string, "hdGetString");
  symbols.require(functions_.check_calibration, "hdCheckCalibration");
  symbols.require(functions_.update_calibration, "hdUpdateCalibration");
  symbols.require(functions_.start_scheduler, "hdStartScheduler");
  symbols.require(functions_.stop_scheduler, "hdStopScheduler");
  symbols.require(functions_.set_scheduler_rate, "hdSetSchedulerRate");
  symbols.require(functions_.schedule, "hdScheduleAsynchronous");
  symbols.require(functions_.unschedule, "hdUnschedule");
  return symbols.done();
}

std::string drained_words(const HdFunctions& call) {
  std::vector<std::string> words;
  drain_errors(call, kMaxErrorsCleared, [&](const hd::ErrorInfo& info) {
    const char* text = call.error_words(info.code);
    words.push_back((text != nullptr ? std::string(text) : "no message") + " (" +
                    hexadecimal(info.code) + ", internal " + std::to_string(info.internal_code) +
                    ")");
  });
  std::string all;
  for (auto word = words.rbegin(); word != words.rend(); ++word) {
    all += (all.empty() ? "" : "; ") + *word;
  }
  return all;
}

PlainNumbers::PlainNumbers() noexcept : before_(uselocale(nullptr)) {
  keep();
}

PlainNumbers::~PlainNumbers() noexcept {
  uselocale(static_cast<locale_t>(before_));
}

void PlainNumbers::keep() noexcept {
  if (plain_locale() != nullptr) uselocale(plain_locale());
}

void PlainNumbers::prepare() noexcept {
  static_cast<void>(plain_locale());
}

}  // namespace felt
