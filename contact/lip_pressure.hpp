#pragma once

namespace velum::contact {

/// Which fluid pressure acts between the two surfaces of a sealed contact.
///   none:    the surfaces are dry; gauge pressure zero, contact alone carries the land
///   linear:  a film without flow, its pressure falling linearly across the land
/// The second lifts the membrane by half the land's area times the pressure difference: it lowers
/// the force that is needed to open.
enum class LipPressure { none, linear };

/// Pressure at a place s on the face that lies on the obstacle, when the contact covers [begin,
/// end] of the same coordinate (arc length, radius or marker number): outside it the pressure of
/// that side, inside it what the option says.
/// @param p_before, p_after  pressure of the regions at s < begin and s > end
inline double face_pressure(LipPressure lip, double s, double begin, double end, double p_before,
                            double p_after)
{
  if (s < begin) return p_before;
  if (s > end) return p_after;
  if (lip == LipPressure::none) return 0;
  if (end <= begin) return 0.5 * (p_before + p_after);
  return p_before + (p_after - p_before) * (s - begin) / (end - begin);
}

}  // namespace velum::contact
