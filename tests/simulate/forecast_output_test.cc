// A plan counts what is looked at, as often as it is looked at.
#include <gtest/gtest.h>

#include "forecast.h"
#include "written_scene.h"

namespace
{
  double output_seconds(const std::string &every)
  {
    return make_forecast(scene_of("title = \"t\"\n[domain]\nsize = [16.0, 16.0]\ncells = [64, 64]\n"
                                  "[[body]]\nshape = \"rectangle\"\ncorner = [4.0, 4.0]\n"
                                  "size = [8.0, 8.0]\n"
                                  "[solid]\nyoung_modulus = 100.0\npoisson_ratio = 0.3\n"
                                  "density = 1.0\n[[probe]]\nname = \"fields\"\nsnapshot = true\n"
                                  "every = " +
                                  every + "\n[clock]\nend = 10.0\n"),
                         1, false)
        .seconds.at("output");
  }
} // namespace

TEST(Plan, CountsEveryLookOfAProbe)
{
  const double few = output_seconds("5.0"), many = output_seconds("0.01"); // 3 and 1001 looks
  EXPECT_GT(few, 0.);
  EXPECT_GT(many, 30. * few);
}
