#include "contact/triangle_foot.hpp"

#include <cmath>

namespace velum::contact {
namespace {

using core::Vec3;

constexpr double steep = 0.5;  // cosine of 60 degrees

/// Gradients of the three shape functions along the part of the triangle that is nearest.
core::Facet shape_gradients(core::Facet const& c, Foot const& f)
{
  core::Facet b{};
  auto const k = static_cast<std::size_t>(f.k), next = (k + 1) % 3;
  if (f.part == core::Part::edge) {
    Vec3 const e = c[next] - c[k];
    b[next] = 1 / dot(e, e) * e;
    b[k] = -1 * b[next];
  } else if (f.part == core::Part::face) {
    Vec3 const n = cross(c[1] - c[0], c[2] - c[0]);
    for (std::size_t i = 0; i < 3; ++i)
      b[i] = 1 / dot(n, n) * cross(n, c[(i + 2) % 3] - c[(i + 1) % 3]);
  }
  return b;
}

/// P of second_derivative().
std::array<Vec3, 3> across(core::Facet const& c, Foot const& f, Vec3 const& n)
{
  std::array<Vec3, 3> rows{};
  if (f.part == core::Part::edge) {
    auto const k = static_cast<std::size_t>(f.k);
    Vec3 const e = c[(k + 1) % 3] - c[k], m = 1 / norm(e) * cross(e, n);
    for (std::size_t i = 0; i < 3; ++i) rows[i] = m[static_cast<int>(i)] * m;
  } else if (f.part == core::Part::corner) {
    for (std::size_t i = 0; i < 3; ++i) {
      rows[i] = -n[static_cast<int>(i)] * n;
      rows[i][static_cast<int>(i)] += 1;
    }
  }
  return rows;
}

/// Height over an edge or a corner: as far as q, with the sign of the surface's normal there.
void rise(Foot& f, Vec3 const& arm, core::Facet const& normals)
{
  Vec3 const normal =
      f.weight[0] * normals[0] + f.weight[1] * normals[1] + f.weight[2] * normals[2];
  double const distance = norm(arm), over = dot(normal, arm);
  f.cosine = distance > 0 ? std::abs(over) / (norm(normal) * distance) : 1;
  f.clear = f.cosine >= steep;
  f.height = over < 0 ? -distance : distance;
  f.up = distance > 0 ? 1 / f.height * arm : 1 / norm(normal) * normal;
}

}  // namespace

Foot foot_on_plane(core::Facet const& c, Vec3 const& x)
{
  Foot f{core::Part::face, 0, {}, 0, {}, 1, true};
  auto const b = shape_gradients(c, f);
  f.weight[1] = dot(b[1], x - c[0]);
  f.weight[2] = dot(b[2], x - c[0]);
  f.weight[0] = 1 - f.weight[1] - f.weight[2];
  Vec3 const n = cross(c[1] - c[0], c[2] - c[0]);
  f.up = 1 / norm(n) * n;
  f.height = dot(f.up, x - c[0]);
  return f;
}

Foot foot(core::Facet const& c, Vec3 const& x, core::Facet const& normals)
{
  auto const nearest = core::closest_point({c[0], c[1] - c[0], c[2] - c[0]}, x);
  if (nearest.part == core::Part::face) return foot_on_plane(c, x);
  Foot f{nearest.part, nearest.k, {}, 0, {}, 1, true};
  auto const k = static_cast<std::size_t>(f.k), next = (k + 1) % 3;
  if (f.part == core::Part::edge) {
    Vec3 const e = c[next] - c[k];
    f.weight[next] = dot(e, x - c[k]) / dot(e, e);
    f.weight[k] = 1 - f.weight[next];
  } else {
    f.weight[k] = 1;
  }
  rise(f, x - f.weight[0] * c[0] - f.weight[1] * c[1] - f.weight[2] * c[2], normals);
  return f;
}

SignedHeight signed_height(Foot const& f, int side)
{
  int const sign = side != 0 && f.clear ? side : f.height < 0 ? -1 : 1;
  return {sign * f.height, sign * f.up};
}

Matrix12 second_derivative(core::Facet const& corners, Foot const& f, SignedHeight const& h)
{
  auto const gradient = shape_gradients(corners, f);
  std::array<double, 4> const w{1, -f.weight[0], -f.weight[1], -f.weight[2]};
  std::array<Vec3, 4> const b{Vec3{}, gradient[0], gradient[1], gradient[2]};
  auto const& n = h.normal;
  auto const P = across(corners, f, n);
  double const bent = h.distance != 0 ? 1 / h.distance : 0;
  Matrix12 H;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      double const turned = h.distance * dot(b[i], b[j]);
      for (int r = 0; r < 3; ++r)
        for (int s = 0; s < 3; ++s)
          H[3 * i + static_cast<std::size_t>(r)][3 * j + static_cast<std::size_t>(s)] =
              -w[j] * n[r] * b[i][s] - w[i] * b[j][r] * n[s] - turned * n[r] * n[s] +
              w[i] * w[j] * bent * P[static_cast<std::size_t>(r)][s];
    }
  return H;
}

}  // namespace velum::contact
