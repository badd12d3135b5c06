#pragma once
#include "cases/app/scene.hpp"
#include "core/output/summary.hpp"
#include "structure/membrane.hpp"
#include "structure/sheet.hpp"

namespace velum::cases {

/// How far a run stretched its membrane, against what the material is known for.
struct StretchRecord {
  double largest = 1;  // stretch of the mid-surface
  double face = 0;     // of a face, along the meridian; 0 where nothing bends
  double i1 = 0;       // I1 - 3
  bool stable = true;  // by Drucker, at every state that was looked at
};

/// Takes the state of the membrane into the record. The first time that it leaves what the tests
/// behind the material's card reached, in stretch or in I1 (both ways at once draw the chains out
/// farther than one), or the law's stability, a warning goes to the log.
void note_stretch(StretchRecord& record, structure::Membrane const& membrane,
                  Material const& material);
void note_stretch(StretchRecord& record, structure::Sheet const& sheet, Material const& material);

/// The same for the membrane of a scene, with its faces where it bends.
void note_stretch(StretchRecord& record, structure::Membrane const& membrane, Scene const& scene);

/// For summary.json: stretch_max, and stretch_max_face where it is known.
std::vector<core::Figure> figures(StretchRecord const& record);

/// What the material is, in words.
std::string material_in_words(Material const& material);

/// Adds what the record says about the card, if there is one, to what the run assumed.
void add_range(core::Assumptions& assumptions, StretchRecord const& record,
               Material const& material);

}  // namespace velum::cases
