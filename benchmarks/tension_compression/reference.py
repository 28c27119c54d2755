#!/usr/bin/python3
"""0-D reference of a homogeneous strip with free sides in plane strain (sigma_xx = 0, eps_zz = 0), free of solver code.

Without rotation the Jaumann rate is the plain time derivative, so the law is a small system of ordinary differential equations in
the logarithmic strain:  d sigma/dt = C : (D - D_vp).  Perzyna: D_vp = {q - sigma_Y}/eta * 3/2 s/q, Eqs. (5), (6).
Rate-independent: D_vp = gamma * 3/2 s/q with gamma from consistency (dq/dt = 0 while loading).  D_xx is whatever keeps
sigma_xx at zero.  Integrated with the classical Runge-Kutta scheme at a fixed small step; neither solver works like this.

    reference.py            writes the CSV files of this case and of tension_rates
"""
import math
from pathlib import Path

YOUNG, POISSON, YIELD = 3e7, 0.3, 6e4
LAME = YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON))
SHEAR = YOUNG / (2 * (1 + POISSON))


def ramp(t, rise):
    """Integral of 6 s^5 - 15 s^4 + 10 s^3 with s = t/rise (then 1): the scene language's ramp(t, T)."""
    s = min(t / rise, 1.0)
    return rise * (s**6 - 3 * s**5 + 2.5 * s**4) + max(t - rise, 0.0)


def von_mises(yy, zz):
    return math.sqrt(yy * yy - yy * zz + zz * zz)


def stress_rate(yy, zz, rate, viscosity, yielding=False):
    """Rates of sigma_yy, sigma_zz and of the equivalent plastic strain at axial strain rate `rate`."""
    q = von_mises(yy, zz)
    mean = (yy + zz) / 3
    flow = [1.5 * s / q for s in (-mean, yy - mean, zz - mean)] if q > 0 else [0.0] * 3

    def elastic(gamma):
        # sigma_xx stays zero: (lambda + 2 mu) d_xx + lambda (d_yy + d_zz) = 0 for the elastic rates d.
        d_yy, d_zz = rate - gamma * flow[1], -gamma * flow[2]
        trace = 2 * SHEAR * (d_yy + d_zz) / (LAME + 2 * SHEAR)
        return LAME * trace + 2 * SHEAR * d_yy, LAME * trace + 2 * SHEAR * d_zz

    def q_rate(gamma):
        return sum(n * r for n, r in zip(flow[1:], elastic(gamma)))

    gamma = 0.0
    if viscosity is not None:
        gamma = max(q - YIELD, 0.0) / viscosity
    elif yielding:
        gamma = q_rate(0.0) / (q_rate(0.0) - q_rate(1.0))  # dq/dt is linear in gamma
    return *elastic(gamma), gamma


def loads(yy, zz, rate):
    """Whether the elastic rate leads out of the yield surface."""
    d_yy, d_zz, _ = stress_rate(yy, zz, rate, None)
    mean = (d_yy + d_zz) / 3
    return yy * (d_yy - mean) + zz * (d_zz - mean) > 0


def integrate(strain_of, end, steps, viscosity, samples):
    """Rows (time, strain, stress_yy, stress_zz, von_mises, plastic_strain), `samples` + 1 of them."""
    yy = zz = plastic = 0.0
    h = end / steps
    rows = [(0.0, 0.0, 0.0, 0.0, 0.0, 0.0)]
    for n in range(steps):
        rate = (strain_of((n + 1) * h) - strain_of(n * h)) / h
        # Rate-independent: on the surface the step is plastic as a whole unless its rate leads back inside.
        yielding = viscosity is None and von_mises(yy, zz) >= YIELD * (1 - 1e-9) and loads(yy, zz, rate)
        law = (rate, viscosity, yielding)
        k1 = stress_rate(yy, zz, *law)
        k2 = stress_rate(yy + h / 2 * k1[0], zz + h / 2 * k1[1], *law)
        k3 = stress_rate(yy + h / 2 * k2[0], zz + h / 2 * k2[1], *law)
        k4 = stress_rate(yy + h * k3[0], zz + h * k3[1], *law)
        yy, zz, plastic = (v + h / 6 * (a + 2 * b + 2 * c + d)
                           for v, a, b, c, d in zip((yy, zz, plastic), k1, k2, k3, k4))
        q = von_mises(yy, zz)
        if yielding or (viscosity is None and q > YIELD):  # drift, and the overshoot of the step that reaches the surface
            yy, zz, q = yy * YIELD / q, zz * YIELD / q, YIELD
        if (n + 1) % (steps // samples) == 0:
            rows.append(((n + 1) * h, strain_of((n + 1) * h), yy, zz, q, plastic))
    return rows


def write(path, rows, about):
    with open(path, "w") as out:
        out.write(f"# {about}\n# written by benchmarks/tension_compression/reference.py\n")
        out.write("time,strain,stress_yy,stress_zz,von_mises,plastic_strain\n")
        for row in rows:
            out.write(",".join(f"{v:.9g}" for v in row) + "\n")


def main():
    here = Path(__file__).resolve().parent
    cycle = integrate(lambda t: 0.005 * math.sin(2 * math.pi * ramp(t, 2) / 10), 13.5, 400000, None, 400)
    write(here / "reference.csv", cycle, "strip, one cycle, rate-independent")
    for name, rate, end in (("1e-2", 1e-2, 2.175), ("5e-3", 5e-3, 4.175), ("1e-3", 1e-3, 20.175)):
        rows = integrate(lambda t, rate=rate: rate * ramp(t, 0.35), end, 200000, 3e6, 400)
        write(here.parent / "tension_rates" / f"reference_{name}.csv", rows, f"viscoplastic strip at {name} /s")


if __name__ == "__main__":
    main()
