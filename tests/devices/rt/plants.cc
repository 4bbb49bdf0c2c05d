#include "tests/devices/rt/plants.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <new>

#include <fcntl.h>
#include <linux/futex.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

namespace felt::rt_test {
namespace {

// Volatile, because otherwise the compiler could remove an allocation that is never used.
void* volatile block = nullptr;
volatile int number = 0;
pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
pthread_cond_t condition = PTHREAD_COND_INITIALIZER;

void make_block() {
  block = std::malloc(64);
}
void make_pages() {
  block = mmap(nullptr, 1U << 20, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
}

void raw_system_call() noexcept {
#if defined(__x86_64__)
  long result = SYS_getpid;
  asm volatile("syscall" : "+a"(result) : : "rcx", "r11", "memory");
  number = static_cast<int>(result);
#else
  number = static_cast<int>(syscall(SYS_getpid));
#endif
}

constexpr std::array kPlants{
    Plant{"malloc", nullptr, []() noexcept { block = std::malloc(64); }},
    Plant{"calloc", nullptr, []() noexcept { block = std::calloc(8, 8); }},
    Plant{"realloc", make_block, []() noexcept { block = std::realloc(block, 4096); }},
    Plant{"free", make_block, []() noexcept { std::free(block); }},
    Plant{"aligned_alloc", nullptr, []() noexcept { block = std::aligned_alloc(64, 64); }},
    Plant{"operator_new", nullptr, []() noexcept { block = ::operator new(64); }},
    Plant{"mutex", nullptr, []() noexcept { pthread_mutex_lock(&mutex); }},
    Plant{"condition", nullptr, []() noexcept { pthread_cond_signal(&condition); }},
    Plant{"read", nullptr,
          []() noexcept {
            char byte = 0;
            number = static_cast<int>(::read(-1, &byte, 1));
          }},
    Plant{"write", nullptr, []() noexcept { number = static_cast<int>(::write(-1, "", 0)); }},
    Plant{"open", nullptr, []() noexcept { number = ::open("/dev/null", O_RDONLY); }},
    Plant{"futex", nullptr,
          []() noexcept {
            static int word = 0;
            syscall(SYS_futex, &word, FUTEX_WAKE_PRIVATE, 1, nullptr, nullptr, 0);
          }},
    Plant{"nanosleep", nullptr,
          []() noexcept {
            const timespec moment{0, 1000};
            ::nanosleep(&moment, nullptr);
          }},
    Plant{"printf", nullptr, []() noexcept { std::printf("%d\n", number); }},
    Plant{"throw", nullptr,
          []() noexcept {
            try {
              if (number == 0) throw 1;
            } catch (int thrown) {
              number = thrown;
            }
          }},
    Plant{"raw_system_call", nullptr, raw_system_call},
    Plant{"page_fault", make_pages,
          []() noexcept { static_cast<volatile char*>(block)[5 << 12] = 1; }},
};

}  // namespace

std::span<const Plant> plants() noexcept {
  return kPlants;
}

}  // namespace felt::rt_test
