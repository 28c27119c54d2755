#!/usr/bin/env python3
"""Sharp-interface growth of a disc, a third implementation: heat on both sides of a moving circle, on meshes that follow it.

Temperature of the interface -d0/R, speed D times the jump of the slope (unit latent heat, equal diffusivities), melt at -Delta. Explicit
second-order differences in r/R inside and (r - R)/(L - R) outside. Started, as the scene is, from Frank's similarity solution at R = 20 with the
solid at theta = 0. Without d0 the solution is Frank's R = sqrt(4 lambda^2 D t), lambda^2 exp(lambda^2) E1(lambda^2) = Delta, which is checked
first. Writes reference.csv: time, radius.
"""
from math import exp, log, sqrt
from pathlib import Path

import numpy as np

DELTA, D, R0, L, END = 0.25, 3.0, 20.0, 160.0, 200.0
INSIDE, OUTSIDE = 200, 1400


def exponential_integral(x):
    """E1(x) by its series below 1.5, by its continued fraction above."""
    if x < 1.5:
        total, term = -0.5772156649015329 - log(x), 1.0
        for k in range(1, 60):
            term *= -x / k
            total -= term / k
        return total
    fraction = 0.0
    for k in range(300, 0, -1):
        fraction = k / (1 + k / (x + fraction))
    return exp(-x) / (x + fraction)


def growth_constant():
    low, high = 1e-9, 20.0
    for _ in range(200):
        middle = 0.5 * (low + high)
        if middle * exp(middle) * exponential_integral(middle) < DELTA:
            low = middle
        else:
            high = middle
    return low


def differences(value, spacing):
    """First and second derivative at the inner nodes."""
    return (value[2:] - value[:-2]) / (2 * spacing), (value[2:] - 2 * value[1:-1] + value[:-2]) / spacing**2


def radii(capillary_length, rows):
    square = growth_constant()
    start = R0**2 / (4 * square * D)
    inside, outside = np.linspace(0, 1, INSIDE + 1), np.linspace(0, 1, OUTSIDE + 1)
    solid = np.zeros(INSIDE + 1)
    scale = exponential_integral(square)
    melt = np.array([DELTA * (exponential_integral((R0 + (L - R0) * s)**2 / (4 * D * start)) / scale - 1) for s in outside])
    R, time, table = R0, 0.0, [(0.0, R0)]
    while len(table) <= rows:
        due = END * len(table) / rows
        h_solid, h_melt = R / INSIDE, (L - R) / OUTSIDE
        dt = min(0.2 * min(h_solid, h_melt)**2 / D, due - time)
        solid[-1] = melt[0] = -capillary_length / R
        slope_solid = (3 * solid[-1] - 4 * solid[-2] + solid[-3]) / (2 * h_solid)
        slope_melt = (-3 * melt[0] + 4 * melt[1] - melt[2]) / (2 * h_melt)
        speed = D * (slope_solid - slope_melt)
        first, second = differences(solid, h_solid)
        s = inside[1:-1]
        rate_solid = D * (second + first / (R * s)) + speed * s * first
        first, second = differences(melt, h_melt)
        s = outside[1:-1]
        rate_melt = D * (second + first / (R + (L - R) * s)) + speed * (1 - s) * first
        centre = 4 * D * (solid[1] - solid[0]) / h_solid**2
        solid[1:-1] += dt * rate_solid
        solid[0] += dt * centre
        melt[1:-1] += dt * rate_melt
        melt[-1] = melt[-2]
        R += dt * speed
        time += dt
        if time >= due - 1e-12 * END:
            table.append((due, R))
    return table


def main():
    square = growth_constant()
    end = radii(0.0, 1)[-1][1]
    exact = sqrt(R0**2 + 4 * square * D * END)
    print(f"lambda^2 = {square:.10f}; without d0: R(end) = {end:.6f}, Frank {exact:.6f}")
    assert abs(end / exact - 1) < 1e-4
    lines = [f"{time:g},{radius:.6f}" for time, radius in radii(0.185, 40)]
    text = "# sharp-interface disc with theta = -d0/R: reference.py\ntime,radius\n" + "\n".join(lines) + "\n"
    (Path(__file__).parent / "reference.csv").write_text(text)


if __name__ == "__main__":
    main()
