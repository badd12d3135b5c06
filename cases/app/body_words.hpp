#pragma once
#include "cases/app/body_scene.hpp"
#include "cases/app/scene_words.hpp"

/// The words by which the scene of a body names a choice.
namespace velum::cases {

inline Words<Elements> words(Elements)
{
  return {{"lines", Elements::lines}, {"triangles", Elements::triangles}};
}
inline Words<BodyShape> words(BodyShape)
{
  return {{"disc", BodyShape::disc},
          {"annulus", BodyShape::annulus},
          {"strip", BodyShape::strip},
          {"tube", BodyShape::tube},
          {"mesh", BodyShape::mesh}};
}
inline Words<LoadScale> words(LoadScale)
{
  return {{"membrane", LoadScale::membrane}, {"plate", LoadScale::plate}};
}

}  // namespace velum::cases
