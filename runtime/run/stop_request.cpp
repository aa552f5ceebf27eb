#include "runtime/run/stop_request.h"

#include <csignal>

namespace runtime {
namespace {

volatile std::sig_atomic_t received_signal = 0;

constexpr int kSignals[] = {SIGINT, SIGTERM};

// Only notes the signal; from the next one on, all of them do what they do without us.
void NoteSignal(int signal) {
  received_signal = signal;
  for (const int other : kSignals) std::signal(other, SIG_DFL);
}

}  // namespace

StopRequest::StopRequest() {
  received_signal = 0;
  struct sigaction action {};
  action.sa_handler = NoteSignal;
  action.sa_flags = SA_RESTART;
  for (const int signal : kSignals) sigaction(signal, &action, nullptr);
}

StopRequest::~StopRequest() {
  for (const int signal : kSignals) std::signal(signal, SIG_DFL);
}

int StopRequest::signal() const { return received_signal; }

}  // namespace runtime
