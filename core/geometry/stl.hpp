#pragma once
#include "core/geometry/triangle_mesh.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace velum::core {

/// Surface in an STL file (3D Systems, StereoLithography Interface Specification, 1989), binary or
/// ASCII. A file is binary when it is as long as its count of triangles says: its header may begin
/// with "solid" as an ASCII file does. Normals written in the file are not used; a triangle's
/// corners run counter-clockwise seen from outside. An ASCII file may hold several solids.
/// @param unit  metres in one unit of the file, which STL does not tell: 1e-3 for millimetres
/// @throws InputError  missing or unreadable file, wrong length, wrong word (with its line), a
///                     corner that is not finite, no triangle with an area
TriangleMesh read_stl(std::filesystem::path const& file, double unit);

/// Facets of an ASCII file's text; `name` is the file's in the messages.
std::vector<Facet> parse_ascii_stl(std::string_view text, std::string const& name);

}  // namespace velum::core
