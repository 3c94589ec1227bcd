#pragma once

// A map of any size in few characters, without colours and beyond ASCII: every character stands for
// a block of cells that is twice as high as wide, as characters are.
//
//   #  an obstacle across half of the block, or more     S  start
//   ?  mostly unknown                                    G  goal
//   :  mostly too close for the robot                    o  path
//   .  free                                              =  driven in reverse
//   ~  mostly rough                                      !  the narrowest place
//   o % & -  planned, smoothed, driven, possible         R  the robot    X  a collision
//   N  the nearest free cell
//   0-9  heat, from the least to the greatest value
//   * + @ s g  some of it has a role: expanded, frontier, being expanded, start's, goal's component

#include <string>

#include "wend/render/scene.hpp"

namespace wend {

/// At most that many columns and rows, '\n' after every row.
std::string ascii_picture(const Scene& scene, int columns, int rows);

}  // namespace wend
