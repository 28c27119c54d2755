// Back from the nodes: velocity, position, strain and stress of all points over one step.
#pragma once

namespace solid
{
  struct Solid;

  /// Requires node velocities; fills solid.shares, one a block.
  void nodes_to_points(Solid &, double dt);
} // namespace solid
