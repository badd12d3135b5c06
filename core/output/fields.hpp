#pragma once
#include "core/grid.hpp"
#include "core/output/summary.hpp"
#include "core/vec.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace velum::core {

/// One named array: `components` values for each cell of the fluid (i fastest) or each node of a
/// curve. The unit is SI, "1" for a plain number or a label.
struct Field {
  std::string name, unit;
  int components;  // 1, or 3 for a vector
  std::variant<std::vector<float>, std::vector<double>, std::vector<std::int32_t>> values;
};

/// A vector as a field of three components, as viewers want it; of the plane the third is zero.
Field vector_field(std::string name, std::string unit, std::vector<Vec2> const& values);
Field vector_field(std::string name, std::string unit, std::vector<Vec3> const& values);

/// A line drawn through nodes: the mid-surface of a membrane or one of its wet faces. The nodes may
/// move, and change in number, from dump to dump.
struct Curve {
  std::string name;
  std::vector<Vec2> nodes;    // m
  std::vector<Field> fields;  // one entry per node
};

/// Triangles between nodes of space: the mid-surface of a sheet.
struct Surface {
  std::string name;
  std::vector<Vec3> nodes;                             // m
  std::vector<std::array<std::int32_t, 3>> triangles;  // numbers of nodes
  std::vector<Field> fields;                           // one entry per node
};

/// The fields of a run: run.h5 with the arrays, run.xmf with the XDMF 2.0 index that viewers open.
///
/// In run.h5: group dump_000000, ... with attribute `time`, in it the group `fluid` and one group
/// per curve and surface, in these the arrays, each with attribute `unit`. Fluid arrays have shape
/// [ny][nx], in space [nz][ny][nx], or that with [3] behind; a curve or surface has `nodes` [n][3]
/// besides, a surface `triangles` [m][3]. Attributes of the root: grid, symmetry and the run's
/// assumptions in words. A run without fluid has neither grid nor group `fluid`.
///
/// Both files are complete on the disk, and closed, between two dumps, so that a running or a
/// crashed run opens.
struct FieldsFile {
  std::filesystem::path data, index;
  std::optional<Grid> grid;  // of the fluid, m
  int dumps = 0;             // written so far
  std::string times;         // the part of the index that describes them
};

/// Starts both files in a folder that exists (see make_folder).
/// @param grid  of the fluid in metres, if there is one
/// @throws InputError  they cannot be written
FieldsFile create_fields(std::filesystem::path const& folder, std::optional<Grid> const& grid,
                         Assumptions const& assumptions);

/// Goes on with the files of an earlier run, as FieldsFile was after `dumps` dumps: later ones are
/// dropped.
/// @param times  of that FieldsFile
/// @throws InputError  they are gone or damaged, or have fewer dumps
FieldsFile resume_fields(std::filesystem::path const& folder, std::optional<Grid> const& grid,
                         int dumps, std::string times);

/// Adds the state at a time (s) to both files.
/// @param fluid  arrays on the cells of the grid; none without one
/// @throws InputError  they cannot be written; an array of the wrong length; a name that is taken
///                     or has other characters than letters, digits, '_' and '-'
void write_fields(FieldsFile& file, double time, std::vector<Field> const& fluid,
                  std::vector<Curve> const& curves, std::vector<Surface> const& surfaces = {});

}  // namespace velum::core
