// SPDX-License-Identifier: LGPL-2.1-or-later
#include "parallel/thread_pool.h"

#include <cfenv>
#include <condition_variable>
#include <list>
#include <mutex>
#include <thread>

namespace thicken::parallel {

namespace {

struct Job {
  const std::function<void()>* work;
  int wanted;       // helpers that may still begin
  int running = 0;  // helpers that have begun and not ended
  std::fenv_t environment{};
};

class Pool {
 public:
  void run(int helpers, const std::function<void()>& work) {
    Job job{&work, helpers};
    std::fegetenv(&job.environment);
    {
      const std::lock_guard lock(guard_);
      for (; threads_ < helpers; ++threads_) std::thread([this] { help(); }).detach();
      jobs_.push_back(&job);
    }
    for (int i = 0; i < helpers; ++i) wake_.notify_one();
    work();
    std::unique_lock lock(guard_);
    jobs_.remove(&job);
    ended_.wait(lock, [&] { return job.running == 0; });
  }

 private:
  [[noreturn]] void help() {
    std::unique_lock lock(guard_);
    for (;;) {
      wake_.wait(lock, [this] { return !jobs_.empty(); });
      Job& job = *jobs_.front();
      if (--job.wanted == 0) jobs_.pop_front();
      ++job.running;
      lock.unlock();
      std::fesetenv(&job.environment);
      (*job.work)();
      lock.lock();
      if (--job.running == 0) ended_.notify_all();
    }
  }

  std::mutex guard_;
  std::condition_variable wake_, ended_;
  std::list<Job*> jobs_;  // that want helpers
  int threads_ = 0;
};

}  // namespace

void runWithHelpers(int helpers, const std::function<void()>& work) {
  if (helpers <= 0) return work();
  // Never destroyed: threads may wait in it until the process ends.
  static Pool& pool = *new Pool;
  pool.run(helpers, work);
}

}  // namespace thicken::parallel
