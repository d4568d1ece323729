#include "tracer/tree/tasks.hpp"

#include <atomic>
#include <tbb/task_group.h>

namespace lancer::tracer {
namespace {

/// The counter orders what the threads do, also for ThreadSanitizer, which does not see how TBB hands tasks
/// over.
struct Shared {
  const std::function<void(std::size_t)>& work;
  std::atomic<std::size_t> done{0};

  void run(std::size_t i) {
    done.load(std::memory_order_acquire);
    work(i);
    done.fetch_add(1, std::memory_order_release);
  }
};

struct Task {
  Shared* shared;
  std::size_t i;
#if defined(__GNUC__)
  __attribute__((no_sanitize("thread")))
#endif
  void
  operator()() const {
    shared->run(i);
  }
};

}  // namespace

void at_once(std::size_t count, const std::function<void(std::size_t)>& work) {
  Shared shared{work};
  shared.done.store(0, std::memory_order_release);
  tbb::task_group group;
  for (std::size_t i = 1; i < count; ++i) group.run(Task{&shared, i});
  if (count > 0) group.run_and_wait(Task{&shared, 0});
  shared.done.load(std::memory_order_acquire);
}

}  // namespace lancer::tracer
