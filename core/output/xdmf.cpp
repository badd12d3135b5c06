#include "core/output/xdmf.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>

namespace velum::core::xdmf {
namespace {

std::string data_item(Array const& array)
{
  return fmt::format(
      "<DataItem Dimensions=\"{}\" NumberType=\"{}\" Precision=\"{}\" Format=\"HDF\">{}</DataItem>",
      fmt::join(array.extents, " "), array.number_type, array.precision, array.location);
}

std::string attributes(std::vector<Array> const& arrays, std::string_view centre)
{
  std::string text;
  for (auto const& array : arrays)
    text += fmt::format(
        "        <Attribute Name=\"{}\" AttributeType=\"{}\" Center=\"{}\">{}</Attribute>\n",
        array.name, array.components == 3 ? "Vector" : "Scalar", centre, data_item(array));
  return text;
}

}  // namespace

std::string fluid(Grid const& grid, std::vector<Array> cell_arrays)
{
  bool const flat = dimensions(grid.symmetry) == 2;
  if (flat)
    for (auto& array : cell_arrays) array.extents.insert(array.extents.begin(), 1);
  // Extents count nodes, slowest direction first. A layer without thickness makes the XDMF 2 reader
  // of VTK 9.1 lose its cell data, and it draws a 2DCoRectMesh in the wrong plane.
  return fmt::format(R"(      <Grid Name="fluid" GridType="Uniform">
        <Topology TopologyType="3DCoRectMesh" Dimensions="{} {} {}"/>
        <Geometry GeometryType="ORIGIN_DXDYDZ">
          <DataItem Dimensions="3" NumberType="Float" Precision="8" Format="XML">{} {} {}</DataItem>
          <DataItem Dimensions="3" NumberType="Float" Precision="8" Format="XML">{} {} {}</DataItem>
        </Geometry>
{}      </Grid>
)",
                     grid.nz + 1, grid.ny + 1, grid.nx + 1, flat ? -grid.dx : grid.origin[2],
                     grid.origin[1], grid.origin[0], grid.dx, grid.dx, grid.dx,
                     attributes(cell_arrays, "Cell"));
}

std::string curve(std::string const& name, Array const& nodes, Array const& node_list,
                  std::vector<Array> const& node_arrays)
{
  return fmt::format(R"(      <Grid Name="{}" GridType="Uniform">
        <Topology TopologyType="Polyline" NumberOfElements="1" NodesPerElement="{}">{}</Topology>
        <Geometry GeometryType="XYZ">{}</Geometry>
{}      </Grid>
)",
                     name, nodes.extents.front(), data_item(node_list), data_item(nodes),
                     attributes(node_arrays, "Node"));
}

std::string surface(std::string const& name, Array const& nodes, Array const& triangles,
                    std::vector<Array> const& node_arrays)
{
  return fmt::format(R"(      <Grid Name="{}" GridType="Uniform">
        <Topology TopologyType="Triangle" NumberOfElements="{}">{}</Topology>
        <Geometry GeometryType="XYZ">{}</Geometry>
{}      </Grid>
)",
                     name, triangles.extents.front(), data_item(triangles), data_item(nodes),
                     attributes(node_arrays, "Node"));
}

std::string at_time(double time, std::string const& members)
{
  return fmt::format(R"(    <Grid Name="state" GridType="Collection" CollectionType="Spatial">
      <Time Value="{}"/>
{}    </Grid>
)",
                     time, members);
}

std::string index(std::string const& times)
{
  return R"(<?xml version="1.0" ?>
<Xdmf Version="2.0">
  <Domain>
  <Grid Name="run" GridType="Collection" CollectionType="Temporal">
)" + times +
         R"(  </Grid>
  </Domain>
</Xdmf>
)";
}

}  // namespace velum::core::xdmf
