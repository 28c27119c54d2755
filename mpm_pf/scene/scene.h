// What is asked: one scene, the input of both solvers, as plain data.
//
// Section present = module present: an absent section of the TOML file is an empty optional here,
// and whoever builds a world from the scene allocates nothing for it. This header holds no solver
// type and no physics; the two solvers (mpm_pf and fe_reference) each read what concerns them and
// say what they skip. The keys, with unit, range, default and the reason for it, are declared once
// in the tables keys_*.cc; reader.h turns a file into a Scene.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/bodies.h"
#include "scene/domain.h"
#include "scene/loads.h"
#include "scene/melt_settings.h"
#include "scene/probes.h"
#include "scene/solver_settings.h"

namespace scene
{
  struct Scene
  {
    std::string file, title;
    std::string text;     // the TOML as merged and overridden, for provenance
    std::string hash;     // of `text` and of the outlines that it takes from files and records
    std::string accuracy; // "", "draft", "standard" or "fine"
    Units units = Units::si;
    Domain domain;
    Clock clock;
    std::vector<Body> bodies;
    std::vector<Support> supports;
    std::vector<Traction> tractions;
    std::vector<Probe> probes;
    std::vector<Wall> walls;
    std::optional<BodyForce> body_force;
    std::optional<Solid> solid;
    std::optional<Mpm> mpm;
    std::optional<Fe> fe;
    std::optional<PhaseField> phase_field;
    std::optional<Growth> growth;
    std::optional<Heat> heat;
    std::optional<Orientation> orientation;
    std::optional<Noise> noise;
    std::optional<Imposed> imposed;
    std::optional<Advection> advection;
    std::optional<Extension> extension;
  };
} // namespace scene
