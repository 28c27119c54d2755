// The words of the scene language for each closed choice.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace scene
{
  enum class Shape
  {
    rectangle,
    disc,
    ring,
    polygon,
    outline,
    record
  };

  template <class E>
  using Words = std::vector<std::pair<std::string, E>>;

  /// Words of the choice, in the order of the manual; one overload per enum.
  inline Words<Units> words(Units)
  {
    return {{"SI", Units::si}, {"W0-tau0-sigmaY", Units::w0_tau0_sigma_y}};
  }
  inline Words<Edge> words(Edge)
  {
    return {
        {"left", Edge::left}, {"right", Edge::right}, {"bottom", Edge::bottom}, {"top", Edge::top}};
  }
  inline Words<Boundary> words(Boundary)
  {
    return {{"no_flux", Boundary::no_flux},
            {"symmetry", Boundary::symmetry},
            {"periodic", Boundary::periodic},
            {"fixed", Boundary::fixed}};
  }
  inline Words<Shape> words(Shape)
  {
    return {{"rectangle", Shape::rectangle}, {"disc", Shape::disc},
            {"ring", Shape::ring},           {"polygon", Shape::polygon},
            {"outline", Shape::outline},     {"record", Shape::record}};
  }
  inline Words<Frame> words(Frame)
  {
    return {{"current", Frame::current}, {"material", Frame::material}};
  }
  inline Words<OutlineProbe::Of> words(OutlineProbe::Of)
  {
    return {{"material", OutlineProbe::Of::material}, {"phase", OutlineProbe::Of::phase}};
  }
  inline Words<ShapeFunction> words(ShapeFunction)
  {
    return {{"quadratic_bspline", ShapeFunction::quadratic_bspline},
            {"ugimp", ShapeFunction::ugimp},
            {"linear", ShapeFunction::linear}};
  }
  inline Words<Transfer> words(Transfer)
  {
    return {{"tpic", Transfer::tpic},
            {"apic", Transfer::apic},
            {"flip", Transfer::flip},
            {"pic", Transfer::pic},
            {"xpic2", Transfer::xpic2}};
  }
  inline Words<StressUpdate> words(StressUpdate)
  {
    return {{"last", StressUpdate::last}, {"first", StressUpdate::first}};
  }
  inline Words<Laplacian> words(Laplacian)
  {
    return {{"five_point", Laplacian::five_point}, {"nine_point", Laplacian::nine_point}};
  }
  inline Words<Precision> words(Precision)
  {
    return {{"double", Precision::double_precision}, {"float", Precision::single_precision}};
  }
  inline Words<AdvectionScheme> words(AdvectionScheme)
  {
    return {{"cip", AdvectionScheme::cip},
            {"cip_hermite", AdvectionScheme::cip_hermite},
            {"weno5", AdvectionScheme::weno5},
            {"upwind", AdvectionScheme::upwind}};
  }
  inline Words<ExtensionMethod> words(ExtensionMethod)
  {
    return {{"closest_point", ExtensionMethod::closest_point}, {"pde", ExtensionMethod::pde}};
  }
  inline Words<WallGrip> words(WallGrip)
  {
    return {{"grip", WallGrip::grip}, {"slip", WallGrip::slip}};
  }

  /// The word for a value, as the scene writes it.
  template <class E>
  std::string word(const E value)
  {
    for (const auto &[text, candidate] : words(value))
      if (candidate == value)
        return text;
    return "";
  }
} // namespace scene
