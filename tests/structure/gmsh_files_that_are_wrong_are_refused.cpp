// problem:   files that hold no surface of triangles, that end too early, or whose bytes are
// damaged reference: the sentence; for damage, that there is one, or a mesh measure:   the text of
// core::InputError; what is thrown, and the numbers of what is read tolerance: none why:       a
// file comes from another program and may be anything
#include <gtest/gtest.h>

#include <random>

#include "core/check.hpp"
#include "structure/gmsh.hpp"
#include "structure/sheet_mesh.hpp"
#include "tests/structure/gmsh_files.hpp"

namespace velum::structure {
namespace {

using tests::msh, tests::MshContents;

struct WrongGmsh : testing::Test {
  std::string const text22 = msh(small(), {22, false}), text41 = msh(small(), {41, false});

  static MshContents small() { return MshContents(disc_mesh({0, 1})); }

  /// The sentence that refuses these bytes; empty when they are read.
  static std::string refusal(std::string const& bytes)
  {
    try {
      parse_gmsh(bytes, "sheet.msh", 1);
    } catch (core::InputError const& error) {
      return error.what();
    }
    return "";
  }

  static std::string edited(std::string text, std::string const& before, std::string const& after)
  {
    auto const at = text.find(before);
    EXPECT_NE(at, std::string::npos) << before;
    return text.replace(at, before.size(), after);
  }

  /// Reads what may be anything. @return whether it was a mesh, which then must be sound
  static bool reads_or_refuses(std::string const& bytes)
  {
    try {
      auto const back = parse_gmsh(bytes, "sheet.msh", 1);
      EXPECT_TRUE(back.mesh.points.allFinite());
      EXPECT_NO_THROW(neighbours(back.mesh));
      return true;
    } catch (core::InputError const&) {
      return false;
    }
  }
};

TEST_F(WrongGmsh, other_formats_are_refused_with_what_to_do)
{
  EXPECT_EQ(refusal(""), "sheet.msh: the file is empty, and a MSH file holds a mesh.");
  EXPECT_EQ(refusal("solid a\n"),
            "sheet.msh:1: the file does not begin with $MeshFormat, with which a mesh file of Gmsh "
            "begins.");
  EXPECT_EQ(refusal("$NOD\n1\n"),
            "sheet.msh:1: this is MSH 1; save it with \"gmsh -2 -format msh41\" (or msh22), in "
            "ASCII or binary.");
  EXPECT_EQ(refusal("$MeshFormat\n4 0 8\n"),
            "sheet.msh:2: the version of the format is not one of those read, 2.2 and 4.1; save it "
            "with \"gmsh -2 -format msh41\" (or msh22), in ASCII or binary.");
  EXPECT_EQ(refusal("$MeshFormat\n4.1 1 4\n"),
            "sheet.msh:2: numbers of a binary MSH file have 8 bytes.");
  EXPECT_EQ(refusal(std::string("$MeshFormat\n4.1 1 8\n\0\0\0\1\n", 24)),
            "sheet.msh: at byte 20: the file comes from a machine of the other byte order "
            "(big-endian); save it in ASCII.");
  EXPECT_THROW(
      try { read_gmsh("no_such.msh", 1); } catch (core::InputError const& error) {
        EXPECT_STREQ(error.what(), "no_such.msh: there is no such mesh file.");
        throw;
      },
      core::InputError);
  EXPECT_THROW(read_gmsh(std::filesystem::temp_directory_path(), 1), core::InputError);
  EXPECT_THROW(parse_gmsh(text22, "sheet.msh", 0), core::InputError);
}

TEST_F(WrongGmsh, elements_of_other_kinds_are_refused_by_name)
{
  auto const refused = [&](std::string const& type, std::string const& words) {
    auto const sentence = refusal(edited(text22, "8 2 2 3 1", "8 " + type + " 2 3 1"));
    EXPECT_EQ(sentence.substr(0, 13), "sheet.msh:29:");
    EXPECT_NE(sentence.find(words), std::string::npos) << sentence;
  };
  refused("3",
          "the file has quadrilaterals, and a sheet is made of 3-node triangles: mesh without");
  refused("4",
          "the file has tetrahedra, and a sheet is made of 3-node triangles: save the surface");
  refused("9", "the file has second-order triangles (6 nodes), and");
  refused("9", "save first-order triangles (Mesh.ElementOrder = 1).");
  refused("8", "the file has second-order lines, and");
  refused("21", "the file has elements of type 21, and");
  EXPECT_NE(refusal(edited(text41, "2 1 2 6", "2 1 9 6")).find("second-order triangles"),
            std::string::npos);
}

TEST_F(WrongGmsh, sections_that_cannot_be_read_are_refused_with_what_to_do)
{
  EXPECT_NE(refusal(edited(text22, "$Nodes", "$ParametricNodes")).find("Mesh.SaveParametric = 0"),
            std::string::npos);
  EXPECT_NE(refusal(edited(text41, "$Entities", "$PartitionedEntities")).find("in partitions"),
            std::string::npos);
  EXPECT_EQ(refusal(text22.substr(0, text22.find("$Elements"))),
            "sheet.msh: the file has no section $Elements: it is truncated, or holds no mesh.");
  EXPECT_NE(refusal(text22 + text22.substr(text22.find("$Elements")))
                .find("a second $Elements; a MSH file has one."),
            std::string::npos);
}

TEST_F(WrongGmsh, words_out_of_place_are_refused_with_their_line)
{
  EXPECT_EQ(refusal(edited(text22, "-9 -9 -9", "-9 -9 x")),
            "sheet.msh:11: \"x\" stands where a MSH file has a coordinate of a node.");
  EXPECT_EQ(refusal(edited(text22, "-9 -9 -9", "-9 -9 nan")),
            "sheet.msh:11: a coordinate of a node is not a finite number.");
  EXPECT_EQ(refusal(edited(text22, "$EndNodes", "9 0 0 0\n$EndNodes")),
            "sheet.msh:19: \"9\" stands where a MSH file has $EndNodes.");
  EXPECT_EQ(refusal(edited(text22, "1 7 \"rim\"", "1 7 rim")),
            "sheet.msh:6: the name of a physical group stands in quotes.");
  EXPECT_EQ(refusal(edited(text22, "\"rim\"", "\"sheet\"")),
            "sheet.msh: two physical groups of lines or surfaces are named \"sheet\"; give each a "
            "name of its own.");
}

TEST_F(WrongGmsh, nodes_that_do_not_fit_are_refused)
{
  EXPECT_EQ(refusal(edited(text22, "\n3 ", "\n2 ")), "sheet.msh: node 2 is given twice.");
  EXPECT_EQ(refusal(edited(text22, "\n3 ", "\n33 ")),
            "sheet.msh: element 2 has the node 3, which the file does not give.");
  EXPECT_EQ(refusal(edited(text22, "8 2 2 3 1 2 3 4", "8 2 2 3 1 2 3 3")),
            "sheet.msh: element 8 is a triangle that has a node twice.");
  EXPECT_EQ(refusal(edited(text22, "\n3 ", "\n-3 ")),
            "sheet.msh:13: a tag of a node or element is a whole number above 0.");
}

TEST_F(WrongGmsh, promises_that_are_not_kept_are_refused_at_once)
{
  EXPECT_EQ(refusal(edited(text22, "$Nodes\n8", "$Nodes\n800000000000000")),
            "sheet.msh:19: \"$EndNodes\" stands where a MSH file has the tag of a node.");
  EXPECT_EQ(refusal(edited(text41, "2 8 1 9999", "2 7 1 9999")),
            "sheet.msh:34: the section promises 7 nodes, but its blocks have 8.");
  auto const binary = msh(small(), {41, true});
  auto const at = binary.find("$Nodes\n") + 7;
  auto more = binary;
  more.replace(at, 16, 16, '\x7f');  // blocks and nodes
  EXPECT_NE(refusal(more), "");
  auto const block = binary.find("$Elements\n") + 10 + 32 + 12;
  more = binary;
  more.replace(block, 8, 8, '\x7f');  // elements of the first block
  EXPECT_NE(refusal(more), "");
}

TEST_F(WrongGmsh, surfaces_without_two_sides_are_refused_by_the_file)
{
  auto contents = small();
  contents.mesh.triangles.push_back({0, 1, 4});  // a third triangle at two spokes
  EXPECT_EQ(refusal(msh(contents, {22, true})).substr(0, 27), "sheet.msh: An edge of the m");
}

TEST_F(WrongGmsh, files_cut_off_anywhere_are_refused)
{
  for (auto const& format : tests::msh_formats) {
    auto const whole = msh(small(), format);
    auto const enough = whole.find("$EndElements") + std::string("$EndElements").size();
    for (std::size_t length = 0; length < whole.size(); ++length)
      EXPECT_EQ(reads_or_refuses(whole.substr(0, length)), length >= enough) << length;
  }
}

TEST_F(WrongGmsh, damaged_bytes_give_a_sentence_or_a_mesh)
{
  std::mt19937 engine{7};
  std::uniform_int_distribution<int> byte(1, 255);
  for (auto const& format : tests::msh_formats) {
    auto const whole = msh(small(), format);
    for (std::size_t at = 0; at < whole.size(); ++at)
      for (int const mask : {0x01, 0x80, byte(engine)}) {
        auto bytes = whole;
        bytes[at] = static_cast<char>(bytes[at] ^ mask);
        reads_or_refuses(bytes);
      }
  }
}

}  // namespace
}  // namespace velum::structure
