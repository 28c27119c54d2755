// What exists: built only from what the scene names.
//
// An absent section of the scene is a null pointer here: no array, no step limit, no output column,
// one test per step. The solid and the melt never see each other; they meet in step() only.
#pragma once

#include <map>
#include <string>

#include "record/checkpoint.h"
#include "record/writer.h"
#include "scene/scene.h"
#include "solid/solid.h"

struct World
{
  const scene::Scene *scene = nullptr;
  int threads = 1;
  double time = 0.;
  long steps = 0;

  solid::Owner solid; // [solid]
};

/// Everything that `scene` asks for, at time 0. The scene must outlive the world. Throws
/// scene::BadScene where the scene cannot be built (no cell in a body, ...).
World build_world(const scene::Scene &scene, int threads);

/// Bytes held, by module and part ("solid points", "solid grid", "phase field", ...); a module that
/// is absent has no entry.
std::map<std::string, double> memory(const World &);

/// Largest step that every present module accepts as one coupling step; infinity if none minds.
double coupling_step(const World &);

/// Seconds by part of the solvers, and numbers worth keeping (points, cells, density in use, ...).
std::vector<record::Profile::Part> parts(const World &);
std::map<std::string, double> numbers(const World &);

/// Counts before the run: "points", "cells", "steps", "cpu_s"; only what the present modules have.
std::map<std::string, double> predict(const World &);

/// The whole state to and from a checkpoint; a restored world goes on to the same bits. Throw
/// std::runtime_error if the checkpoint lacks a module.
void save(const World &, record::Checkpoint &);
void restore(World &, const record::Checkpoint &);
