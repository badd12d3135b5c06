#pragma once
#include "core/vec.hpp"

#include <functional>
#include <vector>

namespace velum::core {

/// Rigid geometry as a function of the point: distance from the wall, positive in the fluid,
/// negative in the solid. Host only; what velum makes may be called from many threads at once.
/// Lengths are in whatever unit the shapes were given in.
template <int D>
using SignedDistance = std::function<double(Vec<double, D> const&)>;

/// Ball.  d = |p - c| - r
/// @throws InputError  the radius is not a positive number
SignedDistance<3> sphere(Vec3 const& centre, double radius);

/// Round rod with flat ends, whose axis goes from one end's centre to the other's. Distance exact
/// everywhere.
/// @throws InputError  the ends are the same point, or the radius is not a positive number
SignedDistance<3> cylinder(Vec3 const& from, Vec3 const& to, double radius);

/// Axis-parallel box from corner lo to corner hi: box<3>({0, 0, 0}, {1, 2, 3}). Distance exact
/// everywhere.
/// @throws InputError  lo is not below hi in all directions
template <int D>
SignedDistance<D> box(Vec<double, D> const& lo, Vec<double, D> const& hi);

/// Solid of any part: min of the distances. Exact outside; inside overlapping parts a lower bound
/// of the depth. No part at all is infinitely far from everywhere.
template <int D>
SignedDistance<D> unite(std::vector<SignedDistance<D>> parts);

/// Solid of a that is not in b: max(a, -b). Zero set and sign exact; away from the surface a lower
/// bound of the distance where the nearest point of one lies in the other.
template <int D>
SignedDistance<D> subtract(SignedDistance<D> a, SignedDistance<D> b);

/// The solid moved by the map p -> scale p + shift; distances scale with it. Turns metres into
/// lattice units and shifts geometry against the lattice.
/// @throws InputError  the scale is not a positive number
template <int D>
SignedDistance<D> scaled(SignedDistance<D> distance, double scale,
                         Vec<double, D> const& shift = {});

}  // namespace velum::core
