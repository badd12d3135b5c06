// problem:   meshes made in the program, written as Gmsh does in versions 2.2 and 4.1 of its
// format,
//            ASCII and binary, and read; a disc of rubber inflated on such a mesh
// reference: the mesh as made; the disc inflated on it
// measure:   points, triangles, groups; largest distance of two nodes over the radius
// tolerance: none; 1e-12 of the radius where nodes are shuffled
// why:       the shortest decimals and the bytes of a double read back as the same double; another
//            order of nodes changes round-off alone, which the equilibrium enlarges
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "core/check.hpp"
#include "structure/gmsh.hpp"
#include "structure/sheet_mesh.hpp"
#include "structure/sheet_pressure.hpp"
#include "structure/static_solve.hpp"
#include "tests/core/scratch.hpp"
#include "tests/core/stl_files.hpp"
#include "tests/structure/gmsh_files.hpp"

namespace velum::structure {
namespace {

using tests::msh, tests::MshContents, tests::MshFormat;

struct Gmsh : testing::Test {
  tests::Scratch scratch{"gmsh"};

  GmshMesh read(std::string const& bytes, double unit = 1)
  {
    return read_gmsh(tests::write(scratch.folder / "sheet.msh", bytes), unit);
  }
};

/// Nodes in a random order with tags that leave gaps, and which point of the first mesh each is.
std::pair<MshContents, std::vector<int>> shuffled(TriangleMesh const& mesh)
{
  std::vector<int> from(static_cast<std::size_t>(mesh.points.size() / 3));
  std::iota(from.begin(), from.end(), 0);
  std::mt19937 engine{3};
  std::ranges::shuffle(from, engine);
  MshContents contents(mesh);
  std::vector<int> to(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    contents.mesh.points.segment<3>(3 * static_cast<int>(i)) = node3(mesh.points, from[i]);
    to[static_cast<std::size_t>(from[i])] = static_cast<int>(i);
  }
  for (auto& t : contents.mesh.triangles)
    for (int& corner : t) corner = to[static_cast<std::size_t>(corner)];
  for (std::size_t i = 0; i < from.size(); ++i) contents.tags[i] = 2 + (i * 7919) % 9001;
  return {contents, from};
}

TEST_F(Gmsh, meshes_read_back_as_made_in_every_format)
{
  for (auto const& mesh : {disc_mesh(graded(0, 8.25, 4)), strip_mesh({0, 1, 3}, {-1, 0.1, 0.7, 2}),
                           tube_mesh(0.3, graded(0, 1, 3, 2), 7)})
    for (auto const& format : tests::msh_formats) {
      auto const back = read(msh(MshContents(mesh), format));
      EXPECT_EQ(back.mesh.points, mesh.points) << back.format;
      EXPECT_EQ(back.mesh.triangles, mesh.triangles) << back.format;
      EXPECT_EQ(back.format, fmt::format("MSH {}, {}", format.version == 22 ? "2.2" : "4.1",
                                         format.binary ? "binary" : "ASCII"));
    }
}

TEST_F(Gmsh, groups_hold_the_points_of_named_lines_and_surfaces)
{
  auto const mesh = disc_mesh(graded(0, 1, 3));
  for (auto const& format : tests::msh_formats) {
    auto const back = read(msh(MshContents(mesh), format));
    ASSERT_EQ(back.groups.size(), 2u);
    EXPECT_EQ(back.groups.at("rim"), rim_points(mesh));
    EXPECT_EQ(back.groups.at("sheet").size(), 37u);
  }
}

TEST_F(Gmsh, files_without_names_have_no_groups)
{
  for (auto const& format : tests::msh_formats) {
    auto bytes = msh(MshContents(disc_mesh({0, 1})), format);
    auto const from = bytes.find("$PhysicalNames"), to = bytes.find("$EndPhysicalNames");
    bytes.erase(from, to - from + std::string("$EndPhysicalNames\n").size());
    EXPECT_TRUE(read(bytes).groups.empty());
  }
}

TEST_F(Gmsh, surfaces_that_their_group_has_the_other_way_round_are_turned)
{
  auto mesh = disc_mesh(graded(0, 1, 2));
  MshContents contents(mesh);
  contents.sheet = -3;
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  for (bool const binary : {false, true}) {
    auto const back = read(msh(contents, {41, binary}));
    EXPECT_EQ(back.mesh.triangles, mesh.triangles);
    EXPECT_EQ(back.groups.at("sheet").size(), 19u);
  }
}

TEST_F(Gmsh, what_is_left_out_is_counted)
{
  for (auto const& format : tests::msh_formats) {
    auto const mesh = disc_mesh(graded(0, 1, 3));
    auto const back = read(msh(MshContents(mesh), format));
    EXPECT_EQ(back.points, 1);
    EXPECT_EQ(back.lines, 18);
    EXPECT_EQ(back.stray_lines, 0);
    EXPECT_EQ(back.unused_nodes, 1);
    EXPECT_EQ(back.repeated, 0);
    EXPECT_EQ(back.flipped, 0);
  }
}

TEST_F(Gmsh, triangles_given_once_for_each_group_are_one)
{
  MshContents contents(disc_mesh({0, 1}));
  auto bytes = msh(contents, {22, false});
  auto const at = bytes.find("$EndElements");
  bytes.insert(at, "20 2 2 3 1 4 2 3\n21 1 2 7 1 4 3\n22 1 2 7 1 2 2\n");
  bytes.replace(bytes.find("$Elements\n13"), 12, "$Elements\n16");
  auto const back = read(bytes);
  EXPECT_EQ(back.repeated, 1);
  EXPECT_EQ(back.mesh.triangles.size(), 6u);
  EXPECT_EQ(back.lines, 7);  // the rim's edge 4 - 3 was there; 2 - 2 is no edge
  EXPECT_EQ(back.stray_lines, 1);
}

TEST_F(Gmsh, sections_of_other_things_are_skipped)
{
  for (auto const& format : tests::msh_formats) {
    auto bytes = msh(MshContents(disc_mesh({0, 1})), format);
    std::string const other = "$NodeData\n1\n\"$End\"\n$EndNodeDatas \n$EndNodeData\n";
    bytes.insert(bytes.find("$Nodes"), other);
    EXPECT_EQ(read("\n" + bytes + other + "\n").mesh.triangles.size(), 6u);
  }
}

TEST_F(Gmsh, text_is_read_in_windows_lines)
{
  auto bytes = msh(MshContents(disc_mesh({0, 1})), {41, false});
  for (auto at = bytes.find('\n'); at != std::string::npos; at = bytes.find('\n', at + 2))
    bytes.replace(at, 1, "\r\n");
  EXPECT_EQ(read(bytes).groups.at("rim").size(), 6u);
}

TEST_F(Gmsh, tags_may_be_in_any_order_and_leave_gaps)
{
  auto const mesh = disc_mesh(graded(0, 1, 5));
  for (auto const& format : tests::msh_formats) {
    auto const [contents, from] = shuffled(mesh);
    auto const back = read(msh(contents, format));
    EXPECT_EQ(back.mesh.points, contents.mesh.points);
    EXPECT_EQ(back.mesh.triangles, contents.mesh.triangles);
  }
}

TEST_F(Gmsh, triangles_that_disagree_are_turned_over_and_counted)
{
  auto const mesh = disc_mesh(graded(0, 1, 4));
  MshContents contents(mesh);
  for (std::size_t t = 1; t < mesh.triangles.size(); t += 5)
    std::swap(contents.mesh.triangles[t][1], contents.mesh.triangles[t][2]);
  auto const back = read(msh(contents, {41, true}));
  EXPECT_EQ(back.flipped, 19);
  EXPECT_EQ(back.mesh.triangles, mesh.triangles);
}

/// A clamped disc under pressure.
Sheet inflated(TriangleMesh const& mesh, std::vector<int> const& rim, double radius)
{
  constexpr double mu = 1e6, H = 1e-3;
  Sheet s = make_sheet(mesh, H, {.c10 = mu / 2}, 1000);
  for (int const p : rim) clamp(s, p);
  Eigen::VectorXd const pressure =
      Eigen::VectorXd::Constant(element_count(s), -0.5 * mu * H / radius);
  std::array const loads{pressure_load(s, pressure)};
  static_solve(s, loads);
  return s;
}

TEST_F(Gmsh, disc_inflates_as_on_the_mesh_made_in_the_program)
{
  constexpr double a = 8.25e-3;
  auto const made = disc_mesh(graded(0, a, 8));
  auto const expected = inflated(made, rim_points(made), a);
  for (auto const& format : tests::msh_formats) {
    auto in_mm = made;
    in_mm.points *= 1e3;
    auto const [contents, from] = shuffled(in_mm);
    auto const back = read(msh(contents, format), 1e-3);
    auto const s = inflated(back.mesh, back.groups.at("rim"), a);
    double largest = 0;
    for (std::size_t i = 0; i < from.size(); ++i)
      largest = std::max(
          largest,
          (node3(s.position, static_cast<int>(i)) - node3(expected.position, from[i])).norm());
    EXPECT_LT(largest / a, 1e-12) << back.format;
  }
}

}  // namespace
}  // namespace velum::structure
