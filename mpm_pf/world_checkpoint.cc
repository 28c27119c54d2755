// State of the world to and from a checkpoint: raw fields, ghosts and all, so that nothing is
// recomputed and a resumed run goes on to the same bits.
#include <algorithm>

#include "world.h"

namespace
{
  using medium::Field;
  using medium::ghost_layers;

  void put(record::CheckpointTarget &checkpoint, const std::string &name,
           const Field<double> &field)
  {
    std::vector<double> flat;
    if (!field.empty())
      for (int j = -ghost_layers; j < field.nodes(1) + ghost_layers; ++j)
        flat.insert(flat.end(), field.row(j) - ghost_layers,
                    field.row(j) + field.nodes(0) + ghost_layers);
    checkpoint.put(name, std::move(flat));
  }

  void get(const record::Checkpoint &checkpoint, const std::string &name, const medium::Mesh &mesh,
           Field<double> &field)
  {
    const auto &flat = checkpoint.get<double>(name);
    if (flat.empty())
      return;
    if (field.empty())
      field = Field<double>(mesh);
    auto next = flat.begin();
    for (int j = -ghost_layers; j < field.nodes(1) + ghost_layers; ++j)
      for (int i = -ghost_layers; i < field.nodes(0) + ghost_layers; ++i)
        field(i, j) = *next++;
  }

  /// Calls visit(name, field) for every field of the world; one list serves both directions.
  template <class W, class Visit>
  void for_each_field(W &world, const Visit &visit)
  {
    const auto carried = [&](const std::string &name, auto &field)
    {
      visit(name + "/value", field.value);
      visit(name + "/x", field.gradients.x);
      visit(name + "/y", field.gradients.y);
      visit(name + "/xy", field.gradients.xy);
      visit(name + "/last", field.gradients.last);
    };
    if (world.phase)
      carried("phi", *world.phase);
    if (world.heat)
      carried("theta", *world.heat);
    if (world.orientation)
    {
      auto &o = *world.orientation;
      visit("angle/value", o.angle);
      visit("angle/cosine", o.cosine), visit("angle/sine", o.sine);
      visit("angle/x", o.gradients.x), visit("angle/y", o.gradients.y);
      visit("angle/xy", o.gradients.xy), visit("angle/last", o.gradients.last);
    }
    if (world.uncarried)
      visit("way/x", world.uncarried->way.x), visit("way/y", world.uncarried->way.y);
    // The next step finds it anew; a snapshot of this state shows it.
    if (world.melt_moves)
      visit("velocity/x", world.velocity->x), visit("velocity/y", world.velocity->y);
  }
} // namespace

void save(const World &world, record::CheckpointTarget &checkpoint)
{
  for_each_field(world, [&](const std::string &name, const Field<double> &field)
                 { put(checkpoint, name, field); });
  if (world.advection && world.heat)
    checkpoint.put("carried", std::vector<double>{world.heat->advected,
                                                  world.phase ? world.phase->advected : 0.});
  if (world.uncarried)
    checkpoint.put("way/since",
                   std::vector<double>{world.uncarried->time, double(world.uncarried->steps)});
  if (world.growth)
    checkpoint.put("growth steps", static_cast<double>(world.growth->steps_taken()));
  if (world.walls)
    checkpoint.put("walls", medium::pack(*world.walls));
  if (world.extension)
  {
    checkpoint.put("extension", medium::pack(*world.extension, *world.mesh));
    if (world.extension->interval > 1)
      checkpoint.put("distance", medium::pack_distance(*world.extension, *world.mesh));
  }
  if (world.solid)
    solid::checkpoint(*world.solid, [&](const std::string &name, std::vector<double> values)
                      { checkpoint.put("solid/" + name, std::move(values)); });
}

void restore(World &world, const record::Checkpoint &checkpoint)
{
  world.melt_moves = checkpoint.has("velocity/x");
  for_each_field(world, [&](const std::string &name, Field<double> &field)
                 { get(checkpoint, name, *world.mesh, field); });
  if (world.advection && world.heat)
  {
    const auto &carried = checkpoint.get<double>("carried");
    world.heat->advected = carried.at(0);
    if (world.phase)
      world.phase->advected = carried.at(1);
  }
  if (world.uncarried)
  {
    const auto &since = checkpoint.get<double>("way/since");
    world.uncarried->time = since.at(0), world.uncarried->steps = static_cast<long>(since.at(1));
  }
  if (world.growth)
    world.growth->restore_steps_taken(static_cast<long>(checkpoint.number("growth steps")));
  if (world.walls)
    medium::unpack(*world.walls, checkpoint.get<double>("walls"));
  if (world.extension)
  {
    medium::unpack(*world.extension, *world.mesh, checkpoint.get<double>("extension"));
    if (world.extension->interval > 1)
      medium::unpack_distance(*world.extension, *world.mesh, checkpoint.get<double>("distance"));
  }
  if (world.solid)
  {
    solid::Checkpoint state = solid::checkpoint(*world.solid);
    if (checkpoint.has("solid/growth")) // the points of a crystal, which a fresh world has not yet
      state["growth"];
    for (auto &[name, values] : state)
      values = checkpoint.get<double>("solid/" + name);
    solid::restore(*world.solid, state);
  }
}
