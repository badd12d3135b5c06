#include "cases/app/threads.hpp"

#include <sched.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

namespace velum::cases {
namespace {

/// Processors that this process may run on.
int processors()
{
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  return sched_getaffinity(0, sizeof allowed, &allowed) == 0 ? CPU_COUNT(&allowed) : 1;
}

/// @return true when the variable did not have this value
bool set(char const* name, std::string const& value)
{
  char const* present = std::getenv(name);
  if (present && present == value) return false;
  setenv(name, value.c_str(), 1);
  return true;
}

}  // namespace

void set_up_threads(int threads, char** argv)
{
  bool changed = threads > 0 && set("OMP_NUM_THREADS", std::to_string(threads));
  if (!std::getenv("OMP_PROC_BIND") && !std::getenv("OMP_PLACES")) {
    char const* given = std::getenv("OMP_NUM_THREADS");
    bool const all = !given || std::atoi(given) == processors();
    changed = set("OMP_PROC_BIND", all ? "spread" : "false") || changed;
    if (all) changed = set("OMP_PLACES", "threads") || changed;
  }
  // Where this fails the run goes on unbound, which costs only speed.
  if (changed) execv("/proc/self/exe", argv);
}

}  // namespace velum::cases
