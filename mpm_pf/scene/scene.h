// What is asked: one scene, the input of both solvers, as plain data.
//
// Section present = module present: an absent section of the TOML file is an empty optional here,
// and whoever builds a world from the scene allocates nothing for it. This header holds no solver
// type and no physics; the two solvers (mpm_pf and fe_reference) each read what concerns them and
// say what they skip. The keys, with unit, range, default and the reason for it, are declared once
// in keys.cc; reader.h turns a file into a Scene.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

namespace scene
{
  /// A position or a vector in the plane, in the scene's length unit.
  using Point = Eigen::Vector2d;

  /// Where something was written, so that every later complaint can name it.
  struct Place
  {
    std::string file;
    int line = 0;
    std::string key;
  };

  /// An expression of X, Y (initial position), x, y (current position) and t, as written;
  /// expression.h compiles it.
  struct Expression
  {
    std::string text = "0";
    Place place;
  };
  using VectorExpression = std::array<Expression, 2>;

  /// Unit system of all numbers in the file; it changes only how units are printed.
  enum class Units
  {
    si,
    w0_tau0_sigma_y
  };

  enum class Edge
  {
    left,
    right,
    bottom,
    top
  };

  /// Condition on a side of the domain, for every module that knows one. no_flux: fields have zero
  /// normal gradient, material must not reach it; symmetry: the same, and material slides along it;
  /// fixed: fields keep their first value.
  enum class Boundary
  {
    no_flux,
    symmetry,
    periodic,
    fixed
  };

  struct Domain
  {
    Point lower = Point::Zero();
    Point size = Point::Zero();
    std::array<int, 2> cells{0, 0};
    std::array<Boundary, 4> boundary{}; // indexed by Edge
    Place place;

    Point upper() const { return lower + size; }
    Point spacing() const { return {size[0] / cells[0], size[1] / cells[1]}; }
  };

  struct Rectangle
  {
    Point corner, size;
  };
  struct Disc
  {
    Point centre;
    double radius;
  };
  struct Ring
  {
    Point centre;
    double inner_radius, outer_radius;
  };
  using Polyline = std::vector<Point>; // closed when it bounds an area; the last vertex does not
                                       // repeat the first
  struct Polygon
  {
    std::vector<Polyline> outlines;
  }; // even-odd rule: outer boundaries and holes alike
  /// The outline probe of an earlier record; record/outline_source.h replaces it by a Polygon.
  struct RecordedOutline
  {
    std::string path, probe;
    double time = -1.;                          // negative: the last one recorded
    std::optional<double> cut_above, cut_below; // keep only y < cut_above, y > cut_below
  };

  struct Body
  {
    std::string name;
    std::variant<Rectangle, Disc, Ring, Polygon, RecordedOutline> shape;
    VectorExpression velocity;                               // initial, of X, Y
    std::optional<std::array<Expression, 4>> initial_stress; // xx, yy, zz, xy, of X, Y
    Place place;
  };

  /// Elasto-viscoplastic solid. No yield stress: elastic. Yield stress without viscosity:
  /// rate-independent.
  struct Solid
  {
    double young_modulus = 0., poisson_ratio = 0., density = 0.;
    std::optional<double> yield_stress, viscosity;
    Place place;
  };

  struct Segment
  {
    Point a, b;
  };
  struct Box
  {
    Point lower, upper;
  };
  /// Which material is meant, by its initial position: the part of the outline on a side of the
  /// bodies' common bounding box, the part of the outline on a segment, or all material inside a
  /// box (a grip).
  using Where = std::variant<Edge, Segment, Box>;

  struct Support
  {
    std::string name; // default: the word after `on`
    Where where;
    std::array<std::optional<Expression>, 2> displacement; // empty: this component is free
    Place place;
  };

  struct Traction
  {
    std::string name;
    Where where;               // an edge or a segment
    VectorExpression traction; // force per deformed length and unit depth
    Place place;
  };

  struct BodyForce
  {
    VectorExpression acceleration;
    Place place;
  };

  // --- what is observed
  // -------------------------------------------------------------------------------------------
  enum class Frame
  {
    current,
    material
  };

  struct LineProbe
  {
    Point a, b;
    int points;
    Frame frame = Frame::current;
    std::optional<double> bin;
  };
  struct PointProbe
  {
    Point at;
    Frame frame = Frame::material;
  };
  /// Volume mean over all material, or that which started in a box.
  struct RegionProbe
  {
    std::optional<Box> box;
  };
  struct ReactionProbe
  {
    std::string support;
  }; // columns force_x, force_y, displacement_x, displacement_y
  /// Closed polylines: the material outline, or the phi = 0 contour.
  struct OutlineProbe
  {
    enum class Of
    {
      material,
      phase
    } of = Of::material;
  };
  struct SnapshotProbe
  {
  };
  /// Dendrite tip along a ray from `origin` in `direction`: position, velocity, radius.
  struct TipProbe
  {
    Point origin, direction;
  };
  /// Scalar diagnostics of the whole run (energies, momentum, solid area, heat, mass); columns
  /// depend on modules.
  struct HistoryProbe
  {
  };

  struct Probe
  {
    std::string name;
    std::variant<LineProbe, PointProbe, RegionProbe, ReactionProbe, OutlineProbe, SnapshotProbe,
                 TipProbe, HistoryProbe>
        kind;
    std::vector<std::string> of; // quantities; names in quantities.h
    std::vector<double> times;   // explicit times, or
    std::optional<double> every; // an interval; neither: the end time only (line, outline,
                                 // snapshot), 200 samples (others)
    Place place;
  };

  struct Clock
  {
    double end = 0.;
    std::optional<double> step;
    Place place;
  }; // step: coupling step of a coupled scene

  // --- the material points
  // ----------------------------------------------------------------------------------------
  enum class ShapeFunction
  {
    quadratic_bspline,
    ugimp,
    linear
  };
  enum class Transfer
  {
    tpic,
    apic,
    flip,
    pic,
    xpic2
  };

  struct Mpm
  {
    std::array<int, 2> points_per_cell{2, 2};
    ShapeFunction shape_function = ShapeFunction::quadratic_bspline;
    Transfer transfer = Transfer::tpic;
    double flip_fraction = 0.99;           // of transfer = flip
    std::optional<bool> anti_locking;      // empty: on for plastic solids
    double pressure_relaxation = 0.1;      // towards the cell mean, per step
    double step_fraction = 0.4;            // of dx/(c_p + |v|)
    std::optional<double> mach;            // wanted V/c_p: density is scaled to it
    std::optional<double> reference_speed; // V; default: largest speed of supports and walls
    bool split_points = false;
    Place place;
  };

  // --- the finite elements
  // ----------------------------------------------------------------------------------------
  struct Fe
  {
    std::array<int, 2> cells{
        0, 0}; // over the bounding box of the bodies; 0: choose from domain spacing
    int degree = 2;
    int load_steps = 100;
    double tolerance = 1e-9;
    double grading = 0.; // 0: uniform; towards 1: finer near clamped corners
    bool past_folding = false;
    Place place;
  };

  // --- the melt
  // ---------------------------------------------------------------------------------------------------
  struct PhaseField
  {
    double width = 1.;
    Place place;
  }; // W0; alone: a passive marker of the bodies
  enum class Laplacian
  {
    five_point,
    nine_point
  };
  enum class Precision
  {
    double_precision,
    single_precision
  };
  struct Growth
  {
    double anisotropy = 0.05;
    double capillary_length = 0.185;           // d0
    double relaxation_time = 1.;               // tau0
    std::optional<double> kinetic_coefficient; // empty: kinetics-free
    Laplacian laplacian = Laplacian::nine_point;
    Precision precision = Precision::double_precision;
    double step_fraction = 0.8; // of the explicit limit
    std::optional<double> step; // explicit growth step instead
    bool tiles = true;
    Place place;
  };
  struct Heat
  {
    double diffusivity = 3.;
    double undercooling = 0.55;
    std::optional<Expression> initial;
    Place place;
  };
  struct Orientation
  {
    double angle_degrees = 0.;
    bool turning = true;
    Place place;
  };
  struct Noise
  {
    double strength = 0.;
    std::uint64_t seed = 1;
    bool mirrored = false;
    bool on_heat_only = true;
    Place place;
  };
  /// Imposed motion instead of a solid: velocity of x, y, t over the whole domain.
  struct Imposed
  {
    VectorExpression velocity;
    Place place;
  };
  enum class AdvectionScheme
  {
    cip,
    cip_hermite,
    weno5,
    upwind
  };
  struct Advection
  {
    AdvectionScheme scheme = AdvectionScheme::cip;
    double step_fraction = 0.2;
    int interval = 1;
    bool analytic_gradients = true;
    Place place;
  };
  enum class ExtensionMethod
  {
    closest_point,
    pde
  };
  struct Extension
  {
    ExtensionMethod method = ExtensionMethod::closest_point;
    double band = 12.;
    Place place;
  };
  enum class WallGrip
  {
    grip,
    slip
  };
  struct Wall
  {
    Edge side;
    double speed = 0.;  // inward
    double travel = 0.; // total inward travel at which the wall stops
    double start_distance =
        8.; // gap to phi = 0 at which it starts (in W0); negative: starts at time `start_time`
    std::optional<double> start_time;
    double ramp = 0.; // time over which the speed rises smoothly
    WallGrip grip = WallGrip::grip;
    Place place;
  };

  struct Scene
  {
    std::string file, title;
    std::string text;     // the TOML as merged and overridden, for provenance
    std::string hash;     // of `text`
    std::string accuracy; // "", "draft", "standard" or "fine"
    Units units = Units::si;
    Domain domain;
    Clock clock;
    std::vector<Body> bodies;
    std::vector<Support> supports;
    std::vector<Traction> tractions;
    std::vector<Probe> probes;
    std::vector<Wall> walls;
    std::optional<BodyForce> body_force;
    std::optional<Solid> solid;
    std::optional<Mpm> mpm;
    std::optional<Fe> fe;
    std::optional<PhaseField> phase_field;
    std::optional<Growth> growth;
    std::optional<Heat> heat;
    std::optional<Orientation> orientation;
    std::optional<Noise> noise;
    std::optional<Imposed> imposed;
    std::optional<Advection> advection;
    std::optional<Extension> extension;
  };
} // namespace scene
