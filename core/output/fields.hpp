#pragma once
#include "core/grid.hpp"
#include "core/output/summary.hpp"
#include "core/vec.hpp"

#include <cstdint>
#include <filesystem>
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

/// The fields of a run: run.h5 with the arrays, run.xmf with the XDMF 2.0 index that viewers open.
///
/// In run.h5: group dump_000000, ... with attribute `time`, in it the group `fluid` and one group
/// per curve, in these the arrays, each with attribute `unit`. Fluid arrays have shape [ny][nx], in
/// space [nz][ny][nx], or that with [3] behind; a curve has `nodes` [n][3] besides. Attributes of
/// the root: grid, symmetry and the run's assumptions in words.
///
/// Both files are complete on the disk, and closed, between two dumps, so that a running or a
/// crashed run opens.
struct FieldsFile {
  std::filesystem::path data, index;
  Grid grid;          // m
  int dumps = 0;      // written so far
  std::string times;  // the part of the index that describes them
};

/// Starts both files in a folder that exists (see make_folder).
/// @param grid  in metres
/// @throws InputError  they cannot be written
FieldsFile create_fields(std::filesystem::path const& folder, Grid const& grid,
                         Assumptions const& assumptions);

/// Adds the state at a time (s) to both files.
/// @throws InputError  they cannot be written; an array of the wrong length; a name that is taken
///                     or has other characters than letters, digits, '_' and '-'
void write_fields(FieldsFile& file, double time, std::vector<Field> const& fluid,
                  std::vector<Curve> const& curves);

}  // namespace velum::core
