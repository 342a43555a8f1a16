// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/checkpoint.h"
#include "solver/hdf5_file.h"
#include <filesystem>
#include <stdexcept>

namespace ballonet::solver
{

namespace
{

/// The one list of scalars in a checkpoint.
template <class Progress, class Visit>
void for_each_scalar(Progress &p, const Visit &visit)
{
  visit("pressure", p.state.pressure);
  visit("time", p.state.time);
  visit("step", p.step);
  visit("cuts", p.cuts);
  visit("setbacks", p.setbacks);
  visit("negative_pivots", p.stability.negative_pivots);
  visit("compliance", p.stability.compliance);
  visit("moving", p.regularisation.moving);
  visit("steps_to_rest", p.regularisation.steps_to_rest);
  visit("pause", p.regularisation.pause);
  visit("rests_to_go", p.regularisation.rests_to_go);
  visit("caution", p.regularisation.caution);
  visit("iterations", p.iterations);
  visit("factorisations", p.factorisations);
  visit("load_factor", p.state.load_factor);
  visit("stretch", p.stretch);
  visit("dt", p.dt);
  visit("arc_length", p.arc_length);
  visit("dissipation", p.dissipation);
  visit("ceiling", p.ceiling);
  visit("volume", p.volume);
  visit("pressure_peak", p.pressure_peak);
}

} // namespace

void write_checkpoint(const std::string &file, const PathProgress &progress)
{
  {
    Hdf5File out(file + ".new", Hdf5File::Mode::create);
    out.write("displacement", progress.state.displacement, 3);
    out.write("velocity", progress.state.velocity, 3);
    out.write("acceleration", progress.state.acceleration, 3);
    if (!progress.state.friction.empty())
      out.write("friction", progress.state.friction, 3);
    if (!progress.state.contact_shift.empty())
      out.write("contact_shift", progress.state.contact_shift, 1);
    for_each_scalar(progress, [&](const char *name, double value) { out.write_attribute("/", name, value); });
  }
  std::filesystem::rename(file + ".new", file);
}

bool read_checkpoint(const std::string &file, PathProgress &progress)
{
  if (!std::filesystem::exists(file))
    return false;
  const Hdf5File in(file, Hdf5File::Mode::read);
  auto displacement = in.read("displacement"), velocity = in.read("velocity");
  if (displacement.size() != progress.state.displacement.size())
    throw std::runtime_error("checkpoint " + file + " belongs to another mesh");
  progress.state.displacement = std::move(displacement);
  progress.state.velocity = std::move(velocity);
  progress.state.acceleration = in.read("acceleration");
  if (!progress.state.friction.empty())
    progress.state.friction = in.read("friction");
  if (!progress.state.contact_shift.empty())
    progress.state.contact_shift = in.read("contact_shift");
  for_each_scalar(progress, [&](const char *name, auto &value) { value = in.read_attribute("/", name); });
  return true;
}

} // namespace ballonet::solver
