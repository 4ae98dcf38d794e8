// As Debian's Open CASCADE is built: what it calls back is found in its own list of handlers, which a jump past it would leave behind.
#define OCC_CONVERT_SIGNALS
#include "hsr/step/fault_guard.h"

#include <OSD_SIGSEGV.hxx>
#include <Standard_ErrorHandler.hxx>
#include <array>
#include <csignal>
#include <mutex>

namespace hsr::internal {

namespace {

constexpr std::array<int, 4> faults = {SIGSEGV, SIGBUS, SIGFPE, SIGILL};

thread_local bool is_guarded = false;
std::array<struct sigaction, faults.size()> before;

/// Outside of a guarded call the fault is as it was without us: the instruction is tried again under the action that was there.
extern "C" void on_fault(int signal) {
  if (is_guarded) OSD_SIGSEGV::NewInstance("fault of the processor")->Jump();
  for (std::size_t k = 0; k < faults.size(); ++k)
    if (faults[k] == signal) sigaction(signal, &before[k], nullptr);
}

/// The handler is there while some thread is in a guarded call; else faults are our host's.
class Handler {
 public:
  Handler() {
    const std::scoped_lock lock(mutex_);
    if (users_++ > 0) return;
    struct sigaction action = {};
    action.sa_handler = on_fault;
    action.sa_flags = SA_ONSTACK | SA_NODEFER;
    for (std::size_t k = 0; k < faults.size(); ++k) sigaction(faults[k], &action, &before[k]);
  }
  Handler(const Handler&) = delete;
  Handler& operator=(const Handler&) = delete;
  ~Handler() {
    const std::scoped_lock lock(mutex_);
    if (--users_ > 0) return;
    for (std::size_t k = 0; k < faults.size(); ++k) sigaction(faults[k], &before[k], nullptr);
  }

 private:
  inline static std::mutex mutex_;
  inline static int users_ = 0;
};

/// Where the handler runs where the stack has come to its end, as it does in entities that are nested without end.
class OtherStack {
 public:
  OtherStack() {
    stack_t other = {};
    other.ss_sp = bytes_.data();
    other.ss_size = bytes_.size();
    sigaltstack(&other, &before_);
  }
  OtherStack(const OtherStack&) = delete;
  OtherStack& operator=(const OtherStack&) = delete;
  ~OtherStack() { sigaltstack(&before_, nullptr); }

 private:
  std::array<char, std::size_t{1} << 16U> bytes_;
  stack_t before_ = {};
};

}  // namespace

void survive_faults(const std::function<void()>& function) {
  const Handler handler;
  const OtherStack other_stack;
  const bool was_guarded = is_guarded;
  is_guarded = true;
  try {
    OCC_CATCH_SIGNALS
    function();
  } catch (...) {
    is_guarded = was_guarded;
    throw;
  }
  is_guarded = was_guarded;
}

}  // namespace hsr::internal
