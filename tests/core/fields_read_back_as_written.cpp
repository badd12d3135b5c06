#include "core/check.hpp"
#include "core/output/hdf5.hpp"
#include "tests/core/field_samples.hpp"
#include "tests/core/scratch.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <regex>
#include <sstream>

namespace velum::tests {
namespace {

using namespace core;
using hdf5::Handle;

Handle open_to_read(FieldsFile const& file)
{
  return {H5Fopen(file.data.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose};
}

std::vector<hsize_t> extents_of(hid_t array)
{
  Handle const space(H5Dget_space(array), H5Sclose);
  std::vector<hsize_t> extents(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
  H5Sget_simple_extent_dims(space, extents.data(), nullptr);
  return extents;
}

std::string text_attribute(hid_t object, char const* name)
{
  Handle const attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  Handle const type(H5Aget_type(attribute), H5Tclose);
  char* start = nullptr;
  H5Aread(attribute, type, &start);
  std::string const text = start;
  H5free_memory(start);
  return text;
}

double number_attribute(hid_t object, char const* name)
{
  Handle const attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  double value = -1;
  H5Aread(attribute, H5T_NATIVE_DOUBLE, &value);
  return value;
}

TEST(Fields, go_on_after_the_dumps_that_count)
{
  Scratch const whole("fields_whole"), split("fields_split");
  SampleRun const run;
  run.write(whole.folder, 3);
  auto file = run.write(split.folder, 1);
  auto const times = file.times;
  for (int dump : {7, 8}) write_fields(file, dump, run.fluid(dump), run.bodies(dump));
  file = resume_fields(split.folder, run.grid, 1, times);
  for (int dump : {1, 2}) write_fields(file, 0.001 * dump, run.fluid(dump), run.bodies(dump));
  EXPECT_EQ(text_of(split.folder / "run.xmf"), text_of(whole.folder / "run.xmf"));
  auto const root = open_to_read(file);
  EXPECT_FALSE(hdf5::contains(root, "dump_000003"));
  Handle const dump(H5Gopen2(root, "dump_000002", H5P_DEFAULT), H5Gclose);
  EXPECT_EQ(number_attribute(dump, "time"), 0.002);
  EXPECT_THROW(resume_fields(split.folder, run.grid, 9, times), InputError);
  std::filesystem::resize_file(file.data, 100);
  EXPECT_THROW(resume_fields(split.folder, run.grid, 1, times), InputError);
}

TEST(Fields, arrays_read_back_with_shape_type_and_unit)
{
  Scratch const scratch("fields");
  SampleRun const run;
  auto const file = run.write(scratch.folder, 3);
  auto const root = open_to_read(file);
  ASSERT_GE(root, 0);

  for (int dump = 0; dump < 3; ++dump) {
    std::string const path = "/dump_00000" + std::to_string(dump);
    Handle const group(H5Gopen2(root, path.c_str(), H5P_DEFAULT), H5Gclose);
    EXPECT_EQ(number_attribute(group, "time"), 0.001 * dump);

    Handle const pressure(H5Dopen2(group, "fluid/pressure", H5P_DEFAULT), H5Dclose);
    EXPECT_EQ(extents_of(pressure), (std::vector<hsize_t>{3, 5}));
    EXPECT_EQ(text_attribute(pressure, "unit"), "Pa");
    double p[3][5] = {};
    ASSERT_GE(H5Dread(pressure, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, p), 0);
    EXPECT_EQ(p[2][4], 100 * dump + 24);
    EXPECT_EQ(p[1][0], 100 * dump + 10);

    Handle const velocity(H5Dopen2(group, "fluid/velocity", H5P_DEFAULT), H5Dclose);
    EXPECT_EQ(extents_of(velocity), (std::vector<hsize_t>{3, 5, 3}));
    double u[3][5][3] = {};
    ASSERT_GE(H5Dread(velocity, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, u), 0);
    EXPECT_EQ(u[2][3][0], 3);
    EXPECT_EQ(u[2][3][1], -4);
    EXPECT_EQ(u[2][3][2], 0);

    Handle const density(H5Dopen2(group, "fluid/density", H5P_DEFAULT), H5Dclose);
    Handle const stored(H5Dget_type(density), H5Tclose);
    EXPECT_EQ(H5Tget_size(stored), sizeof(float));

    Handle const nodes(H5Dopen2(group, "membrane/nodes", H5P_DEFAULT), H5Dclose);
    EXPECT_EQ(extents_of(nodes), (std::vector<hsize_t>{4, 3}));
    double X[4][3] = {};
    ASSERT_GE(H5Dread(nodes, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, X), 0);
    EXPECT_EQ(X[2][0], 0.5 * dump + 0.1);
    EXPECT_EQ(X[2][1], 1.25);
  }
  EXPECT_EQ(text_attribute(root, "assumption: outlet"), "free of traction");
  EXPECT_EQ(text_attribute(root, "symmetry"), "axisymmetric");
  EXPECT_EQ(number_attribute(root, "dx [m]"), 0.5);
  EXPECT_EQ(number_attribute(root, "nx"), 5);
}

TEST(Fields, arrays_are_compressed)
{
  Scratch const scratch("fields");
  Grid const grid{512, 512, 1, {0, 0}, Symmetry::planar};
  auto file = create_fields(scratch.folder, grid, {});
  std::vector<double> const flat(static_cast<std::size_t>(grid.nx * grid.ny), 1.0);
  write_fields(file, 0, {{"pressure", "Pa", 1, flat}}, {});
  EXPECT_LT(std::filesystem::file_size(file.data), flat.size() * sizeof(double) / 50);
}

/// Every element of an XML text closed in its order; no check of attributes.
bool is_well_formed(std::string const& text)
{
  std::vector<std::string> open;
  std::regex const tag(R"(<(/?)([A-Za-z]+)((?:\s+[A-Za-z]+="[^"<>&]*")*)\s*(/?)>)");
  auto const head = text.find("?>") + 2;
  std::string rest = text.substr(head);
  for (std::smatch m; std::regex_search(rest, m, tag); rest = m.suffix()) {
    if (m.prefix().str().find_first_of("<>&") != std::string::npos) return false;
    if (m[1].length() == 0 && m[4].length() == 0) open.push_back(m[2]);
    if (m[1].length() == 0) continue;
    if (open.empty() || open.back() != m[2]) return false;
    open.pop_back();
  }
  return open.empty() && rest.find_first_of("<>&") == std::string::npos;
}

TEST(Fields, index_is_well_formed_and_names_arrays_that_exist_with_their_extents)
{
  Scratch const scratch("fields");
  auto const file = SampleRun{}.write(scratch.folder, 2);
  auto const text = text_of(file.index);
  EXPECT_TRUE(is_well_formed(text)) << text;

  auto const root = open_to_read(file);
  std::regex const item(R"re(Dimensions="([0-9 ]+)"[^>]*Format="HDF">run\.h5:([^<]+)<)re");
  int items = 0;
  for (std::sregex_iterator m(text.begin(), text.end(), item), end; m != end; ++m, ++items) {
    Handle const array(H5Dopen2(root, (*m)[2].str().c_str(), H5P_DEFAULT), H5Dclose);
    ASSERT_GE(array, 0) << (*m)[2];
    std::istringstream stated((*m)[1].str());
    std::vector<hsize_t> extents;
    for (hsize_t n; stated >> n;) extents.push_back(n);
    if (extents.front() == 1) extents.erase(extents.begin());  // the one layer of the fluid
    EXPECT_EQ(extents, extents_of(array)) << (*m)[2];
  }
  EXPECT_EQ(items, 2 * (4 + 3 + 2));  // fluid, membrane and face at two times
}

TEST(Fields, open_after_every_dump)
{
  Scratch const scratch("fields");
  SampleRun const run;
  auto file = create_fields(scratch.folder, run.grid, {});
  EXPECT_TRUE(is_well_formed(text_of(file.index)));
  for (int dump = 0; dump < 3; ++dump) {
    write_fields(file, dump, run.fluid(dump), run.bodies(dump));
    EXPECT_TRUE(is_well_formed(text_of(file.index)));
    auto const copy = scratch.folder / ("seen_" + std::to_string(dump) + ".h5");
    std::filesystem::copy_file(file.data, copy);  // what a crash now would leave
    Handle const reader(H5Fopen(copy.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    EXPECT_GE(reader, 0);
    EXPECT_GT(H5Lexists(reader, ("dump_00000" + std::to_string(dump)).c_str(), H5P_DEFAULT), 0);
  }
}

TEST(Fields, are_written_while_a_reader_holds_its_lock)
{
  Scratch const scratch("fields");
  SampleRun const run;
  auto file = run.write(scratch.folder, 1);
  int const reader = open(file.data.c_str(), O_RDONLY);
  ASSERT_EQ(flock(reader, LOCK_SH), 0);  // as HDF5 does when a viewer opens the file
  EXPECT_NO_THROW(write_fields(file, 0.001, run.fluid(1), run.bodies(1)));
  close(reader);
}

TEST(Fields, refuse_wrong_lengths_and_names)
{
  Scratch const scratch("fields");
  SampleRun const run;
  auto const write = [&](std::vector<Field> const& fluid, std::vector<Curve> const& curves) {
    auto file = create_fields(scratch.folder, run.grid, {});
    write_fields(file, 0, fluid, curves);
  };
  EXPECT_NO_THROW(write({}, {}));
  EXPECT_THROW(write({{"p", "Pa", 1, std::vector<double>(14)}}, {}), InputError);
  EXPECT_THROW(write({{"p", "Pa", 3, std::vector<double>(15)}}, {}), InputError);
  EXPECT_THROW(write({{"a/b", "Pa", 1, std::vector<double>(15)}}, {}), InputError);
  EXPECT_THROW(write({{"", "Pa", 1, std::vector<double>(15)}}, {}), InputError);
  Field const p{"p", "Pa", 1, std::vector<double>(15)};
  EXPECT_THROW(write({p, p}, {}), InputError);
  EXPECT_THROW(write({}, {{"fluid", {{0, 0}, {1, 1}}, {}}}), InputError);
  EXPECT_THROW(write({}, {{"film", {{0, 0}}, {}}}), InputError);
  EXPECT_THROW(write({}, {{"film", {{0, 0}, {1, 1}}, {{"nodes", "m", 1, std::vector<double>(2)}}}}),
               InputError);
}

TEST(Fields, that_cannot_be_written_are_a_sentence)
{
  Scratch const scratch("fields");
  try {
    create_fields(scratch.folder / "nowhere", SampleRun{}.grid, {});
    FAIL() << "wrote into a folder that does not exist";
  } catch (InputError const& error) {
    EXPECT_NE(std::string(error.what()).find("run.h5 cannot be written."), std::string::npos);
  }
  auto file = SampleRun{}.write(scratch.folder, 1);
  std::filesystem::remove(file.data);
  EXPECT_THROW(write_fields(file, 1, {}, {}), InputError);
}

}  // namespace
}  // namespace velum::tests
