// SPDX-License-Identifier: Apache-2.0
// Matrices of one lane in memory by [3 row + column][lane].
#pragma once
#include "core/math/mat3.hpp"

namespace thaw {

inline Mat3d laneMatrix(const double (*m)[8], int lane) {
  return {{{m[0][lane], m[1][lane], m[2][lane]},
           {m[3][lane], m[4][lane], m[5][lane]},
           {m[6][lane], m[7][lane], m[8][lane]}}};
}

inline void setLaneMatrix(const Mat3d& from, double (*m)[8], int lane) {
  for (int r = 0; r < 3; r++)
    for (int c = 0; c < 3; c++) m[3 * r + c][lane] = from.row[r][c];
}

}  // namespace thaw
