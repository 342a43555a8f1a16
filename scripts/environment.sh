# SPDX-License-Identifier: LGPL-2.1-or-later
# Sourced by the other scripts: where things are, and how many threads a process may use.
#   BALLONET_BUILD   build directory; default build/ of this repository

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${BALLONET_BUILD:-$root/build}

# One BLAS thread per process: the ranks are the parallelism, and threads of a busy core only wait for each other.
export OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1
# Containers run as root and count few slots; both are fine for one machine.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_hwloc_base_binding_policy=none
# OpenBLAS falls back to its slowest kernels on processors newer than itself; name the kernels by what the processor can do.
if [ -z "${OPENBLAS_CORETYPE:-}" ]; then
  if grep -qw avx512f /proc/cpuinfo; then
    export OPENBLAS_CORETYPE=SKYLAKEX
  elif grep -qw avx2 /proc/cpuinfo; then
    export OPENBLAS_CORETYPE=HASWELL
  fi
fi
