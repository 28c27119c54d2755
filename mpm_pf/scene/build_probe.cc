#include "scene/build.h"

namespace scene
{
  namespace
  {
    const std::vector<Form> &kinds()
    {
      static const std::vector<Form> forms{{"line", {"line", "points"}, {"bin", "frame", "of"}},
                                           {"point (at)", {"at"}, {"bin", "frame", "of"}},
                                           {"region", {"region"}, {"of"}},
                                           {"reaction", {"reaction"}, {}},
                                           {"outline", {"outline"}, {}},
                                           {"snapshot", {"snapshot"}, {"of"}},
                                           {"tip", {"tip"}, {}},
                                           {"history", {"history"}, {}}};
      return forms;
    }

    // A kind that is switched by `= true`: false would ask for nothing.
    void must_be_true(const std::optional<bool> &flag, const char *key, const Value &at,
                      ErrorList &errors)
    {
      if (flag && !*flag)
        errors.add(*at.find(key), "read false: a probe of nothing", "true",
                   "remove the probe or write " + std::string(key) + " = true");
    }
  } // namespace

  void build_probe(const ProbeInput &input, const Value &at, Draft &draft, ErrorList &errors)
  {
    Probe probe{input.name,  HistoryProbe{},     input.of, input.times,
                input.every, input.compressions, at.place};
    const std::size_t before = errors.count();
    must_be_true(input.snapshot, "snapshot", at, errors);
    must_be_true(input.history, "history", at, errors);
    const std::size_t kind = input.line       ? 0
                             : input.at       ? 1
                             : input.region   ? 2
                             : input.reaction ? 3
                             : input.outline  ? 4
                             : input.snapshot ? 5
                             : input.tip      ? 6
                             : input.history  ? 7
                                              : 8;
    if (kind == 8 || errors.about(at) || !fits(kinds()[kind], kinds(), at, errors))
      return;
    // Points of a melt have no initial position to refer to.
    const bool solid = draft.root.find("solid") != nullptr;
    if (input.line)
      probe.kind = LineProbe{input.line->a, input.line->b, *input.points,
                             input.frame.value_or(Frame::current), input.bin};
    else if (input.at)
      probe.kind = PointProbe{
          *input.at, input.frame.value_or(solid ? Frame::material : Frame::current), input.bin};
    else if (input.region)
      probe.kind = *input.region;
    else if (input.reaction)
      probe.kind = ReactionProbe{*input.reaction};
    else if (input.outline)
      probe.kind = OutlineProbe{*input.outline};
    else if (input.snapshot)
      probe.kind = SnapshotProbe{};
    else if (input.tip)
      probe.kind = *input.tip;
    if (errors.count() > before)
      return;
    draft.scene.probes.push_back(probe);
    draft.probes.push_back(&at);
  }
} // namespace scene
