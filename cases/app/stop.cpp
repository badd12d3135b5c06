#include "cases/app/stop.hpp"

#include <csignal>

namespace velum::cases {
namespace {

volatile std::sig_atomic_t requested = 0;

}  // namespace

void catch_stop_signals()
{
  struct sigaction action {};
  action.sa_handler = [](int) { requested = 1; };
  action.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

void request_stop(bool stop) { requested = stop; }

bool stop_requested() { return requested != 0; }

}  // namespace velum::cases
