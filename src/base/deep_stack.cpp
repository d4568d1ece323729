#include "base/deep_stack.hpp"

#include <cstdint>
#include <exception>
#include <pthread.h>
#include <sys/mman.h>
#include <system_error>
#include <unistd.h>

namespace lancer {
namespace {

constexpr std::size_t k_megabyte = std::size_t{1} << 20;
constexpr std::size_t k_reserve = 256 * 1024;  // for what runs below the last check, exceptions included

// AddressSanitizer loses track of exceptions that are thrown with more than 64 MB of stack in use.
#if defined(__SANITIZE_ADDRESS__)
constexpr std::size_t k_largest = 64 * k_megabyte;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr std::size_t k_largest = 64 * k_megabyte;
#else
constexpr std::size_t k_largest = 1024 * k_megabyte;
#endif
#else
constexpr std::size_t k_largest = 1024 * k_megabyte;
#endif

/// The lowest address that the running thread may use, and whether its stack is one of ours.
struct Bounds {
  std::uintptr_t bottom = 0;
  bool deep = false;
};
thread_local Bounds t_bounds;

std::uintptr_t here() { return reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0)); }

/// Of a thread that was not made here.
std::uintptr_t own_bottom() {
#ifdef __GLIBC__
  pthread_attr_t attributes;
  if (pthread_getattr_np(pthread_self(), &attributes) == 0) {
    void* bottom = nullptr;
    std::size_t size = 0;
    std::size_t guard = 0;
    pthread_attr_getstack(&attributes, &bottom, &size);
    pthread_attr_getguardsize(&attributes, &guard);
    pthread_attr_destroy(&attributes);
    return reinterpret_cast<std::uintptr_t>(bottom) + guard;
  }
#endif
  return here() - k_megabyte / 2;
}

/// Memory for a stack, taken from the system page by page as it is used, with a page at its end that must not
/// be.
class Stack {
 public:
  Stack() = default;
  Stack(const Stack&) = delete;
  Stack& operator=(const Stack&) = delete;
  ~Stack() {
    if (memory_ != MAP_FAILED) munmap(memory_, size_);
  }

  bool reserve(std::size_t size) {
    memory_ = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (memory_ == MAP_FAILED) return false;
    size_ = size;
    guard_ = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    mprotect(memory_, guard_, PROT_NONE);
    return true;
  }
  char* bottom() const { return static_cast<char*>(memory_) + guard_; }
  std::size_t usable() const { return size_ - guard_; }

 private:
  void* memory_ = MAP_FAILED;
  std::size_t size_ = 0;
  std::size_t guard_ = 0;
};

struct Job {
  const std::function<void()>& work;
  std::uintptr_t bottom;
  std::exception_ptr error = nullptr;
};

void* run(void* argument) {
  Job& job = *static_cast<Job*>(argument);
  t_bounds = {job.bottom, true};
  try {
    job.work();
  } catch (...) {
    job.error = std::current_exception();
  }
  return nullptr;
}

/// False where the system refuses a thread with such a stack.
bool run_on(std::size_t size, Job& job) {
  Stack stack;
  if (!stack.reserve(size)) return false;
  job.bottom = reinterpret_cast<std::uintptr_t>(stack.bottom());
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstack(&attributes, stack.bottom(), stack.usable());
  pthread_t thread{};
  const bool started = pthread_create(&thread, &attributes, run, &job) == 0;
  pthread_attr_destroy(&attributes);
  if (started) pthread_join(thread, nullptr);
  return started;
}

}  // namespace

void on_deep_stack(const std::function<void()>& work) {
  if (t_bounds.deep) {
    work();
    return;
  }
  Job job{work, 0};
  if (!run_on(k_largest, job) && !run_on(256 * k_megabyte, job) && !run_on(64 * k_megabyte, job)) {
    throw std::system_error(std::make_error_code(std::errc::not_enough_memory), "no memory for a stack");
  }
  if (job.error) std::rethrow_exception(job.error);
}

std::size_t stack_left() {
  if (t_bounds.bottom == 0) t_bounds.bottom = own_bottom();
  const std::uintptr_t low = t_bounds.bottom + k_reserve;
  return here() > low ? here() - low : 0;
}

}  // namespace lancer
