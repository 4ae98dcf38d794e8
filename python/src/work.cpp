#include "python/src/work.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <string>
#include <thread>

#include "geometry/error.h"
#include "geometry/threads.h"

namespace hsr::python {

namespace {

/// The work on its thread, and whether it is done.
class Worker {
 public:
  Worker(std::optional<int> threads, const std::function<void(const Ticket&)>& work)
      : thread_([this, threads, &work] { do_work(threads, work); }) {}
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  ~Worker() {
    stop_.request_stop();
    thread_.join();
  }

  /// Waits a moment. @returns whether the work is done
  bool wait() {
    std::unique_lock lock(mutex_);
    return end_.wait_for(lock, std::chrono::milliseconds(50), [&] { return is_done_; });
  }
  double done() const { return done_; }
  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  void do_work(std::optional<int> threads, const std::function<void(const Ticket&)>& work) {
    try {
      std::optional<Threads> limit;
      if (threads) limit.emplace(static_cast<std::size_t>(*threads));
      work({[this](double done) { done_ = done; }, stop_.get_token()});
    } catch (...) {
      error_ = std::current_exception();
    }
    const std::scoped_lock lock(mutex_);
    is_done_ = true;
    end_.notify_all();
  }

  std::atomic<double> done_{0};
  std::stop_source stop_;
  std::mutex mutex_;
  std::condition_variable end_;
  bool is_done_ = false;
  std::exception_ptr error_;
  std::thread thread_;  // the last, so that all else is there when it starts
};

void tell(const py::object& progress, double done, double& told) {
  if (progress.is_none() || done == told) return;
  told = done;
  progress(done);
}

}  // namespace

void Ticket::check() const {
  if (stop.stop_requested()) throw CancelledError("the work was ended because the caller asked for it");
}

void run(const Control& control, const std::function<void(const Ticket&)>& work) {
  if (control.threads && *control.threads < 1)
    throw InputError("threads: found " + std::to_string(*control.threads) + ", expected 1 or more");
  double told = 0;
  {
    const py::gil_scoped_release release;
    Worker worker(control.threads, work);
    while (!worker.wait()) {
      const py::gil_scoped_acquire gil;
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      tell(control.progress, worker.done(), told);
    }
    worker.rethrow();
  }
  tell(control.progress, 1, told);
}

}  // namespace hsr::python
