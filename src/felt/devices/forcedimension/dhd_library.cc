#include "felt/devices/forcedimension/dhd_library.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

namespace felt::dhd {
namespace {

constexpr std::array<std::string_view, 2> kStems{"libdrd.so", "libdhd.so"};

// Appends the files in a folder whose names are those of this library in any version: first the
// name without a version, then the others from the newest version to the oldest.
void add_files(const SystemView& system, const std::string& folder, std::string_view stem,
               std::vector<std::string>& names) {
  std::vector<std::string> found = system.list(folder);
  std::erase_if(found, [stem](const std::string& name) {
    return name != stem && !name.starts_with(std::string(stem) + ".");
  });
  std::sort(found.begin(), found.end(), [stem](const std::string& a, const std::string& b) {
    return (a == stem) != (b == stem) ? a == stem : a > b;
  });
  for (const std::string& name : found) names.push_back(folder + "/" + name);
}

// Appends the library folders of an unpacked SDK: lib, and the folders in lib and lib/release that
// are named after a system and compiler ("lin-x86_64-gcc"). Libraries for other processors cannot
// be loaded and are skipped later.
void add_sdk_folders(const SystemView& system, const std::string& sdk,
                     std::vector<std::string>& folders) {
  for (const char* lib : {"/lib/release", "/lib"}) {
    const std::string root = sdk + lib;
    for (const std::string& name : system.list(root)) {
      if (name.starts_with("lin-")) folders.push_back(root + "/" + name);
    }
    folders.push_back(root);
  }
}

void load_drd(SymbolLoader& symbols, Api& api) {
  const bool is_whole =
      symbols.find(api.drd_is_supported, "drdIsSupported") &&
      symbols.find(api.drd_is_initialized, "drdIsInitialized") &&
      symbols.find(api.drd_auto_init, "drdAutoInit") && symbols.find(api.drd_stop, "drdStop") &&
      symbols.find(api.open_id, "drdOpenID") && symbols.find(api.close, "drdClose");
  if (is_whole) return;
  api.drd_is_supported = nullptr;
  api.drd_is_initialized = nullptr;
  api.drd_auto_init = nullptr;
  api.drd_stop = nullptr;
  symbols.require(api.open_id, "dhdOpenID");
  symbols.require(api.close, "dhdClose");
}

Result<Api> load_api(const DynamicLibrary& library) {
  Api api;
  SymbolLoader symbols(library);
  symbols.require(api.get_device_count, "dhdGetDeviceCount");
  symbols.require(api.get_system_type, "dhdGetSystemType");
  symbols.require(api.get_status, "dhdGetStatus");
  symbols.require(api.get_position, "dhdGetPosition");
  symbols.require(api.set_force, "dhdSetForce");
  symbols.require(api.enable_force, "dhdEnableForce");
  symbols.require(api.error_get_last, "dhdErrorGetLast");
  symbols.require(api.error_get_last_str, "dhdErrorGetLastStr");
  symbols.require(api.stop, "dhdStop");
  symbols.require(api.enable_expert_mode, "dhdEnableExpertMode");
  symbols.require(api.disable_expert_mode, "dhdDisableExpertMode");
  symbols.find(api.get_system_name, "dhdGetSystemName");
  symbols.find(api.get_serial_number, "dhdGetSerialNumber");
  symbols.find(api.get_sdk_version, "dhdGetSDKVersion");
  symbols.find(api.set_force_and_gripper, "dhdSetForceAndGripperForce");
  symbols.find(api.set_force_torque_gripper, "dhdSetForceAndTorqueAndGripperForce");
  symbols.find(api.get_button, "dhdGetButton");
  symbols.find(api.get_button_mask, "dhdGetButtonMask");
  symbols.find(api.set_gravity_compensation, "dhdSetGravityCompensation");
  symbols.find(api.set_effector_mass, "dhdSetEffectorMass");
  symbols.find(api.set_watchdog, "dhdSetWatchdog");
  symbols.find(api.get_watchdog, "dhdGetWatchdog");
  symbols.find(api.get_com_freq, "dhdGetComFreq");
  symbols.find(api.reset, "dhdReset");
  symbols.find(api.wait_for_reset, "dhdWaitForReset");
  load_drd(symbols, api);
  if (auto all = symbols.done(); !all) return tl::unexpected(all.error());
  return api;
}

}  // namespace

std::vector<std::string> library_names(const SystemView& system, const std::string& named) {
  if (!named.empty()) return {named};
  std::vector<std::string> folders;
  for (const char* variable : {"FDSDK", "FORCEDIM_SDK"}) {
    const auto sdk = system.environment(variable);
    if (sdk && !sdk->empty()) add_sdk_folders(system, *sdk, folders);
  }
  if (const auto home = system.environment("HOME")) folders.push_back(*home + "/.local/lib");
  folders.emplace_back("/usr/local/lib");
  std::vector<std::string> names;
  for (const std::string_view stem : kStems) {
    for (const std::string& folder : folders) add_files(system, folder, stem, names);
    names.emplace_back(stem);
    names.push_back(std::string(stem) + ".3");
  }
  return names;
}

Result<std::shared_ptr<Library>> Library::load(const std::vector<std::string>& names) {
  static std::mutex lock;
  static std::map<std::string, std::weak_ptr<Library>> loaded;
  const std::lock_guard guard(lock);
  auto file = DynamicLibrary::open(names, LibraryLife::kAsLongAsProgram);
  if (!file) return tl::unexpected(file.error());
  std::weak_ptr<Library>& known = loaded[file->path()];
  if (auto library = known.lock()) return library;
  const Result<Api> api = load_api(*file);
  if (!api) return tl::unexpected(api.error());
  const std::shared_ptr<Library> library(new Library(*std::move(file), *api));
  known = library;
  return library;
}

std::string Library::version() const {
  if (api_.get_sdk_version == nullptr) return {};
  int major = 0, minor = 0, release = 0, revision = 0;
  api_.get_sdk_version(&major, &minor, &release, &revision);
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(release);
}

std::string Library::last_words() const {
  const int code = api_.error_get_last();
  const char* words = api_.error_get_last_str();
  return std::string(words != nullptr && *words != '\0' ? words : "no message") + " (error " +
         std::to_string(code) + ")";
}

int Library::count() const {
  const std::lock_guard guard(lock_);
  return api_.get_device_count();
}

const Library::Opened* Library::find_open(Id id) const noexcept {
  const auto found =
      std::find_if(open_.begin(), open_.end(), [id](const Opened& o) { return o.id == id; });
  return found != open_.end() ? &*found : nullptr;
}

Identity Library::ask_identity(Id id) const {
  Identity identity;
  identity.type = api_.get_system_type(id);
  const char* name = api_.get_system_name != nullptr ? api_.get_system_name(id) : nullptr;
  if (name != nullptr) identity.name = name;
  unsigned short serial = 0;
  if (api_.get_serial_number != nullptr && api_.get_serial_number(&serial, id) >= 0 &&
      serial != 0) {
    identity.serial = serial;
  }
  return identity;
}

Result<Identity> Library::identify(int index) {
  const std::lock_guard guard(lock_);
  const int id = api_.open_id(static_cast<Id>(index));
  if (id < 0) return fail(ErrorCode::kIo, last_words());
  if (const Opened* opened = find_open(static_cast<Id>(id))) return opened->identity;
  Identity identity = ask_identity(static_cast<Id>(id));
  api_.close(static_cast<Id>(id));
  return identity;
}

Result<Id> Library::open(int index) {
  const std::lock_guard guard(lock_);
  const int id = api_.open_id(static_cast<Id>(index));
  if (id < 0) return fail(ErrorCode::kIo, last_words());
  if (find_open(static_cast<Id>(id)) != nullptr) {
    return fail(ErrorCode::kInvalidArgument, "it is already open in this program");
  }
  open_.push_back({static_cast<Id>(id), ask_identity(static_cast<Id>(id))});
  return static_cast<Id>(id);
}

void Library::close(Id id) noexcept {
  const std::lock_guard guard(lock_);
  std::erase_if(open_, [id](const Opened& o) { return o.id == id; });
  api_.close(id);
  ++closings_;
}

}  // namespace felt::dhd
