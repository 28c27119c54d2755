#include "contact_forecast.h"

#include "solid/growing.h"

void ContactForecast::add(const RunProgress &now)
{
  constexpr double enough_way = 0.02, enough_s = 0.1;
  constexpr long enough_steps = 10;
  if (forecast)
    return;
  if (!contact)
  {
    contact = now;
    return;
  }
  const double way = now.time - contact->time, spent = now.cpu_s - contact->cpu_s;
  if (way < enough_way * (now.end - contact->time) || spent < enough_s ||
      now.steps < contact->steps + enough_steps)
    return;
  forecast = now.cpu_s + spent * (now.end - now.time) / way;
}

void add(ContactForecast &forecast, const World &world, const double cpu_s)
{
  if (world.walls && world.solid && world.scene->growth && solid::active(*world.solid))
    forecast.add({world.time, expected_end(world), world.steps, cpu_s});
}
