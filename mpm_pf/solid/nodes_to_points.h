// Back from the nodes: velocity, position, strain and stress of all points over one step.
#pragma once

namespace solid
{
  struct Solid;

  enum class Part
  {
    all,
    stress, // velocity gradient and stress, before the forces
    motion  // velocity and position, after them
  };

  /// Requires node velocities; fills solid.shares, one a block (Part::motion adds to them).
  void nodes_to_points(Solid &, double dt, Part part = Part::all);
} // namespace solid
