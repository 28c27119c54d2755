#include "record/run_cost.h"

#include <algorithm>

namespace record
{
  namespace
  {
    constexpr auto below_parts = "spent/parts/", below_numbers = "spent/numbers/";

    Profile::Part &part_of(Profile &profile, const std::string &name)
    {
      const auto found = std::find_if(profile.parts.begin(), profile.parts.end(),
                                      [&](const Profile::Part &part) { return part.name == name; });
      return found != profile.parts.end() ? *found
                                          : profile.parts.emplace_back(Profile::Part{name});
    }

    bool ends_with(const std::string &text, const std::string &end)
    {
      return text.size() >= end.size() &&
             text.compare(text.size() - end.size(), end.size(), end) == 0;
    }

    void add(Profile &profile, const Profile &before)
    {
      for (const Profile::Part &spent : before.parts)
      {
        Profile::Part &part = part_of(profile, spent.name);
        part.wall_s += spent.wall_s;
        part.cpu_s += spent.cpu_s;
        part.calls += spent.calls;
      }
      for (const auto &[name, number] : before.numbers)
        if (name == "wall_s" || name == "cpu_s" || ends_with(name, "_calls"))
          profile.numbers[name] += number;
        else if (name == "peak_rss_bytes" || name.rfind("bytes ", 0) == 0)
          profile.numbers[name] = std::max(profile.numbers[name], number);
    }
  } // namespace

  void RunCost::set_up_done()
  {
    setup = {"set-up", whole.wall_seconds(), record::cpu_seconds(), 1};
  }

  Profile RunCost::profile(SolverCost solver) const
  {
    const double wall = whole.wall_seconds(), cpu = record::cpu_seconds();
    Profile::Part &output = solver.output;
    output.name = "output", output.calls = 1;
    Profile profile;
    profile.parts = {
        setup,
        {"solve", wall - setup.wall_s - output.wall_s, cpu - setup.cpu_s - output.cpu_s, 0},
        output};
    profile.parts.insert(profile.parts.end(), solver.parts.begin(), solver.parts.end());
    profile.numbers = std::move(solver.numbers);
    profile.numbers["wall_s"] = wall;
    profile.numbers["cpu_s"] = cpu;
    profile.numbers["peak_rss_bytes"] = record::peak_rss_bytes();
    add(profile, before);
    part_of(profile, "solve").calls = solver.steps; // which the solver's own state counts
    return profile;
  }

  double RunCost::cpu_seconds() const
  {
    return record::cpu_seconds() + earlier("cpu_s").value_or(0.);
  }

  std::optional<double> RunCost::earlier(const std::string &number) const
  {
    const auto found = before.numbers.find(number);
    return found == before.numbers.end() ? std::nullopt : std::optional<double>(found->second);
  }

  void RunCost::resume(const Checkpoint &checkpoint)
  {
    before = {};
    for (const std::string &name : checkpoint.names_below(below_parts))
    {
      const auto &spent = checkpoint.get<double>(below_parts + name);
      before.parts.push_back({name, spent.at(0), spent.at(1), static_cast<long>(spent.at(2))});
    }
    for (const std::string &name : checkpoint.names_below(below_numbers))
      before.numbers[name] = checkpoint.number(below_numbers + name);
  }

  void save(const Profile &profile, CheckpointTarget &checkpoint)
  {
    for (const Profile::Part &part : profile.parts)
      checkpoint.put(below_parts + part.name,
                     std::vector<double>{part.wall_s, part.cpu_s, static_cast<double>(part.calls)});
    for (const auto &[name, number] : profile.numbers)
      checkpoint.put(below_numbers + name, number);
  }
} // namespace record
