#include "runtime/training/run/stop_request.h"

#include <csignal>

namespace runtime {
namespace {

volatile std::sig_atomic_t received_signal = 0;
volatile std::sig_atomic_t received_count = 0;
volatile std::sig_atomic_t noted_count = 0;  // so many are only noted

constexpr int kSignals[] = {SIGINT, SIGTERM};

void NoteSignal(int signal) {
  received_signal = signal;
  received_count = received_count + 1;
  if (received_count < noted_count) return;
  for (const int other : kSignals) std::signal(other, SIG_DFL);
}

}  // namespace

StopRequest::StopRequest(Second second) {
  received_signal = 0;
  received_count = 0;
  noted_count = second == Second::kIsNoted ? 2 : 1;
  struct sigaction action {};
  action.sa_handler = NoteSignal;
  action.sa_flags = SA_RESTART;
  for (const int signal : kSignals) sigaction(signal, &action, nullptr);
}

StopRequest::~StopRequest() {
  for (const int signal : kSignals) std::signal(signal, SIG_DFL);
}

int StopRequest::signal() const { return received_signal; }

bool StopRequest::is_urgent() const { return received_count > 1; }

}  // namespace runtime
