#pragma once
#include "cases/app/scene.hpp"
#include "cases/app/scene_words.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// Error against wall time of one scene.
namespace velum::cases {

/// One way to compute a scene.
struct ChartPoint {
  double dx;  // m
  Collision collision;
  lbm::WallRule wall_rule;
  Precision precision;
};

/// What it cost and how wrong it was.
struct ChartRow {
  std::string scene;
  double dx;  // m
  Collision collision;
  lbm::WallRule wall_rule;
  Precision precision;
  bool is_default;  // the scene as its file has it
  double steps = 0, wall_time = 0, mlups = 0;
  std::string error_key{};
  double error = 0;
  std::string outcome = "ok";  // or the sentence of the divergence
};

/// Every collision, precision and, of double precision, wall rule that velum has, at each dx of the
/// scene's [chart] (without one twice the scene's dx and that itself), coarsest first. A scene
/// without walls has no wall rule to vary, one with a membrane no 16-bit storage.
/// @param quick  without the finest dx
std::vector<ChartPoint> chart_points(Scene const& scene, bool quick);

/// Runs the scene that way. A divergence is an outcome. Throws Stopped.
/// @param folder  where a scene with a membrane may write its results; others write nothing
/// @pre the scene has a reference with an error_key()
ChartRow measure(Scene const& scene, ChartPoint const& point, std::filesystem::path const& folder);

/// All rows as a CSV file.
std::string csv(std::vector<ChartRow> const& rows);

}  // namespace velum::cases
