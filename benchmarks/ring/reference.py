#!/usr/bin/python3
"""Thick ring under internal pressure in plane strain, elastic-perfectly plastic: one-dimensional reference, free of solver code.

Small strains, axial symmetry: the unknown is u(r) alone, eps_rr = u', eps_theta = u/r, eps_zz = 0. Linear elements in r with one integration
point each (the mean of u/r is exact enough there and nothing locks), rate-independent J2 by radial return with the consistent tangent, Newton
in every load step. Neither solver knows this problem is one-dimensional.

    reference.py            writes radial.csv (profiles at two pressures) and pressure.csv (displacements against pressure)
"""
from pathlib import Path

import numpy as np

YOUNG, POISSON, YIELD = 2.1e11, 0.3, 2.4e8
INNER, OUTER, ELEMENTS = 0.1, 0.2, 800
BULK = YOUNG / (3 * (1 - 2 * POISSON))
SHEAR = YOUNG / (2 * (1 + POISSON))
UNIT = np.array([1.0, 1.0, 1.0])
PROJECTOR = np.eye(3) - np.outer(UNIT, UNIT) / 3


def return_to_yield(strain, plastic):
    """Stress, new plastic strain and tangent of all elements; normal components r, theta, z (no shear in axial symmetry)."""
    elastic = strain - plastic
    mean = elastic.sum(axis=1) / 3
    deviator = 2 * SHEAR * (elastic - mean[:, None])
    q = np.sqrt(1.5 * (deviator**2).sum(axis=1))
    flowing = q > YIELD
    shrink = np.where(flowing, YIELD / np.maximum(q, 1e-30), 1.0)
    stress = shrink[:, None] * deviator + 3 * BULK * mean[:, None]
    new_plastic = plastic + (1 - shrink)[:, None] * deviator / (2 * SHEAR)
    direction = deviator / np.sqrt(np.maximum((deviator**2).sum(axis=1), 1e-30))[:, None]
    tangent = BULK * np.outer(UNIT, UNIT) + 2 * SHEAR * shrink[:, None, None] * (
        PROJECTOR - np.where(flowing, 1.0, 0.0)[:, None, None] * direction[:, :, None] * direction[:, None, :])
    return stress, new_plastic, tangent


def solve(pressures):
    """March through `pressures`; yields (pressure, u at the nodes, radii of elements, stresses, plastic strains)."""
    r = np.linspace(INNER, OUTER, ELEMENTS + 1)
    middle, length = 0.5 * (r[1:] + r[:-1]), np.diff(r)
    B = np.zeros((ELEMENTS, 3, 2))
    B[:, 0, 0], B[:, 0, 1] = -1 / length, 1 / length
    B[:, 1, :] = 0.5 / middle[:, None]
    weight = middle * length  # per radian
    u, plastic = np.zeros(ELEMENTS + 1), np.zeros((ELEMENTS, 3))
    for pressure in pressures:
        for _ in range(50):
            strain = np.einsum("eij,ej->ei", B, np.stack([u[:-1], u[1:]], axis=1))
            stress, new_plastic, tangent = return_to_yield(strain, plastic)
            force = np.einsum("eij,ei,e->ej", B, stress, weight)
            residual = np.zeros(ELEMENTS + 1)
            np.add.at(residual, np.arange(ELEMENTS), force[:, 0])
            np.add.at(residual, np.arange(1, ELEMENTS + 1), force[:, 1])
            residual[0] -= pressure * INNER
            if np.abs(residual).max() < 1e-10 * YIELD * INNER:
                break
            K = np.einsum("eki,ekl,elj,e->eij", B, tangent, B, weight)
            diagonal, upper, lower = np.zeros(ELEMENTS + 1), K[:, 0, 1].copy(), K[:, 1, 0].copy()
            diagonal[:-1] += K[:, 0, 0]
            diagonal[1:] += K[:, 1, 1]
            u = u - tridiagonal(lower, diagonal, upper, residual)
        else:
            raise RuntimeError(f"no equilibrium at {pressure}")
        plastic = new_plastic
        yield pressure, u.copy(), middle, stress, plastic


def tridiagonal(lower, diagonal, upper, right):
    """Thomas algorithm."""
    d, x = diagonal.copy(), right.copy()
    for i in range(1, len(d)):
        factor = lower[i - 1] / d[i - 1]
        d[i] -= factor * upper[i - 1]
        x[i] -= factor * x[i - 1]
    x[-1] /= d[-1]
    for i in range(len(d) - 2, -1, -1):
        x[i] = (x[i] - upper[i] * x[i + 1]) / d[i]
    return x


def main():
    folder = Path(__file__).parent
    steps = [0.005 * k * YIELD for k in range(1, 161)]  # the last just below the limit, 0.80038
    with open(folder / "pressure.csv", "w") as curve, open(folder / "radial.csv", "w") as profile:
        curve.write("# written by reference.py: p/sigma_Y, u/r at the inner and outer edge\npressure,inner,outer\n0,0,0\n")
        profile.write("# written by reference.py: profiles at p = 0.65 sigma_Y, in sigma_Y; r in m\nr,radial,hoop,axial,von_mises\n")
        for k, (pressure, u, r, present, _) in enumerate(solve(steps), 1):
            curve.write(f"{pressure / YIELD:.6g},{u[0] / INNER:.8e},{u[-1] / OUTER:.8e}\n")
            if k == 130:
                stress = present
        q = np.sqrt(1.5 * ((stress - stress.mean(axis=1)[:, None]) ** 2).sum(axis=1))
        for k in range(4, ELEMENTS, 8):
            profile.write(f"{r[k]:.6g}," + ",".join(f"{s / YIELD:.7g}" for s in stress[k]) + f",{q[k] / YIELD:.7g}\n")


if __name__ == "__main__":
    main()
