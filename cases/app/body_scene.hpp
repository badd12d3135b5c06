#pragma once
#include "cases/app/scene.hpp"
#include "structure/gmsh.hpp"
#include "structure/pressure_load.hpp"
#include "structure/scheme.hpp"

namespace velum::cases {

/// What a body is made of: line elements in the meridional plane or the plane, or triangles in
/// space.
enum class Elements { lines, triangles };
enum class BodyShape { disc, annulus, strip, tube, mesh };
using structure::Side;
enum class LoadScale { membrane, plate };

/// A flat body across the first axis, a tube about it, or a surface of triangles from a file; held
/// along its whole rim, or where the scene says. Lengths in metres.
struct SoftBody {
  Elements elements;
  BodyShape shape;
  std::string material;
  double position = 0;      // of its plane along the first axis; of a tube's begin
  double inner = 0, outer;  // disc, annulus: radii; tube: outer its radius; strip: range of y
  double length = 0;        // tube: along the axis; strip of triangles: along z
  Curve thickness;          // undeformed, over the radius or y; of a tube along the axis
  double element = 0;       // largest length of an element
  std::string file{};       // mesh: of Gmsh, beside the scene,
  structure::GmshMesh mesh{};
  std::vector<std::string> clamps{};  // its groups that are held; none: the whole rim
  Rim rim = Rim::clamped;
  Bending bending = Bending::auto_;
};

/// The states that a run goes through: the pressures in their order, then the volumes.
struct BodyLoad {
  std::vector<double> pressures;  // on one side, towards the other
  Side side = Side::minus;
  std::vector<double> volumes;  // enclosed between the body and its undeformed state
};

/// A pressure that changes in time, and how the motion under it is marched.
struct BodyMarch {
  Curve pressure;  // over time, on load.side
  double end, step;
  std::optional<structure::TimeScheme> scheme{};  // empty: the cheaper one
  int samples = 200;                              // rows of the series
};

/// What the deflection of the middle is compared with: a table of load and deflection, made
/// dimensionless as
///   membrane  p a / (mu H)       and  w / a
///   plate     p a^4 / (64 D H)   and  w / H,   D = mu H^3 / 3
/// a the radius or half the width of a strip, H the largest thickness.
struct BodyReference {
  std::string file{};
  LoadScale scale = LoadScale::membrane;
  std::optional<double> limit_load{};  // largest load on the path
  std::vector<double> frequencies{};   // omega a^2 sqrt(rho H / D), the slowest first
};

/// A body alone under given loads, fidelity "structure": what the scene file says, in SI, checked.
struct BodyScene {
  std::string name;
  SoftBody body;
  std::map<std::string, Material> materials{};
  std::vector<Solid> solids{};
  std::optional<ContactPair> contact{};
  BodyLoad load{};
  std::optional<BodyMarch> march{};  // in place of the states of the load
  int modes = 0;                     // vibrations of the undeformed body to find
  std::optional<BodyReference> reference{};
  SceneFile source{};
};

/// Whether a scene file says fidelity = "structure".
bool is_body_scene(std::filesystem::path const& file, std::vector<std::string> const& overrides);

/// Reads, merges the overrides into, and checks such a scene.
/// @throws core::InputError  one sentence with file, line, key, what is wrong and what is allowed
BodyScene read_body_scene(std::filesystem::path const& file,
                          std::vector<std::string> const& overrides = {});

inline Material const& material(BodyScene const& scene)
{
  return scene.materials.at(scene.body.material);
}

/// What the body spans: its radius, half the width of a strip, half the middle one of the three
/// lengths of a mesh.
double span(SoftBody const& body);

double slenderness(SoftBody const& body);
bool has_bending(SoftBody const& body);

}  // namespace velum::cases
