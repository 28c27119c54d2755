// What exists: built only from what the scene names.
//
// An absent section of the scene is a null pointer here: no array, no step limit, no output column,
// one test per step. The solid and the melt never see each other; they meet in step() only.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "imposed.h"
#include "medium/advection.h"
#include "medium/extension.h"
#include "medium/walls.h"
#include "melt/growth.h"
#include "melt/orientation.h"
#include "record/checkpoint.h"
#include "record/writer.h"
#include "scene/scene.h"
#include "solid/solid.h"
#include "uncarried.h"

/// A field of the melt with what its advection carries along; the gradients stay empty until
/// something moves. phi is dimensionless (+1 solid, -1 liquid), theta = (T - Tm)/(L/cp).
struct AdvectedField
{
  medium::Field<double> value;
  medium::Gradients gradients;
  double advected =
      0.; // what advection has added to the integral, unit of the field times length^2
};

struct World
{
  const scene::Scene *scene = nullptr;
  int threads = 1;
  double time = 0.;
  long steps = 0;

  std::unique_ptr<medium::Mesh> mesh;             // if anything Eulerian exists
  std::unique_ptr<AdvectedField> phase;           // [phase_field]
  std::unique_ptr<AdvectedField> heat;            // [heat]
  std::unique_ptr<melt::Orientation> orientation; // [orientation]
  std::unique_ptr<melt::Noise> noise;             // [noise]
  std::unique_ptr<melt::Growth> growth;           // [growth], or [heat] alone
  std::unique_ptr<Imposed> imposed;               // [imposed]
  std::unique_ptr<medium::Walls> walls;           // [[wall]]
  std::unique_ptr<medium::Velocity> velocity;     // if anything moves the melt's fields
  std::unique_ptr<medium::Extension> extension;   // [solid] beside [phase_field]
  std::unique_ptr<medium::Advection> advection;
  std::unique_ptr<Uncarried> uncarried; // advection.interval above 1
  bool melt_moves = false;              // in the present step
  solid::Owner solid;                   // [solid]

  std::map<std::string, record::Profile::Part> spent; // by module that was called, see stopwatch.h
};

/// Everything that `scene` asks for, at time 0. The scene must outlive the world. `force` accepts
/// growth steps past their limit. Throws scene::BadScene where the scene cannot be built (no cell
/// in a body, ...).
World build_world(const scene::Scene &scene, int threads, bool force = false);

/// Whether the run is over: the scene's end, or all walls have travelled as far as they were asked
/// to (walls that only stand there do not end it).
bool finished(const World &);

/// When the run will be over: at the scene's end, or when the walls that are under way will have
/// travelled as far as they were asked to. Time.
double expected_end(const World &);

/// Largest step that every present module accepts as one coupling step; infinity if none minds.
double coupling_step(const World &);

/// Cells that a motion may cross per coupling step and axis: the scene's choice or its default.
double advection_fraction(const scene::Scene &);

/// What the walls have left of the domain: all of it, if there are none.
medium::Cuts cuts_of(const World &);

/// Explicit growth step of the scene: its own choice, or its fraction of the limit. Time.
double growth_step(const World &);

/// The whole state to and from a checkpoint; a restored world goes on to the same bits. Throw
/// std::runtime_error if the checkpoint lacks a module.
void save(const World &, record::CheckpointTarget &);
void restore(World &, const record::Checkpoint &);
