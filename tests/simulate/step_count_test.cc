// A plan counts the steps that a run takes, with those cut short by what is recorded.
#include "step_count.h"

#include <gtest/gtest.h>

#include "forecast.h"
#include "recorder.h"
#include "simulate.h"
#include "written_scene.h"

namespace
{
  /// A square of 2, cells of 0.25 and waves of 11.6: steps of 0.0086. Pushed at one side.
  scene::Scene pushed(const std::string &more, const std::string &end = "2.0")
  {
    return scene_of("title = \"t\"\n[domain]\nsize = [4.0, 4.0]\ncells = [16, 16]\n"
                    "[[body]]\nshape = \"rectangle\"\ncorner = [1.0, 1.0]\nsize = [2.0, 2.0]\n"
                    "[solid]\nyoung_modulus = 100.0\npoisson_ratio = 0.3\ndensity = 1.0\n"
                    "[[support]]\non = \"left\"\ndisplacement = [\"0.001*t\", \"0\"]\n" +
                    more + "[clock]\nend = " + end + "\n");
  }

  struct Taken
  {
    double couplings, substeps;
  };

  Taken steps_taken(const scene::Scene &scene)
  {
    const Scratch scratch;
    record::Writer writer(scratch / "record.h5", {}, scene, true);
    Recorder recorder(scene, writer);
    World world = build_world(scene, 1);
    simulate(world, recorder, [](const World &) { return true; });
    return {static_cast<double>(world.steps), static_cast<double>(solid::steps(*world.solid))};
  }

  const std::string rows = "[[probe]]\nname = \"push\"\nreaction = \"left\"\nevery = 0.007\n";
} // namespace

TEST(Plan, CountsStepsCutShortByRowsOfReactions)
{
  // Unasked: 200 rows, whose windows end between them; asked for: 287 of 0.007. Without rows that
  // would be 233 steps.
  for (const std::string &probes : {std::string(), rows})
  {
    const scene::Scene scene = pushed(probes);
    const Taken taken = steps_taken(scene);
    EXPECT_GT(taken.substeps, 390.);
    EXPECT_NEAR(make_forecast(scene, 1).counts.at("steps"), taken.substeps, 1.) << probes;
    const StepCount count = count_solid_steps(build_world(scene, 1));
    EXPECT_NEAR(count.couplings, taken.couplings, 1.) << probes;
  }
}

TEST(Plan, CountsCouplingStepsOfAMarkerThatRowsCutShort)
{
  const scene::Scene scene = pushed("[phase_field]\nwidth = 0.25\n" + rows);
  const Taken taken = steps_taken(scene);
  const Forecast forecast = make_forecast(scene, 1);
  EXPECT_NEAR(forecast.counts.at("steps"), taken.substeps, 2.);
  EXPECT_NEAR(forecast.counts.at("coupling steps"), taken.couplings, 2.);
}

TEST(Plan, CountsWholeStepsBetweenFewRows)
{
  const scene::Scene scene =
      pushed("[[probe]]\nname = \"push\"\nreaction = \"left\"\nevery = 0.5\n");
  const World world = build_world(scene, 1);
  // 8 intervals of 0.25, of 3 calls of 0.1 at most: 12 steps of 0.0083, and 6 of the rest.
  const StepCount count = count_steps(world, 0., 2., 0.1, 0.0085);
  EXPECT_EQ(count.couplings, 8. * 3.);
  EXPECT_EQ(count.substeps, 8. * (12. + 12. + 6.));
  EXPECT_EQ(count_steps(world, 0.5, 1., 0.1, 0.0085).couplings, 2. * 3.);
}
