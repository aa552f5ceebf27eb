#include "runtime/training/simulation/ode_library.h"

#include <cstdarg>
#include <cstdio>
#include <mutex>
#include <vector>

namespace runtime {
namespace {

[[noreturn]] void Throw(int, const char* format, va_list arguments) {
  char message[256];
  std::vsnprintf(message, sizeof message, format, arguments);
  throw OdeFailure(message);
}

// ODE's messages tell of a solver that lost some accuracy, which the checks of the state judge.
void Ignore(int, const char*, va_list) {}

struct Library {
  Library() {
    dInitODE2(0);
    dSetErrorHandler(Throw);
    dSetDebugHandler(Throw);
    dSetMessageHandler(Ignore);
  }
};

struct ThreadData {
  ThreadData() {
    static const Library library;
    dAllocateODEDataForThread(dAllocateMaskAll);
  }
  ~ThreadData() { dCleanupODEAllDataForThread(); }
};

}  // namespace

void KeepForever(OdeThreading threading) {
  static std::mutex mutex;
  static auto& kept = *new std::vector<dThreadingImplementationID>;
  const std::lock_guard lock(mutex);
  kept.push_back(threading.release());
}

void UseOdeInThisThread() { thread_local const ThreadData data; }

}  // namespace runtime
