// problem:   the shipped scenes of bodies alone: the inflated disc, the clamped plate and the disc
// on
//            a ring seat, of line elements and of triangles somewhat coarser than shipped; a plate
//            set in motion by a sudden pressure
// reference: the tables beside the scenes, whose heads say how they were computed; limit
// load 1.87917
//            of p a/(mu H); slowest vibration 10.2158 of omega a^2 sqrt(rho H/D) (Leissa 1969);
//            the sum over twelve modes
// measure:   relative error of the deflection in every state, of the limit load, of the frequency;
// of
//            the seat's force between lines and triangles
// tolerance: membrane 0.2 %, triangles of 0.5 mm 0.35 %; plate 1 %; disc on its seat 1 %, triangles
//            2 %; frequency 1 %
// why:       the issue's 0.2 % and 1 %; the error of triangles falls with the square of their size,
//            0.15 % as shipped (0.4 mm); the seat's narrow land is met by few triangles
#include <gtest/gtest.h>

#include <cmath>

#include "cases/app/body_model.hpp"
#include "cases/app/body_run.hpp"
#include "structure/modes.hpp"
#include "structure/sheet_mesh.hpp"
#include "tests/cases/scene_file.hpp"
#include "tests/structure/gmsh_files.hpp"
#include "tests/support/derivatives.hpp"
#include "tests/support/summary.hpp"

namespace velum {
namespace {

/// A shipped scene run with some keys changed.
class BodyScenes : public testing::Test {
 protected:
  void run(std::string const& name, std::vector<std::string> const& set)
  {
    auto const scene = cases::read_body_scene("cases/" + name + "/scene.toml", set);
    cases::run_body(scene, folder.path);
  }
  double figure(std::string const& name) const { return tests::figure(folder.path, name); }

  tests::TemporaryFolder folder;
};

TEST_F(BodyScenes, InflatedDiscOfLinesFollowsTheReferencePastItsLimit)
{
  run("inflated_disc", {"body.elements=lines", "body.element=0.1 mm"});
  EXPECT_LT(figure("pole_deflection_error_max"), 0.002);
  EXPECT_EQ(figure("states_compared"), 8);
  EXPECT_NEAR(figure("limit_load_error"), 0, 0.002);
}

TEST_F(BodyScenes, InflatedDiscOfTrianglesFollowsTheReference)
{
  run("inflated_disc", {"body.element=0.5 mm", "load.volumes=[2500 mm3, 2800 mm3, 3000 mm3]"});
  EXPECT_LT(figure("pole_deflection_error_max"), 0.0035);
  EXPECT_NEAR(figure("limit_load_error"), 0, 0.0035);
}

TEST_F(BodyScenes, ClampedPlateBendsStretchesAndRingsAsPublished)
{
  run("clamped_plate", {"body.elements=lines"});
  EXPECT_LT(figure("pole_deflection_error_max"), 0.01);
  EXPECT_NEAR(figure("frequency_1_error"), 0, 0.01);
  run("clamped_plate", {"body.element=1.25 mm", "load.pressures=[0.1875 Pa, 187.5 Pa]"});
  EXPECT_LT(figure("pole_deflection_error_max"), 0.01);
  EXPECT_NEAR(figure("frequency_1_error"), 0, 0.01);
}

TEST_F(BodyScenes, DiscOnARingSeatIsHeldAsComputed)
{
  run("disc_on_ring_seat", {"body.elements=lines", "body.element=0.1 mm"});
  EXPECT_LT(figure("pole_deflection_error_max"), 0.01);
  EXPECT_NEAR(figure("seat_force_error"), 0, 1e-3);
  EXPECT_LT(figure("penetration"), 1e-9);
  run("disc_on_ring_seat", {"body.element=0.375 mm", "contact.method=penalty"});
  EXPECT_LT(figure("pole_deflection_error_max"), 0.02);
  EXPECT_NEAR(figure("seat_force_error"), 0, 0.01);
  EXPECT_GT(figure("penetration"), 1e-7);
}

// A disc of triangles written as Gmsh does, in millimetres, and held by the name of its rim, is the
// disc that the program makes.
TEST_F(BodyScenes, DiscFromAMeshIsTheDisc)
{
  std::string const set = "load.volumes=[2500 mm3]";
  run("inflated_disc", {"body.element=1 mm", set});
  double const made = figure("pole_deflection");
  auto const mesh = structure::disc_mesh(structure::graded(0, 10, 10));
  std::ofstream(folder.path / "disc.msh", std::ios::binary)
      << tests::msh(tests::MshContents(mesh), {41, true});
  std::ofstream(folder.path / "disc.toml") << R"(name = "disc"
fidelity = "structure"
[body]
shape = "mesh"
elements = "triangles"
file = "disc.msh"
unit = "1 mm"
clamp = ["rim"]
material = "rubber"
thickness = "0.1 mm"
[material.rubber]
shear_modulus = "1 MPa"
density = "1100 kg/m3"
[load]
pressures = ["100 Pa", "17.5 kPa"]
)";
  auto const scene = cases::read_body_scene(folder.path / "disc.toml");
  EXPECT_NEAR(cases::slenderness(scene.body), 0.01, 1e-6);
  cases::run_body(scene, folder.path);
  EXPECT_NEAR(figure("deflection_max") / made, 1, 1e-6);
  EXPECT_THROW(cases::read_body_scene(folder.path / "disc.toml", {"body.clamp=[edge]"}),
               core::InputError);
}

/// The sentence with which a body's scene is refused.
std::string refusal(std::vector<std::string> const& set)
{
  try {
    cases::read_body_scene("cases/inflated_disc/scene.toml", set);
  } catch (core::InputError const& error) {
    return error.what();
  }
  return "";
}

TEST(BadBody, IsRefusedInASentence)
{
  EXPECT_NE(
      refusal({"body.shape=tube", "body.elements=lines"}).find("cannot be \"tube\" with lines"),
      std::string::npos);
  EXPECT_NE(refusal({"body.bending=on"}).find("load.volumes is for membranes"), std::string::npos);
  EXPECT_NE(refusal({"modes=3"}).find("without bending do not exist"), std::string::npos);
  EXPECT_NE(refusal({"load.side=plus"}).find("must be \"minus\""), std::string::npos);
  EXPECT_NE(refusal({"load.volumes=[2 mm3, 1 mm3]"}).find("must ascend"), std::string::npos);
  EXPECT_NE(refusal({"body.element=9 mm"}).find("at most half"), std::string::npos);
  EXPECT_NE(refusal({"body.material=ruber"}).find("did you mean \"rubber\"?"), std::string::npos);
  EXPECT_NE(refusal({"load.presures=[1 Pa]"}).find("pressures"), std::string::npos);
}

/// Deflection of the middle at a time after a pressure of 1 Pa came at once: the sum over the modes
/// of what each does to a constant force, s (s . f) (1 - cos omega t) / omega^2.
double by_modes(cases::BodyScene const& scene, double time)
{
  cases::BodyModel<structure::Membrane> model(scene);
  auto const modes = structure::slowest_modes(model.body, model.loads, 12);
  model.set_pressure(cases::Side::minus, 1);
  Eigen::VectorXd const force = tests::force_of(model.loads.front(), model.body.reference);
  double sum = 0;
  for (int k = 0; k < modes.omega.size(); ++k)
    sum += modes.shapes(0, k) * modes.shapes.col(k).dot(force) *
           (1 - std::cos(modes.omega[k] * time)) / std::pow(modes.omega[k], 2);
  return sum;
}

// A march that either scheme makes ends where the vibrations of the plate, which slowest_modes()
// finds, add up to.
TEST_F(BodyScenes, PlatePressedAtOnceVibratesInItsModes)
{
  std::string const text = R"(name = "struck"
fidelity = "structure"
[body]
shape = "disc"
elements = "lines"
material = "rubber"
radius = "20 mm"
thickness = "1 mm"
element = "1 mm"
[material.rubber]
shear_modulus = "1 MPa"
density = "1100 kg/m3"
[march]
pressure = "1 Pa"
end = "7 ms"
step = "0.05 ms"
)";
  std::ofstream(folder.path / "struck.toml") << text;
  for (std::string const scheme : {"explicit", "implicit"}) {
    auto const scene =
        cases::read_body_scene(folder.path / "struck.toml", {"march.scheme=" + scheme});
    cases::run_body(scene, folder.path);
    EXPECT_NEAR(figure("pole_deflection") / by_modes(scene, 7e-3), 1, 0.01) << scheme;
  }
}

TEST_F(BodyScenes, SayWhichStateHasNoEquilibrium)
{
  try {
    run("inflated_disc", {"body.elements=lines", "load.pressures=[10 kPa, 20 kPa]"});
    FAIL() << "20 kPa is beyond the limit point";
  } catch (core::Divergence const& failure) {
    EXPECT_NE(std::string(failure.what()).find("State 2, pressure 20000 Pa:"), std::string::npos)
        << failure.what();
  }
}

}  // namespace
}  // namespace velum
