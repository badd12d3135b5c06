#pragma once
#include "structure/sheet.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace velum::structure {

/// A surface from a file of Gmsh, and what was done to get it.
struct GmshMesh {
  TriangleMesh mesh;  ///< metres; neighbours agree about the plus side
  /// Points of every named physical group of lines or surfaces, ascending; points of the group that
  /// belong to no triangle are not among them.
  std::map<std::string, std::vector<int>> groups;
  std::string format;    ///< "MSH 4.1, binary"
  int points = 0;        ///< elements left out: points,
  int lines = 0;         ///< lines,
  int stray_lines = 0;   ///< of them those that are no edge of a triangle,
  int repeated = 0;      ///< triangles given more than once, as for each of their groups
  int unused_nodes = 0;  ///< nodes of no triangle, left out
  int flipped = 0;       ///< triangles turned over to agree with their neighbours
};

/// Surface of 3-node triangles in a MSH file of Gmsh, version 2.2 or 4.1, ASCII or binary
/// (little-endian). Format: Gmsh reference manual, "MSH file format"; Geuzaine and Remacle, Int. J.
/// Numer. Meth. Eng. 79 (2009), doi:10.1002/nme.2579. Points keep the order of the file's nodes,
/// whose tags may be in any order and leave gaps. Points and lines of the file are left out;
/// sections that tell nothing of the surface are skipped. Triangles are the way round that their
/// (first) physical group has them.
/// @param unit  metres in one unit of the file, which MSH does not tell: 1e-3 for millimetres
/// @throws InputError  with the line (ASCII) or the byte (binary): missing, truncated or garbled
///                     file; another version or byte order; elements other than 3-node triangles,
///                     2-node lines and points; a name given to lines and to surfaces; and what
///                     agree_on_sides() refuses
GmshMesh read_gmsh(std::filesystem::path const& file, double unit);

/// The same of a file's bytes. @param name  the file's, for the sentences
GmshMesh parse_gmsh(std::string bytes, std::string const& name, double unit);

}  // namespace velum::structure
