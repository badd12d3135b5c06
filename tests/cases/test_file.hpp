#pragma once
#include "cases/app/test_data.hpp"
#include "core/check.hpp"
#include "tests/cases/scene_file.hpp"

#include <string>

namespace velum::tests {

/// A test of ten points on a neo-Hookean rubber of 1 MPa, in the file's own words.
inline std::string const plain_test = R"(# test = uniaxial
# source = a drawer
time [s], stretch, engineering_stress [MPa]
0, 1, 0
1, 1.1, 0.2736
2, 1.2, 0.5056
3, 1.3, 0.7083
4, 1.4, 0.8898
5, 1.5, 1.0556
6, 1.6, 1.2094
7, 1.7, 1.3540
8, 1.8, 1.4914
9, 1.9, 1.6230
)";

inline cases::TestFile read_test(std::string const& text)
{
  TemporaryFolder const folder;
  auto const file = folder.path / "data.csv";
  std::ofstream(file) << text;
  return cases::read_test_file(file);
}

/// The sentence with which such a file is refused, its folder left out; empty when it is accepted.
inline std::string test_refusal(std::string const& text)
{
  try {
    read_test(text);
  } catch (core::InputError const& error) {
    std::string const sentence = error.what();
    return sentence.substr(std::max<std::size_t>(sentence.find("data.csv"), 0));
  }
  return {};
}

}  // namespace velum::tests
