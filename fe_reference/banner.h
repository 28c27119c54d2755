// What of a scene the finite elements take, skip and refuse.
//
// They build from body, solid, support, traction, body force, probe, clock and fe. Sections that
// change nothing about the solid's answer (how mpm_pf would integrate it, a passive marker) are
// skipped, and said to be; sections that would change it (growth, heat, walls ...) are refused with
// file and line, because an answer without them would be the answer to another question.
#pragma once

#include <string>

#include "scene/scene.h"

namespace fe
{
  /// Throws scene::BadScene naming every active section that the finite elements do not know, and
  /// a scene without solid or bodies.
  void refuse_active_sections(const scene::Scene &);

  /// Start-up lines: what is on and from which line, what is skipped.
  std::string banner(const scene::Scene &);
} // namespace fe
