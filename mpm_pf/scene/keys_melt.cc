#include "scene/read_value.h"

namespace scene
{
  namespace
  {
    Section phase_field()
    {
      return Keys<PhaseField>("phase_field",
                              "The field phi, 1 in the bodies and -1 outside; without [growth] a "
                              "passive marker of them.")
          .require("width", &PhaseField::width, positive(Dimension::length),
                   "Interface width W0: phi = tanh(distance/(sqrt(2) W0)).", "")
          .optional();
    }

    Section growth()
    {
      return Keys<Growth>("growth", "The right side of Eq. (1): the crystal grows.")
          .add("anisotropy", &Growth::anisotropy, between(0., 1.),
               "Strength eps of the four-fold anisotropy, a = 1 + eps cos(4 (angle)); at most "
               "1/15.",
               "the case with the best known tip velocity")
          .add("capillary_length", &Growth::capillary_length, positive(Dimension::length),
               "d0; with W0 it sets the coupling lambda = 0.8839 W0/d0.",
               "Karma and Rappel's case with D tau0/W0^2 = 3")
          .add("relaxation_time", &Growth::relaxation_time, positive(Dimension::time),
               "tau0; kinetics vanish where tau0 = 0.6267 lambda W0^2/D.", "the unit of time")
          .add("kinetic_coefficient", &Growth::kinetic_coefficient,
               not_negative(Dimension::inverse_speed),
               "beta = (0.8839/lambda)(tau0/W0 - 0.6267 lambda W0/D).",
               "absent: kinetics-free, checked to 1 %")
          .add("laplacian", &Growth::laplacian, any(), "Stencil of the Laplacian.",
               "the nine-point one is isotropic and allows a larger step")
          .add("precision", &Growth::precision, any(),
               "Numbers in which growth and heat are advanced.",
               "float halves the memory traffic; its error is measured in the report")
          .add(
              "step_fraction", &Growth::step_fraction, up_to(0.95),
              "Step as a part of the explicit limit, the smaller of Eq. (1)'s and Eq. (2)'s alone; "
              "latent heat couples them, and together they are stable up to 0.97 of it.",
              "margin for the nonlinear terms")
          .add("step", &Growth::step, positive(Dimension::time),
               "The growth step itself; shorter where a probe, a wall or the end comes first.",
               "absent: step_fraction sets it")
          .add("tiles", &Growth::tiles, any(), "Work only where something happens.",
               "the answer is the same, the cost follows the interface")
          .exclusive({"step", "step_fraction"})
          .optional();
    }

    Section heat()
    {
      return Keys<Heat>("heat", "Eq. (2): temperature theta = (T - Tm)/(L/cp).")
          .require("diffusivity", &Heat::diffusivity, positive(Dimension::diffusivity),
                   "Thermal diffusivity D.", "")
          .require("undercooling", &Heat::undercooling, between(0., 2.),
                   "Delta: the melt starts at theta = -Delta; from 1 on only a front with kinetics "
                   "is steady.",
                   "")
          .add("initial", &Heat::initial, any(), "First theta, of X and Y, instead.",
               "absent: -Delta everywhere, seeds included; a large body at the melting "
               "temperature needs an expression")
          .optional();
    }

    Section orientation()
    {
      return Keys<Orientation>("orientation", "Eq. (3): the crystal angle, moved and turned.")
          .add("angle_degrees", &Orientation::angle_degrees, any(Dimension::degrees),
               "First angle of the crystal axes, counter-clockwise.", "axes along x and y")
          .add("turning", &Orientation::turning, any(),
               "Turn the angle with the spin of the motion.",
               "false shows what goes wrong without Eq. (3)")
          .optional();
    }

    Section noise()
    {
      return Keys<Noise>(
                 "noise",
                 "Thermal noise as a conserved random heat current in Eq. (2); Eq. (1) gets "
                 "none: only the conserved noise matters for side branches.")
          .require(
              "strength", &Noise::strength, positive(Dimension::area),
              "F_u: the variance of theta in still melt is F_u/(dx dy), averaged over waves that "
              "the mesh resolves. Waves of few cells stand higher: with short steps by 1.16 "
              "beside [growth] (nine-point Laplacian), at 0.8 of the limit by 1.9 (heat "
              "alone) and 2.9.",
              "")
          .add("seed", &Noise::seed, any(), "Key of the counter-based generator.",
               "the same noise in every run, for any number of threads")
          .add("mirrored", &Noise::mirrored, any(),
               "Noise mirrored at symmetry sides (or about the domain's middle). Outer sides of a "
               "quarter are no_flux for it to be the quarter of a whole.",
               "a quarter of a noisy dendrite is a quarter only if its noise is mirrored")
          .optional();
    }
  } // namespace

  std::vector<Section> melt_sections()
  {
    return {phase_field(), growth(), heat(), orientation(), noise()};
  }
} // namespace scene
