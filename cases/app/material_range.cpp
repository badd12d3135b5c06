#include "cases/app/material_range.hpp"

#include "cases/app/scene_words.hpp"
#include "structure/drucker.hpp"
#include "structure/face_stretch.hpp"
#include "structure/line_element.hpp"
#include "structure/triangle_element.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>

namespace velum::cases {
namespace {

/// How the record goes beyond the tests of the card; empty where it does not.
std::string outside(StretchRecord const& record, Material const& material)
{
  if (!material.card) return "";
  auto const& fitted = material.card->fitted;
  if (record.largest > largest_stretch(fitted))
    return fmt::format(
        "the membrane is stretched to {:.3f}, and the card {} is fitted up to {:.3f} "
        "({}): stresses beyond are extrapolated",
        record.largest, material.file, largest_stretch(fitted), tests_in_words(fitted));
  if (record.i1 > largest_i1(fitted))
    return fmt::format(
        "the membrane is stretched both ways to I1 = {:.3f}, and the card {} is "
        "fitted up to I1 = {:.3f} ({}): stresses beyond are extrapolated",
        3 + record.i1, material.file, 3 + largest_i1(fitted), tests_in_words(fitted));
  return "";
}

std::string unstable(Material const& material)
{
  return fmt::format(
      "the membrane is stretched to where the law of the card {} is unstable by "
      "Drucker: it softens where rubber does not",
      material.file);
}

}  // namespace

namespace {

/// @param stretches  the two principal ones of each element
void note(StretchRecord& record, std::vector<Vec2> const& stretches, Material const& material)
{
  StretchRecord const before = record;
  for (auto const& l : stretches) {
    double const a = l[0] * l[0], b = l[1] * l[1];
    record.largest = std::max({record.largest, l[0], l[1]});
    record.i1 = std::max(record.i1, a + b + 1 / (a * b) - 3);
    if (material.card && !structure::is_stable(material.rubber, l[0], l[1])) record.stable = false;
  }
  if (outside(before, material).empty() && !outside(record, material).empty())
    spdlog::warn("{}.", outside(record, material));
  if (before.stable && !record.stable) spdlog::warn("{}.", unstable(material));
}

}  // namespace

void note_stretch(StretchRecord& record, structure::Membrane const& membrane,
                  Material const& material)
{
  std::vector<Vec2> stretches;
  for (int e = 0; e < structure::element_count(membrane); ++e) {
    auto const k = structure::line_element(membrane, membrane.position, e);
    stretches.push_back({k.l1, k.l2});
  }
  note(record, stretches, material);
}

void note_stretch(StretchRecord& record, structure::Sheet const& sheet, Material const& material)
{
  std::vector<Vec2> stretches;
  for (int e = 0; e < structure::element_count(sheet); ++e) {
    auto const l = structure::principal_stretches(structure::deformation_gradient(
        sheet, sheet.position, structure::triangle_shape(sheet, e), e));
    stretches.push_back({l[0], l[1]});
  }
  note(record, stretches, material);
}

void note_stretch(StretchRecord& record, structure::Membrane const& membrane, Scene const& scene)
{
  note_stretch(record, membrane, scene.materials.at(scene.membrane->material));
  if (has_bending(*scene.membrane))
    record.face =
        std::max(record.face, structure::largest_face_stretch(membrane, scene.membrane->rim));
}

std::vector<core::Figure> figures(StretchRecord const& record)
{
  std::vector<core::Figure> all = {{"stretch_max", record.largest, "1"}};
  if (record.face > 0) all.push_back({"stretch_max_face", record.face, "1"});
  return all;
}

std::string material_in_words(Material const& material)
{
  if (!material.card) return "incompressible neo-Hookean";
  return fmt::format("incompressible {}, card {}, fitted to {} up to stretch {:.3f}",
                     word(material.card->model), material.file,
                     tests_in_words(material.card->fitted), largest_stretch(material.card->fitted));
}

void add_range(core::Assumptions& assumptions, StretchRecord const& record,
               Material const& material)
{
  if (!material.card) return;
  std::string const beyond = outside(record, material);
  auto& sentence = assumptions["range of the card"];
  sentence = beyond.empty() ? fmt::format("kept: largest stretch {:.3f} of {:.3f}", record.largest,
                                          largest_stretch(material.card->fitted))
                            : "left: " + beyond;
  if (!record.stable) sentence += "; " + unstable(material);
}

}  // namespace velum::cases
