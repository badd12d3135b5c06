#pragma once
#include "cases/app/curve.hpp"
#include "cases/app/material_card.hpp"
#include "cases/app/scene_flow.hpp"
#include "cases/app/scene_network.hpp"
#include "core/signed_distance.hpp"
#include "core/symmetry.hpp"
#include "core/vec.hpp"
#include "lbm/fluid.hpp"
#include "structure/sheet_bending.hpp"

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace velum::cases {

using core::Vec2;
using core::Vec3;
using lbm::Collision;

enum class Fidelity { hydrostatic, lumped, axisymmetric, planar, space, structure };
enum class Stencil { d2q9, d3q19, d3q27 };
constexpr int directions(Stencil s)
{
  return s == Stencil::d2q9 ? 9 : s == Stencil::d3q19 ? 19 : 27;
}
enum class Precision { double_, single_, half };
enum class LesModel { auto_, off, smagorinsky, vreman };
enum class SolidShape { box, disc, profile, sphere, cylinder, stl };
enum class Operation { add, subtract };
enum class BoundaryKind { traction, pressure, velocity, flow_rate, outflow, port, moving_wall };
/// Whether the value of such a boundary is a pressure.
constexpr bool imposes_pressure(BoundaryKind kind)
{
  return kind == BoundaryKind::traction || kind == BoundaryKind::pressure ||
         kind == BoundaryKind::outflow;
}
enum class Axis { x, y, z };
enum class MembraneShape { disc, strip };
using structure::Rim;
enum class Bending { auto_, on, off };
enum class ContactMethod { penalty, augmented_lagrangian };
enum class LipPressure { none, linear };
enum class CouplingMethod { sharp, diffuse };
enum class CouplingScheme { implicit, explicit_ };
enum class MembraneScheme { auto_, explicit_, implicit };
enum class Feedback { two_way, one_way };

/// The grid of cells from corner `from` to at least corner `to`.
struct Lattice {
  double dx;
  Vec3 from, to;
  double mach = 0.1;                  // of the reference velocity; sets the time step
  std::optional<double> time_step{};  // replaces mach
  Collision collision = Collision::central_moments;
  double magic = 0.125;  // of TRT, and of central moments where the fluid is slow
  lbm::WallRule wall_rule = lbm::WallRule::quadratic;
  Precision precision = Precision::double_;
  Vec3 shift{};  // of the grid against the geometry
  std::array<bool, 3> periodic{};
  unsigned mirrors = 0;  // sides that are planes of symmetry, as in lbm::Model
  Stencil stencil = Stencil::d2q9;
};

struct FluidProperties {
  double density;
  double viscosity;   // kinematic
  Vec3 body_force{};  // per mass: an acceleration
};

struct Les {
  LesModel model = LesModel::auto_;
  double constant = 0.1;  // C; of vreman C_V, about 5/2 C^2
};

/// A rigid body: box from corner to corner, disc, or closed profile through its points. In a
/// meridional plane these are a cylinder, a torus and a body of revolution. In space: box, sphere,
/// cylinder with flat ends, profile revolved about the line y = z = 0, or the surface in an STL
/// file.
struct Solid {
  std::string name;
  SolidShape shape;
  Vec3 from{}, to{};                  // box; ends of a cylinder's axis
  Vec3 centre{};                      // disc, sphere
  double radius = 0;                  // disc, sphere, cylinder
  std::vector<Vec2> points{};         // profile; the last is joined to the first
  double round = 0;                   // radius of the convex corners, inside the outline
  std::string file{};                 // stl
  core::SignedDistance<3> surface{};  // of the file
  Vec3 shift{};
  Operation operation = Operation::add;
};

/// Where a boundary lies: the part of a side of the lattice box, or of a solid's surface, whose
/// coordinate along the side (of a solid: whose second coordinate, the radius) is in [from, to]. A
/// side in space has two coordinates, in the order x, y, z; a disc fills its bounds.
struct Patch {
  std::string side;  // "x-", "x+" ... "z+" or the name of a solid
  Vec2 from, to;
  bool disc = false;
};

struct Boundary {
  std::string name;
  BoundaryKind kind;
  /// Over time: a pressure, a velocity (mean over a patch; of a moving wall along its side, in the
  /// direction of an axis there) or a flow rate, as the kind says.
  Curve value;
  std::vector<Patch> patches;
  VelocityProfile profile = VelocityProfile::uniform;
  Axis along = Axis::x;  // moving wall in space: axis of its motion
};

/// Incompressible rubber, neo-Hookean or by a card, with Rayleigh damping alpha M + beta K0.
struct Material {
  structure::MooneyRivlin rubber;
  double density;
  double damping_mass = 0;       // alpha, 1/s
  double damping_stiffness = 0;  // beta, s
  std::string file{};            // of the card, beside the scene; empty: none
  std::optional<MaterialCard> card{};
};

/// Spring between a fixed support and the patch of the membrane within `radius` of its centre. It
/// pushes towards smaller first coordinate with stiffness (free_length - length); its length is
/// installed_length where the membrane is flat.
struct Spring {
  double stiffness, free_length, installed_length, radius;
};

/// The middle of a membrane, out to a radius, that is moved along the first axis as given.
struct DrivenCentre {
  double radius;
  Curve displacement;  // over time
};

/// Rigid plane across the axis that the membrane's plus face comes up against, out to a radius.
struct Stop {
  double position, radius;
};

/// Flat membrane across the first axis; its mid-surface lies at `position`.
struct MembraneSheet {
  MembraneShape shape;
  std::string material;
  double position;
  double from, to;  // range of the second coordinate; a disc starts at 0
  Curve thickness;  // undeformed, over the second coordinate
  double element;   // largest length of an element
  Rim rim = Rim::clamped;
  Bending bending = Bending::auto_;
  std::optional<DrivenCentre> centre{};
  std::optional<Spring> spring{};
  std::optional<Stop> stop{};
};

/// Thickness over what a membrane spans; above the limit bending is on where the scene leaves it to
/// the program.
constexpr double bending_from = 0.02;
inline bool bends(Bending asked, double slenderness)
{
  return asked == Bending::on || (asked == Bending::auto_ && slenderness >= bending_from);
}
double slenderness(MembraneSheet const& membrane);
bool has_bending(MembraneSheet const& membrane);

struct ContactPair {
  std::string seat;  // name of a solid
  ContactMethod method = ContactMethod::penalty;
  std::optional<double> stiffness{};  // Pa/m; empty: chosen by the run
  LipPressure lip_pressure = LipPressure::linear;
};

struct Coupling {
  CouplingMethod method = CouplingMethod::sharp;
  CouplingScheme scheme = CouplingScheme::implicit;
  MembraneScheme membrane = MembraneScheme::auto_;  // of the membrane's own steps
  Feedback feedback = Feedback::two_way;
};

/// How long the scene runs: `settle` with its boundaries as given, then `shut` with the inlet shut.
struct Schedule {
  double settle = 0;
  double shut = 0;
  double output_every;
  double end;                                // settle + shut unless given
  double sample_every;                       // rows of the series; output_every unless given
  double steady = 0;                         // ends the run below this relative change; 0: never
  std::optional<double> checkpoint_every{};  // empty: a tenth of the run
  int fall_back = 0;  // so often a run that diverges goes on from its last checkpoint, slower
};

/// What a coupled run begins with: the scene, or another one of the same lattice and membrane,
/// marched for some time with all that drives it as it is at t = 0.
struct Start {
  double settle;        // for so long
  std::string scene{};  // file of the other one, beside this one; empty: this one
};

/// Where a scene comes from.
struct SceneFile {
  std::string text{};                           // as read, overrides merged in, as TOML
  std::string file{};                           // its path
  std::map<std::string, std::string> places{};  // key -> "file:line" or "--set"
};

/// What a scene file says, in SI units, checked. Points are (axial, radial), (x, y) or (x, y, z).
struct Scene {
  std::string name;
  Fidelity fidelity;
  Lattice lattice;
  FluidProperties fluid;
  Les les{};
  std::vector<Solid> solids{};  // by name
  std::vector<Boundary> boundaries{};
  std::map<std::string, Material> materials{};
  std::optional<MembraneSheet> membrane{};
  std::optional<ContactPair> contact{};
  GapSection gap{};
  std::vector<ChamberSection> chambers{};
  std::vector<OrificeSection> orifices{};
  Coupling coupling{};
  Schedule run;
  std::optional<Start> start{};
  InitialState initial{};
  std::vector<Probe> probes{};
  std::optional<Reference> reference{};
  Sweep chart{};

  SceneFile source{};
};

/// Reads, merges the overrides ("key=value") into, and checks a scene.
/// @throws core::InputError  one sentence with file, line, key, what is wrong and what is allowed
Scene read_scene(std::filesystem::path const& file, std::vector<std::string> const& overrides = {});

/// Throws core::InputError: place of the key, the key, then what is wrong with it.
[[noreturn]] void reject(SceneFile const& source, std::string const& key, std::string const& what);
[[noreturn]] inline void reject(Scene const& scene, std::string const& key, std::string const& what)
{
  reject(scene.source, key, what);
}

/// Planar, axisymmetric or none (space); a hydrostatic scene follows its membrane.
core::Symmetry symmetry(Scene const& scene);

/// Coordinates of a point of the scene: 2 or 3.
int dimensions(Scene const& scene);

/// The boundary of that name, or nullptr.
Boundary const* find_boundary(Scene const& scene, std::string const& name);

/// The probe of that name, or nullptr.
Probe const* find_probe(Scene const& scene, std::string const& name);

/// The chamber on a side of the membrane, or nullptr.
ChamberSection const* find_chamber(Scene const& scene, ChamberSide side);

/// The solid of that name, or nullptr.
Solid const* find_solid(Scene const& scene, std::string const& name);

}  // namespace velum::cases
