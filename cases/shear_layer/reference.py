#!/usr/bin/env python3
"""Computes reference.csv: the doubly periodic shear layer by a Fourier pseudo-spectral method.

Vorticity form  w_t + u.grad w = nu lap w  on the unit square, n x n modes, 2/3 rule, the viscous
term by an integrating factor, Runge-Kutta 4. Independent of velum. Usage: reference.py [n]
"""
import sys

import numpy as np

STEEPNESS, DISTURBANCE, END = 80, 0.05, 1.0
POINTS = 32  # in each direction, at (k + 1/2) / 32, which are points of the grid for n >= 64


def solve(reynolds: float, n: int) -> tuple[np.ndarray, np.ndarray]:
    """Velocities u, v at t = END, [y][x], points at i / n."""
    at = np.arange(n) / n
    x, y = np.meshgrid(at, at)
    u = np.tanh(STEEPNESS * np.where(y <= 0.5, y - 0.25, 0.75 - y))
    v = DISTURBANCE * np.sin(2 * np.pi * (x + 0.25))
    k = 2 * np.pi * np.fft.fftfreq(n, 1 / n)
    kx, ky = 2 * np.pi * np.fft.rfftfreq(n, 1 / n)[None, :], k[:, None]
    k2 = kx**2 + ky**2
    inverse = np.divide(1, k2, out=np.zeros_like(k2), where=k2 > 0)
    kept = (abs(kx) < 2 * np.pi * n / 3) & (abs(ky) < 2 * np.pi * n / 3)
    w = kept * (1j * kx * np.fft.rfft2(v) - 1j * ky * np.fft.rfft2(u))

    def velocity(w):
        return np.fft.irfft2(1j * ky * inverse * w), np.fft.irfft2(-1j * kx * inverse * w)

    def rate(w):
        u, v = velocity(w)
        return kept * np.fft.rfft2(
            -u * np.fft.irfft2(1j * kx * w) - v * np.fft.irfft2(1j * ky * w))

    steps = int(np.ceil(END * 2.5 * n))
    dt = END / steps
    half = np.exp(-k2 * dt / 2 / reynolds)
    for _ in range(steps):
        a = rate(w)
        b = rate(half * (w + dt / 2 * a))
        c = rate(half * w + dt / 2 * b)
        d = rate(half * half * w + dt * half * c)
        w = half * half * w + dt / 6 * (half * half * a + 2 * half * (b + c) + d)
    return velocity(w)


def main() -> None:
    n = int(sys.argv[1]) if len(sys.argv) > 1 else 512
    print(f"# Doubly periodic shear layer, steepness {STEEPNESS}, disturbance {DISTURBANCE}, at "
          f"t = {END:g}.")
    print("# Problem: Minion & Brown, J. Comput. Phys. 138 (1997) 734; x moved by a quarter.")
    print(f"# Computed by reference.py {n}: Fourier pseudo-spectral, {n} x {n}, 2/3 rule, RK4.")
    print("reynolds,time,x,y,u,v")
    step = n // POINTS
    for reynolds in (1000, 10000):
        u, v = solve(reynolds, n)
        for j in range(step // 2, n, step):
            for i in range(step // 2, n, step):
                print(f"{reynolds},{END:g},{i / n:g},{j / n:g},{u[j, i]:.5f},{v[j, i]:.5f}")


if __name__ == "__main__":
    main()
