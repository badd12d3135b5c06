#include "cases/app/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

namespace velum::cases {
namespace {

double share(Progress const& progress)
{
  return progress.end > 0 ? std::clamp(progress.time / progress.end, 0.0, 1.0) : 1.0;
}

/// Seconds as 42 s, 3 min 05 s or 2 h 10 min.
std::string duration(double seconds)
{
  auto const whole = std::llround(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace

std::string progress_text(Progress const& progress, double elapsed)
{
  double const done = share(progress);
  std::string const left = done > 0 ? duration(elapsed * (1 - done) / done) : "?";
  std::string text = fmt::format("{:.2f} of {:.2f} ms  {:3.0f} %  {} left", 1e3 * progress.time,
                                 1e3 * progress.end, std::floor(100 * done + 1e-6), left);
  if (progress.mlups > 0)
    text += fmt::format("  {:.1f} MLUPS  Mach {:.3f}", progress.mlups, progress.mach);
  if (!progress.coupling.empty()) text += "  " + progress.coupling;
  return text;
}

ProgressLine::ProgressLine(bool quiet, std::FILE* stream)
    : ProgressLine(quiet, stream, isatty(fileno(stream)) == 1)
{
}

ProgressLine::ProgressLine(bool quiet, std::FILE* stream, bool terminal)
    : quiet_(quiet), terminal_(terminal), stream_(stream)
{
}

void ProgressLine::show(Progress const& progress)
{
  if (quiet_) return;
  auto const now = Clock::now();
  bool const ended = share(progress) >= 1;
  if (terminal_) {
    if (!ended && now - last_ < std::chrono::milliseconds(200)) return;
    last_ = now;
  } else {
    int const tenth = static_cast<int>(10 * share(progress) + 1e-9);
    if (tenth <= tenths_) return;
    tenths_ = tenth;
  }
  std::string const text =
      progress_text(progress, std::chrono::duration<double>(now - start_).count());
  if (terminal_) {
    // Blanks cover what a longer line before may have left.
    fmt::print(stream_, "\r{:<{}}", text, width_);
    width_ = text.size();
  } else {
    fmt::print(stream_, "{}\n", text);
  }
  std::fflush(stream_);
}

void ProgressLine::finish()
{
  if (quiet_ || !terminal_ || width_ == 0) return;
  fmt::print(stream_, "\n");
  std::fflush(stream_);
  width_ = 0;
}

}  // namespace velum::cases
