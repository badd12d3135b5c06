#pragma once
#include "cases/app/fluid_run.hpp"
#include "tests/cases/scene_file.hpp"

#include <algorithm>

namespace velum::tests {

/// A small flow without a membrane: a body in a channel.
inline std::string const small_flow = R"(name = "small_flow"
fidelity = "planar"
[lattice]
dx = "1 mm"
from = ["0 mm", "0 mm"]
to = ["40 mm", "20 mm"]
[fluid]
density = "1000 kg/m3"
viscosity = "1e-5 m2/s"
[les]
model = "off"
[solid.post]
shape = "disc"
centre = ["12 mm", "10 mm"]
radius = "3 mm"
[inlet]
kind = "velocity"
velocity = "10 mm/s"
profile = "parabolic"
patches = [{ side = "x-", from = "0 mm", to = "20 mm" }]
[outlet]
kind = "outflow"
patches = [{ side = "x+", from = "0 mm", to = "20 mm" }]
[probe.middle]
kind = "point"
at = ["30 mm", "10 mm"]
[probe.post]
kind = "force"
solid = "post"
[run]
end = "2 s"
)";

/// The beginning of a scene in space.
inline std::string const box_in_space = R"(name = "box"
fidelity = "3d"
[lattice]
dx = "1 mm"
from = ["0 mm", "0 mm", "0 mm"]
to = ["20 mm", "10 mm", "10 mm"]
[fluid]
density = "1000 kg/m3"
viscosity = "1e-5 m2/s"
)";

/// The text with lines added at its end.
inline std::string with(std::string const& text, std::string const& lines)
{
  return text + lines + '\n';
}

/// A figure of a summary.
inline double figure(core::Summary const& summary, std::string const& name)
{
  auto const found = std::find_if(summary.figures.begin(), summary.figures.end(),
                                  [&](core::Figure const& f) { return f.name == name; });
  if (found == summary.figures.end()) throw std::runtime_error("no figure " + name);
  return found->value;
}

/// The summary of a shipped scene with these overrides, run in this process, nothing written.
inline core::Summary run_shipped(std::string const& name, std::vector<std::string> const& set)
{
  auto const scene = cases::read_scene("cases/" + name + "/scene.toml", set);
  return cases::march_fluid(scene, {.out = {}, .quiet = true});
}

}  // namespace velum::tests
