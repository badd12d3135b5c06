#pragma once
#include "cases/app/scene.hpp"
#include "core/check.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace velum::tests {

/// A folder of its own under the system's temporary one, removed at the end.
struct TemporaryFolder {
  std::filesystem::path path;

  TemporaryFolder()
  {
    std::string name = (std::filesystem::temp_directory_path() / "velum-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    path = name;
  }
  TemporaryFolder(TemporaryFolder const&) = delete;
  TemporaryFolder& operator=(TemporaryFolder const&) = delete;
  ~TemporaryFolder() { std::filesystem::remove_all(path); }
};

/// A small valve: a clamped disc between two chambers above a seat.
inline std::string const small_valve = R"(name = "small_valve"
fidelity = "axisymmetric"
[lattice]
dx = "100 um"
from = ["-4 mm", "0 mm"]
to = ["2 mm", "6 mm"]
[fluid]
density = "1000 kg/m3"
viscosity = "1e-6 m2/s"
[solid.casing]
shape = "box"
from = ["-5 mm", "5 mm"]
to = ["3 mm", "7 mm"]
[solid.seat]
shape = "profile"
points = [["-1.2 mm", "3 mm"], ["-1.2 mm", "3.5 mm"], ["-5 mm", "3.5 mm"], ["-5 mm", "3 mm"]]
[inlet]
kind = "traction"
pressure = "50 kPa"
patches = [
  { side = "x+", from = "1 mm", to = "5 mm" },
]
[outlet]
kind = "outflow"
patches = [{ side = "x-", from = "0 mm", to = "3 mm" }]
[material.rubber]
shear_modulus = "1 MPa"
density = "1100 kg/m3"
damping_stiffness = "5 ms"
[membrane]
shape = "disc"
material = "rubber"
position = "0 mm"
radius = "5 mm"
thickness = "2 mm"
bending = "off"
[contact]
seat = "seat"
[run]
settle = "10 ms"
output_every = "5 ms"
)";

/// The text with its first `old` replaced.
inline std::string edited(std::string text, std::string const& old, std::string const& by)
{
  auto const at = text.find(old);
  if (at == std::string::npos) throw std::logic_error("the scene does not contain " + old);
  return text.replace(at, old.size(), by);
}

/// The scene that a file with this text gives.
inline cases::Scene read_text(std::string const& text, std::vector<std::string> const& set = {})
{
  TemporaryFolder const folder;
  auto const file = folder.path / "scene.toml";
  std::ofstream(file) << text;
  return cases::read_scene(file, set);
}

/// The sentence with which that scene is refused, its folder left out; empty when it is accepted.
inline std::string refusal(std::string const& text, std::vector<std::string> const& set = {})
{
  try {
    read_text(text, set);
  } catch (core::InputError const& error) {
    std::string const sentence = error.what();
    auto const at = sentence.find("scene.toml");
    return sentence.starts_with('/') && at != std::string::npos ? sentence.substr(at) : sentence;
  }
  return {};
}

}  // namespace velum::tests
