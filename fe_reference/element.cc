#include "element.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

namespace fe
{
  namespace
  {
    template <int nodes, int points, int modes>
    struct Element
    {
      static constexpr int unknowns = 2 * nodes;
      using Gradients = Eigen::Matrix<double, nodes, 2>;

      std::array<Gradients, points> gradient; // in the current position
      std::array<Matrix2, points> F;
      std::array<double, points> J, dilated, pressure; // J, Jt, pt
      std::array<LawResult, points> law;

      double deform(const ElementTables &tables, const double *displacement);
      bool dilate(const ElementTables &tables);
      void stress(const Material &, const ElementTables &, const ElementRequest &);
      void forces(const ElementTables &, double *force) const;
      void tangent(const ElementTables &, double *matrix) const;

      double mode(const ElementTables &tables, const int q, const int m) const
      {
        return tables.mode[q * modes + m];
      }
      // Values at the points, projected onto the modes.
      std::array<double, points> project(const ElementTables &tables,
                                         const std::array<double, points> &value) const
      {
        std::array<double, points> result{};
        for (int m = 0; m < modes; ++m)
        {
          double coefficient = 0.;
          for (int q = 0; q < points; ++q)
            coefficient += tables.weight[q] * mode(tables, q, m) * value[q];
          for (int q = 0; q < points; ++q)
            result[q] += coefficient * mode(tables, q, m);
        }
        return result;
      }
    };

    template <int nodes, int points, int modes>
    double Element<nodes, points, modes>::deform(const ElementTables &tables,
                                                 const double *displacement)
    {
      double smallest = HUGE_VAL;
      for (int q = 0; q < points; ++q)
      {
        const Eigen::Map<const Eigen::Matrix<double, nodes, 2, Eigen::RowMajor>> reference(
            tables.gradient + q * nodes * 2),
            u(displacement);
        F[q] = Matrix2::Identity() + u.transpose().lazyProduct(reference);
        J[q] = F[q].determinant();
        smallest = std::min(smallest, J[q]);
        if (J[q] > 0.)
          gradient[q] = reference.lazyProduct(F[q].inverse());
      }
      return smallest;
    }

    template <int nodes, int points, int modes>
    bool Element<nodes, points, modes>::dilate(const ElementTables &tables)
    {
      dilated = project(tables, J);
      return *std::min_element(dilated.begin(), dilated.end()) > 0.;
    }

    template <int nodes, int points, int modes>
    void Element<nodes, points, modes>::stress(const Material &material,
                                               const ElementTables &tables,
                                               const ElementRequest &request)
    {
      std::array<double, points> p;
      for (int q = 0; q < points; ++q)
      {
        const PointState &old = request.old[q];
        PointState &now = request.now[q];
        now.F = std::sqrt(dilated[q] / J[q]) * F[q];
        law[q] = update_stress(material, old.stress, now.F * old.F.inverse(), request.dt);
        now.stress = law[q].stress;
        now.plastic_strain = old.plastic_strain + law[q].plastic_increment;
        now.plastic_work =
            old.plastic_work + law[q].plastic_increment * von_mises(now.stress) * dilated[q];
        p[q] = 0.5 * (now.stress[xx] + now.stress[yy]);
      }
      pressure = project(tables, p);
    }

    // Jt dev(sigma) + J pt 1 as its difference, mean and shear.
    struct Kirchhoff
    {
      double xx, yy, xy;
    };
    Kirchhoff kirchhoff(const Vector4 &stress, const double dilated, const double J,
                        const double pressure)
    {
      const double difference = 0.5 * dilated * (stress[fe::xx] - stress[fe::yy]);
      return {J * pressure + difference, J * pressure - difference, dilated * stress[fe::xy]};
    }

    template <int nodes, int points, int modes>
    void Element<nodes, points, modes>::forces(const ElementTables &tables, double *force) const
    {
      std::fill(force, force + unknowns, 0.);
      for (int q = 0; q < points; ++q)
      {
        const Kirchhoff T = kirchhoff(law[q].stress, dilated[q], J[q], pressure[q]);
        for (int a = 0; a < nodes; ++a)
        {
          const double gx = tables.weight[q] * gradient[q](a, 0),
                       gy = tables.weight[q] * gradient[q](a, 1);
          force[2 * a] += T.xx * gx + T.xy * gy;
          force[2 * a + 1] += T.xy * gx + T.yy * gy;
        }
      }
    }

    // Derivatives of one point's stress measure, times its weight w.
    struct PointTangent
    {
      Eigen::Matrix<double, 3, 4> C; // d(Jt dev sigma + J pt 1)/dl at fixed Jt, pt: xx, yy, xy
      Kirchhoff T;                   // the measure itself
      Vector4 pressure;              // dp/dl at fixed Jt
      double pressure_dilated;       // dp/dJt
      double difference, shear;      // d(Jt dev sigma)/dJt: xx = -yy, xy
    };

    PointTangent differentiate(const LawResult &law, const double dilated, const double J,
                               const double pressure, const double w)
    {
      // dl of the law = in-plane deviator of l + (dJt/Jt) 1/2.
      const Matrix4 &D = law.derivative;
      Matrix4 dl = D;
      dl.col(0) = 0.5 * (D.col(0) - D.col(3));
      dl.col(3) = -dl.col(0);
      const Vector4 dJ = (0.5 / dilated) * (D.col(0) + D.col(3));

      PointTangent t;
      const double spherical = w * J * pressure;
      const Eigen::RowVector4d unit(1., 0., 0., 1.);
      const Eigen::RowVector4d difference = 0.5 * w * dilated * (dl.row(xx) - dl.row(yy));
      t.C.row(0) = difference + spherical * unit;
      t.C.row(1) = -difference + spherical * unit;
      t.C.row(2) = w * dilated * dl.row(xy);
      t.T = kirchhoff(law.stress, dilated, J, pressure);
      t.T.xx *= w, t.T.yy *= w, t.T.xy *= w;
      t.pressure = 0.5 * w * (dl.row(xx) + dl.row(yy)).transpose();
      t.pressure_dilated = 0.5 * w * (dJ[xx] + dJ[yy]);
      t.difference =
          w * (0.5 * (law.stress[xx] - law.stress[yy]) + 0.5 * dilated * (dJ[xx] - dJ[yy]));
      t.shear = w * (law.stress[xy] + dilated * dJ[xy]);
      return t;
    }

    // grad N_a . C : (e_m grad N_j) and the geometric stiffness, all j and m in one sweep.
    template <int nodes>
    void add_local(const PointTangent &t, const Eigen::Matrix<double, nodes, 2> &g, double *K)
    {
      constexpr int unknowns = 2 * nodes;
      alignas(64) double x_x[unknowns], x_y[unknowns], y_x[unknowns], y_y[unknowns];
      for (int j = 0; j < nodes; ++j)
      {
        const double gx = g(j, 0), gy = g(j, 1);
        const double tx = t.T.xx * gx + t.T.xy * gy, ty = t.T.xy * gx + t.T.yy * gy;
        for (int m = 0; m < 2; ++m)
        {
          const double vx = t.C(0, 2 * m) * gx + t.C(0, 2 * m + 1) * gy,
                       vy = t.C(1, 2 * m) * gx + t.C(1, 2 * m + 1) * gy,
                       vs = t.C(2, 2 * m) * gx + t.C(2, 2 * m + 1) * gy;
          const int k = 2 * j + m;
          x_x[k] = vx - (m == 0 ? tx : 0.);
          x_y[k] = vs - (m == 1 ? tx : 0.);
          y_x[k] = vs - (m == 0 ? ty : 0.);
          y_y[k] = vy - (m == 1 ? ty : 0.);
        }
      }
      for (int a = 0; a < nodes; ++a)
      {
        double *first = K + 2 * a * unknowns, *second = first + unknowns;
        for (int k = 0; k < unknowns; ++k)
        {
          first[k] += g(a, 0) * x_x[k] + g(a, 1) * x_y[k];
          second[k] += g(a, 0) * y_x[k] + g(a, 1) * y_y[k];
        }
      }
    }

    // The share of the projections: with b = dJt, c = dforce/dJt, e = dpt at fixed Jt (one row a
    // mode) and h = dpt/dJt, the tangent gains c' b + b' (e + h b).
    template <int unknowns, int modes>
    struct Projection
    {
      using Rows = Eigen::Matrix<double, modes, unknowns, Eigen::RowMajor>;
      Rows b = Rows::Zero(), c = Rows::Zero(), e = Rows::Zero();
      Eigen::Matrix<double, modes, modes> h = Eigen::Matrix<double, modes, modes>::Zero();

      void gather(const PointTangent &t, const double *mode, const double wJ,
                  const Eigen::Matrix<double, unknowns / 2, 2> &g)
      {
        for (int m = 0; m < modes; ++m)
        {
          for (int a = 0; a < unknowns / 2; ++a)
          {
            const double gx = mode[m] * g(a, 0), gy = mode[m] * g(a, 1);
            b(m, 2 * a) += wJ * gx;
            b(m, 2 * a + 1) += wJ * gy;
            c(m, 2 * a) += t.difference * gx + t.shear * gy;
            c(m, 2 * a + 1) += t.shear * gx - t.difference * gy;
            e(m, 2 * a) += t.pressure[0] * gx + t.pressure[1] * gy;
            e(m, 2 * a + 1) += t.pressure[2] * gx + t.pressure[3] * gy;
          }
          for (int n = 0; n < modes; ++n)
            h(m, n) += mode[m] * mode[n] * t.pressure_dilated;
        }
      }

      void add_to(double *K)
      {
        e += h.lazyProduct(b);
        for (int i = 0; i < unknowns; ++i)
          for (int m = 0; m < modes; ++m)
            for (int k = 0; k < unknowns; ++k)
              K[i * unknowns + k] += c(m, i) * b(m, k) + b(m, i) * e(m, k);
      }
    };

    template <int nodes, int points, int modes>
    void Element<nodes, points, modes>::tangent(const ElementTables &tables, double *matrix) const
    {
      std::fill(matrix, matrix + unknowns * unknowns, 0.);
      Projection<unknowns, modes> projection;
      for (int q = 0; q < points; ++q)
      {
        const PointTangent t =
            differentiate(law[q], dilated[q], J[q], pressure[q], tables.weight[q]);
        add_local<nodes>(t, gradient[q], matrix);
        projection.gather(t, tables.mode + q * modes, tables.weight[q] * J[q], gradient[q]);
      }
      projection.add_to(matrix);
    }

    template <int nodes, int points, int modes>
    double evaluate(const Material &material, const ElementTables &tables,
                    const ElementRequest &request)
    {
      Element<nodes, points, modes> element;
      const double smallest = element.deform(tables, request.displacement);
      if (!(smallest > 0.))
        return std::isnan(smallest) ? -1. : smallest;
      if (!element.dilate(tables))
        return -1.;
      element.stress(material, tables, request);
      element.forces(tables, request.force);
      if (request.tangent)
        element.tangent(tables, request.tangent);
      return smallest;
    }
  } // namespace

  double evaluate_element(const int degree, const Material &material, const ElementTables &tables,
                          const ElementRequest &request)
  {
    return degree == 1 ? evaluate<4, 4, 1>(material, tables, request)
                       : evaluate<9, 9, 3>(material, tables, request);
  }
} // namespace fe
