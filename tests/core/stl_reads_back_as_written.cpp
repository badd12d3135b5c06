#include "core/check.hpp"
#include "core/geometry/stl.hpp"
#include "tests/core/scratch.hpp"
#include "tests/core/stl_files.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace velum::tests {
namespace {

using namespace core;

struct Stl : testing::Test {
  Scratch scratch{"stl"};

  TriangleMesh read(std::string const& bytes, double unit = 1)
  {
    return read_stl(write(scratch.folder / "part.stl", bytes), unit);
  }

  /// The sentence that refuses these bytes, without the folder's name; empty when they are read.
  std::string refusal(std::string const& bytes)
  {
    try {
      read(bytes);
    } catch (InputError const& error) {
      return std::string(error.what()).substr(scratch.folder.string().size() + 1);
    }
    return "";
  }
};

Facets const cube = cuboid({0, 0, 0}, {2, 2, 2});

TEST_F(Stl, binary_and_ascii_give_the_same_mesh_with_shared_vertices)
{
  auto const facets = ball({0.1, -0.2, 0.3}, 1.7, 3);
  auto const binary = read(binary_stl(facets)), ascii = read(ascii_stl(facets));
  ASSERT_EQ(binary.triangles.size(), 512u);
  EXPECT_EQ(binary.vertices.size(), 258u);  // Euler: V = 2 + F / 2
  EXPECT_EQ(binary.triangles, ascii.triangles);
  ASSERT_EQ(binary.vertices.size(), ascii.vertices.size());
  for (std::size_t k = 0; k < binary.vertices.size(); ++k)
    EXPECT_LT(norm(binary.vertices[k] - ascii.vertices[k]), 1e-7);
  for (std::size_t t = 0; t < facets.size(); ++t)
    EXPECT_LT(norm(facet(binary, static_cast<int>(t))[1] - facets[t][1]), 1e-6);
}

TEST_F(Stl, binary_file_may_begin_with_solid)
{
  EXPECT_EQ(read(binary_stl(cube, "solid cube, as some programs write")).triangles.size(), 12u);
}

TEST_F(Stl, lengths_are_in_the_unit_that_the_user_says)
{
  EXPECT_DOUBLE_EQ(bounds(read(binary_stl(cube), 1e-3)).hi[0], 2e-3);
  EXPECT_DOUBLE_EQ(area(read(ascii_stl(cube), 1e-3)), 24e-6);
}

TEST_F(Stl, ascii_is_read_in_capitals_in_windows_lines_and_in_several_solids)
{
  std::string const facet =
      "FACET NORMAL nan nan nan\r\nOUTER LOOP\r\nVERTEX 0 0 0\r\nVERTEX +1e0 0 0\r\n"
      "VERTEX 0 1.0E+00 0\r\nENDLOOP\r\nENDFACET\r\n";
  EXPECT_EQ(
      read("SOLID a\r\n" + facet + "ENDSOLID a\r\nsolid\r\n" + facet + "endsolid").triangles.size(),
      2u);
}

TEST_F(Stl, corners_within_single_precision_are_one_vertex)
{
  Facets apart = cube;
  for (auto& f : apart) f[1][0] *= 1 + 1e-7;
  EXPECT_EQ(merge(apart).vertices.size(), 8u);
}

TEST_F(Stl, triangles_without_area_are_left_out_and_counted)
{
  Vec3 const a{0, 0, 0}, b{2, 0, 0}, middle{1, 0, 0};
  auto const mesh = read(binary_stl(cube + Facets{{a, a, b}, {a, b, middle}}));
  EXPECT_EQ(mesh.triangles.size(), 12u);
  EXPECT_EQ(mesh.degenerate, 2);
  EXPECT_EQ(mesh.needles.size(), 1u);
  EXPECT_EQ(refusal(binary_stl({{a, b, middle}})),
            "part.stl: none of the 1 triangles has an area.");
}

TEST_F(Stl, missing_file_is_refused)
{
  EXPECT_THROW(
      try { read_stl("no_such_part.stl", 1); } catch (InputError const& error) {
        EXPECT_STREQ(error.what(), "no_such_part.stl: there is no such STL file.");
        throw;
      },
      InputError);
  EXPECT_THROW(read_stl(scratch.folder, 1), InputError);
  EXPECT_THROW(read_stl(write(scratch.folder / "a.stl", binary_stl(cube)), 0), InputError);
}

TEST_F(Stl, truncated_binary_is_refused_with_its_lengths)
{
  auto const whole = binary_stl(cube, "solid");
  EXPECT_EQ(refusal(whole.substr(0, 400)),
            "part.stl: the header promises 12 triangles, which take 684 bytes, but the file has "
            "400: it is truncated, or no STL file.");
  EXPECT_EQ(refusal(whole + "!"),
            "part.stl: the header promises 12 triangles, which take 684 bytes, but the file has "
            "685: it holds something else besides, or is no STL file.");
  EXPECT_EQ(refusal(whole.substr(0, 60)),
            "part.stl: the file has 60 bytes; a binary STL file has at least 84, and an ASCII one "
            "holds text only.");
  EXPECT_EQ(refusal(""), "part.stl: the file is empty, and an STL file holds triangles.");
}

TEST_F(Stl, wrong_word_in_ascii_is_refused_with_its_line)
{
  auto text = ascii_stl(cube);
  EXPECT_EQ(refusal(text.replace(text.find("vertex"), 6, "vertx")),
            "part.stl:4: \"vertx\" stands where an ASCII STL file has \"vertex\".");
  EXPECT_EQ(refusal("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0,5 0\n"),
            "part.stl:4: \"0,5\" stands where an ASCII STL file has a number.");
  EXPECT_EQ(refusal("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1"),
            "part.stl:5: the file ends where an ASCII STL file has a number.");
  EXPECT_EQ(refusal("# a picture\n"),
            "part.stl:1: \"#\" stands where an ASCII STL file has \"solid\".");
}

TEST_F(Stl, corner_that_is_not_finite_is_refused_with_its_place)
{
  auto facets = cube;
  facets[6][2][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal(binary_stl(facets)),
            "part.stl: triangle 7 of 12 has a corner that is not a finite number.");
  EXPECT_EQ(refusal("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 nan 0\n"),
            "part.stl:4: \"nan\" is not a finite number, and a corner needs three.");
}

TEST_F(Stl, file_without_triangles_is_refused)
{
  EXPECT_EQ(refusal(binary_stl({})), "part.stl: the file holds no triangles.");
  EXPECT_EQ(refusal(ascii_stl({})), "part.stl: the file holds no triangles.");
}

}  // namespace
}  // namespace velum::tests
