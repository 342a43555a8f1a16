// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <petscsys.h>
#include <stdexcept>
#include <string>

namespace ballonet::solver
{

/// PETSc reports by return value; a value other than zero is a bug or an exhausted machine.
inline void petsc(PetscErrorCode code)
{
  if (code)
    throw std::runtime_error("PETSc error " + std::to_string(code));
}

} // namespace ballonet::solver
