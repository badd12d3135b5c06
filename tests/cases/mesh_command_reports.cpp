#include "structure/sheet_mesh.hpp"
#include "tests/core/scratch.hpp"
#include "tests/core/stl_files.hpp"
#include "tests/structure/gmsh_files.hpp"
#include "tests/support/program.hpp"

#include <gtest/gtest.h>

namespace velum::tests {
namespace {

struct MeshCommand : testing::Test {
  Scratch scratch{"mesh_command"};
  std::string file = (scratch.folder / "disc.msh").string();

  void SetUp() override { save(structure::disc_mesh(structure::graded(0, 8.25, 4))); }

  void save(structure::TriangleMesh const& mesh)
  {
    write(file, msh(MshContents(mesh), {41, true}));
  }
  Outcome run(std::string const& options, std::string const& name = "") const
  {
    return velum_program("mesh " + (name.empty() ? file : name) + " --threads 1 " + options);
  }
  /// Claims a report with these words.
  void expect_said(Outcome const& outcome, std::string const& words) const
  {
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_NE(outcome.text.find(words), std::string::npos) << outcome.text;
  }
};

TEST_F(MeshCommand, ReportsTheMeshAndItsGroups)
{
  auto const outcome = run("--unit mm");
  expect_said(outcome, "surface   96 triangles on 61 points in 1 part; open, with 1 rim\n");
  expect_said(outcome, "size      0 x 16.5 x 16.5 mm, from (0, -8.25, -8.25) mm to");
  expect_said(outcome, "file      MSH 4.1, binary\n          points left out: 1\n");
  expect_said(outcome, "group     \"rim\": 24 points\n");
  EXPECT_EQ(outcome.text.find("warning"), std::string::npos) << outcome.text;
  expect_said(run("--unit \"25.4 mm\""), "0 x 419.1 x 419.1 mm");
}

TEST_F(MeshCommand, WarnsOfThinTriangles)
{
  save(structure::strip_mesh({0, 1, 1.1}, {0, 1, 2}));
  expect_said(run("--unit mm"), "warning: the smallest angle is 5.7 degrees, below 15, of");
}

TEST_F(MeshCommand, SpeaksJson)
{
  auto const outcome = run("--unit mm --json");
  expect_said(outcome, "{\"file\": \"" + file + "\",\n \"format\": \"MSH 4.1, binary\",");
  expect_said(outcome, "\"triangles\": 96,");
  expect_said(outcome, "\"groups\": {\"rim\": 24, \"sheet\": 61},\n \"warnings\": []}\n");
}

TEST_F(MeshCommand, RefusesBadInputInASentence)
{
  EXPECT_EQ(run("").exit_code, 2);
  auto const mass = run("--unit kg");
  EXPECT_EQ(mass.exit_code, 2);
  EXPECT_NE(mass.text.find("--unit: \"1 kg\" is a mass"), std::string::npos) << mass.text;
  auto const missing = run("--unit mm", "no_such.msh");
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_EQ(missing.text, "no_such.msh: there is no such mesh file.\n");
  write(file, "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 2\n");
  for (std::string const options : {"--unit mm", "--unit mm --json"}) {
    auto const cut = run(options);
    EXPECT_EQ(cut.exit_code, 2);
    EXPECT_EQ(cut.text, file +
                            ":6: the file ends where it should have the smallest or largest "
                            "tag.\n");
  }
}

}  // namespace
}  // namespace velum::tests
