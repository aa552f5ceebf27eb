// How the functions of host.h fail: inside by an exception, outside by a code and a message.
#pragma once

#include <taskc/host.h>

#include <exception>
#include <new>
#include <string>
#include <utility>

#include "plugins/host/plugin_error.h"

namespace libtaskc {

class Failure : public std::exception {
 public:
  Failure(taskc_status status, std::string message)
      : status_(status), message_(std::move(message)) {}
  taskc_status status() const { return status_; }
  const char* what() const noexcept override { return message_.c_str(); }

 private:
  taskc_status status_;
  std::string message_;
};

// Keeps the message for this thread's taskc_error(), and gives the status back.
taskc_status Keep(taskc_status status, const char* message) noexcept;
const char* KeptMessage() noexcept;
taskc_status StatusOf(host::PluginDefect defect);

// Throws Failure for null. `what`: as the message calls it.
void RequirePointer(const void* pointer, const char* what);

// Calls `action`; what it throws becomes the status.
template <class Action>
taskc_status Guarded(Action action) noexcept {
  try {
    action();
    return TASKC_OK;
  } catch (const Failure& failure) {
    return Keep(failure.status(), failure.what());
  } catch (const host::PluginError& error) {
    return Keep(StatusOf(error.defect()), error.what());
  } catch (const std::exception&) {  // std::bad_alloc, or a thread that could not be made
    return Keep(TASKC_ERROR_NO_MEMORY, "there is not enough memory");
  }
}

}  // namespace libtaskc
