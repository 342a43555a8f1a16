// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/reduced/parameters.h"
#include "studies/study.h"

namespace ballonet::studies
{

/// A PEBS study as the reduced model sees it: whatever it takes no notice of has its default. Two studies have equal
/// results if these are equal. Throws std::invalid_argument if a material cannot be made.
Study reduced_view(const Study &study);

/// The parameters of the reduced model. A material counts with its small-strain moduli; d1 does not count, since the
/// balloon is incompressible there.
solver::reduced::Parameters reduced_parameters(const Study &study);

/// A key whose value has a meaning for the actuator that the reduced model does not know.
struct UnknownToReduced {
  std::string key, given, allowed;
};

/// The first such key, if there is one. Numerical settings of the simulation (mesh, newton, step sizes, stiffness of
/// the contact) are not among them: a study may be computed by both models.
std::optional<UnknownToReduced> unknown_to_reduced(const Study &study);

} // namespace ballonet::studies
