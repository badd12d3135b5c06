#pragma once
#include <vector>

#include "contact/surface_shape.hpp"
#include "contact/triangle_foot.hpp"

namespace velum::contact {

/// Part of a surface that a point may touch: triangles near to it that hang together.
struct Near {
  int point;
  int first, last;    ///< its triangles in NearList::triangles
  int side;           ///< of the surface that the point belongs to, 1 or -1; 0: not known yet
  double multiplier;  ///< lambda, pressure
  int held;           ///< the triangle whose plane stands for the part; -1: whichever is nearest
};

struct NearList {
  std::vector<Near> near;      ///< by point
  std::vector<int> triangles;  ///< ascending in each part
};

/// A point of a surface that may touch: where between the nodes of a triangle, the undeformed area
/// it stands for, half the thickness there.
struct SurfacePoint {
  core::Triangle nodes;
  std::array<double, 3> share;  ///< sum 1
  double area, half;
};

/// Frictionless contact between points of triangle surfaces and triangles of the same surfaces, of
/// other ones or of itself. Each point touches every part of a surface near it once, at the
/// nearest place:
///   gap g = signed distance to the part - half thickness of the point - half of the triangle,
///   energy A/2k (max(0, lambda - k g)^2 - lambda^2),
/// with the traction of penalty.hpp on the point along the normal and the opposite force on the
/// triangle's corners by their shares, so that the forces of a contact have neither sum nor moment
/// (Wriggers, Computational Contact Mechanics (2006), chapters 6 and 9).
///
/// Over the valley between two triangles the nearest place jumps from one to the other, and the
/// force with it. Points slide into such valleys, where Newton's method then finds no balance: it
/// needs `hold`, which keeps to the plane of the triangle that was nearest at follow(), and some
/// rounds of solving and following. An explicit scheme does without, and keeps the energy so.
///
/// The signs of the distances are those of the places last handed to follow(): a point that is
/// then on one side of a part is pushed back to that side, however far it has gone through. Each
/// part of the surface must have its plus side on one side, and bend by less than 60 degrees from
/// a triangle to the next.
///
/// A point never touches triangles of its own body that lie nearer than twice the sum of the half
/// thicknesses in the undeformed state: its neighbours.
struct SurfaceContact {
  std::vector<core::Triangle> triangles;
  std::vector<core::Vec3> reference;  ///< undeformed, of the nodes            [N]
  std::vector<int> body;              ///< of each node: which hang together   [N]
  std::vector<RimOf> rim;             ///< [T]
  std::vector<double> half;           ///< half thickness of each triangle     [T]
  std::vector<SurfacePoint> points;   ///< that touch
  double stiffness;                   ///< k, pressure per length
  bool hold = false;  ///< points keep to the plane of their triangle from follow() to follow()
  double skin;        ///< how far beyond touching parts are looked for: less than a half thickness
                      ///< makes many searches, more makes long lists

  std::vector<core::Vec3> place;    ///< of the nodes, last handed to follow()   [N]
  std::vector<core::Vec3> covered;  ///< the list holds all parts near these,    [N]
                                    ///< on the way there,
  double margin = 0;                ///< and near places less than half of this away
  NearList list;
};

/// Which points touch: those of both bodies, each standing for half its area, or those of the first
/// alone. A body against itself needs both.
enum class Passes { both, first };

/// How points are laid on the surfaces: each side of a triangle cut in so many parts, the points at
/// the corners of the small triangles (1: the nodes). A uniform pressure reaches flat triangles of
/// another size as nodal forces that are off by up to 1.8 times themselves with one part, 0.5 with
/// two, 0.13 with three and 0.12 with four, of both bodies' points and sizes in the ratio 2 : 3;
/// the resultant is exact. The coarser body's points alone make it twice as much, the finer's half
/// or less.
struct PointLayout {
  Passes passes = Passes::both;
  int per_side = 3;
};

/// Contact of surfaces that are at some places, where nothing has gone through. Bodies are numbered
/// by their first node.
/// @param half  half thickness of each triangle [T]
/// @throws InputError  the stiffness or a half thickness is not positive; less than one part per
///                     side; first alone of one body
SurfaceContact make_surface_contact(std::vector<core::Triangle> triangles,
                                    std::vector<core::Vec3> reference,
                                    std::vector<core::Vec3> const& place, std::vector<double> half,
                                    double stiffness, PointLayout const& layout = {});

/// Places of the points that touch.
std::vector<core::Vec3> point_places(SurfaceContact const& c, std::vector<core::Vec3> const& place);

/// Takes the places as those from which the sides are told, and looks for what is near. To be
/// called between steps or solves with places where nothing has gone through.
void follow(SurfaceContact& c, std::vector<core::Vec3> const& place);

/// Makes the list cover what may be met on the way from the places of follow() to these.
void cover(SurfaceContact& c, std::vector<core::Vec3> const& place);

/// A point and the place where it is nearest to a part.
struct SurfaceTouch {
  int near, triangle;
  Foot foot;
  SignedHeight height;
  double gap, traction;
};

/// All parts of the list that are pressed upon at these places.
std::vector<SurfaceTouch> touches(SurfaceContact const& c, std::vector<core::Vec3> const& place);

/// Nodes of a touch, those around the point and the corners of the triangle: how each moves the
/// point or its corner with it, and the force on it.
struct TouchForce {
  std::array<int, 6> node;
  std::array<double, 6> share;
  std::array<core::Vec3, 6> force;
};
TouchForce force(SurfaceContact const& c, SurfaceTouch const& t);

/// Derivative of the forces on the point and the three corners by their places, the part's nearest
/// place moving along with them: A (-k grad g grad g^T + t grad grad g), symmetric.
Matrix12 tangent(SurfaceContact const& c, SurfaceTouch const& t,
                 std::vector<core::Vec3> const& place);

/// Uzawa's update of all multipliers (augmented_lagrangian.hpp). Returns the largest change. Points
/// of both bodies, or more of them than nodes, hold back more than the nodes can move: penetration
/// and resultant are exact then, a single multiplier is not. For pressures take one part per side,
/// and the points of one body.
double update_multipliers(SurfaceContact& c, std::vector<core::Vec3> const& place);

/// What touches in all. Energy is that of the penalty where there are no multipliers.
struct SurfaceSum {
  double area = 0;             ///< of the points that touch
  core::Vec3 force = {};       ///< on the first body, from all passes
  double penetration = 0;      ///< the largest, 0 where nothing penetrates
  double largest = 0;          ///< traction
  double complementarity = 0;  ///< largest |t g| of what touches
  double energy = 0;
};
SurfaceSum sum_up(SurfaceContact const& c, std::vector<core::Vec3> const& place);

}  // namespace velum::contact
