#include "tests/devices/drivers/openhaptics/fake_slots.h"

#include <dlfcn.h>

#include <array>
#include <cstdio>
#include <cstdlib>

namespace felt {
namespace {

// FELT_FAKE_LIBHD is a list of file names, in quotes and separated by commas.
constexpr std::array kFiles{FELT_FAKE_LIBHD};

std::array<bool, kFiles.size()>& taken() {
  static std::array<bool, kFiles.size()> slots{};
  return slots;
}

[[noreturn]] void give_up(const char* why) {
  std::fprintf(stderr, "fake libHD: %s\n", why);
  std::abort();
}

}  // namespace

FakeSlot::FakeSlot() : index_(0) {
  while (index_ < kFiles.size() && taken()[index_]) ++index_;
  if (index_ == kFiles.size()) give_up("more at a time than there are copies of it");
  taken()[index_] = true;
  path_ = kFiles[index_];
  void* library = dlopen(path_.c_str(), RTLD_LAZY | RTLD_LOCAL | RTLD_NODELETE);
  if (library == nullptr) give_up(dlerror());
  using Control = const FakeHdControl* (*)();
  const auto control = reinterpret_cast<Control>(dlsym(library, "fake_hd_control"));
  if (control == nullptr) give_up("no fake_hd_control");
  control_ = control();
  control_->reset();
}

FakeSlot::~FakeSlot() {
  control_->reset();
  taken()[index_] = false;
}

}  // namespace felt
