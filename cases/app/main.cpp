#include "cases/app/commands.hpp"
#include "cases/app/options.hpp"
#include "cases/app/stop.hpp"
#include "cases/app/threads.hpp"
#include "core/check.hpp"

#include <fmt/format.h>
#include <Kokkos_Core.hpp>

#include <cstdio>
#include <exception>
#include <string>
#include <vector>

namespace {

namespace cases = velum::cases;

/// Kokkos with the arguments meant for it, for the length of a command.
class KokkosSession {
 public:
  explicit KokkosSession(std::string program, std::vector<std::string> arguments)
      : arguments_(std::move(arguments))
  {
    arguments_.insert(arguments_.begin(), std::move(program));
    std::vector<char*> argv;
    for (auto& argument : arguments_) argv.push_back(argument.data());
    auto argc = static_cast<int>(argv.size());
    argv.push_back(nullptr);
    Kokkos::initialize(argc, argv.data());
  }
  KokkosSession(KokkosSession const&) = delete;
  KokkosSession& operator=(KokkosSession const&) = delete;
  ~KokkosSession() { Kokkos::finalize(); }

 private:
  std::vector<std::string> arguments_;
};

void carry_out(cases::Options const& options)
{
  switch (options.command) {
    case cases::Command::run:
      return cases::run_command(options);
    case cases::Command::check:
      return cases::check_command(options);
    case cases::Command::stl:
      return cases::stl_command(options);
    case cases::Command::mesh:
      return cases::mesh_command(options);
    case cases::Command::chart:
      return cases::chart_command(options);
    case cases::Command::sweep:
      return cases::sweep_command(options);
    case cases::Command::limits:
      return cases::limits_command(options);
    case cases::Command::fit:
      return cases::fit_command(options);
    case cases::Command::plot:
      return cases::plot_command(options);
    case cases::Command::bench:
      return cases::bench_command(options);
    case cases::Command::info:
      return cases::info_command();
  }
}

int fail(int code, std::exception const& error)
{
  std::fflush(stdout);
  fmt::print(stderr, "{}\n", error.what());
  return code;
}

}  // namespace

int main(int argc, char** argv)
{
  auto const line = cases::read_command_line(argc, argv);
  if (!line.options) return line.exit_code;
  try {
    cases::set_up_threads(line.options->threads, argv);
    KokkosSession const kokkos(argv[0], line.options->kokkos);
    carry_out(*line.options);
    return 0;
  } catch (velum::core::InputError const& error) {
    return fail(2, error);
  } catch (velum::core::Divergence const& error) {
    return fail(3, error);
  } catch (cases::Stopped const& error) {
    return fail(4, error);
  } catch (std::exception const& error) {
    return fail(1, error);
  }
}
