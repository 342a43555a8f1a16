// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/regularisation.h"
#include <algorithm>

namespace ballonet::solver
{

void Regularisation::stayed_at_rest() { caution = std::max(1, caution / 2); }

void Regularisation::set_in_motion(int rest_every)
{
  constexpr int most = 8;
  moving = true;
  steps_to_rest = caution == 1 ? 1 : rest_every; // a single event is over after one step
  rests_to_go = caution;
  caution = std::min(2 * caution, most);
}

void Regularisation::sought_rest(bool found, int rest_every)
{
  constexpr int most = 8;
  pause = found ? 1 : std::min(2 * pause, most);
  steps_to_rest = pause * rest_every;
  if (found)
    moving = --rests_to_go > 0;
}

} // namespace ballonet::solver
