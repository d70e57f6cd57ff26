"""Writes a noisy dome on a grid of 150 x 100 nodes as a table, for `make demo`.

    python3 tools/make_dome.py > dome.csv

Height exp(-2 r^2), r from the middle of the unit square, with normal errors of 0.002. Its level
exp(-2 0.3^2) = 0.835270211 is a circle of radius 0.3.
"""

import math

NX, NY, ERROR, SEED = 150, 100, 0.002, 11
MASK = 2**64 - 1


def uniforms(state):
    """splitmix64 [SteeleLeaFlood2014]."""
    while True:
        state = (state + 0x9E3779B97F4A7C15) & MASK
        z = state
        z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & MASK
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & MASK
        yield (((z ^ (z >> 31)) >> 11) + 0.5) * 2.0**-53


def main():
    uniform = uniforms(SEED)

    def height(x, y):
        noise = math.sqrt(-2 * math.log(next(uniform))) * math.cos(2 * math.pi * next(uniform))
        return math.exp(-2 * ((x - 0.5) ** 2 + (y - 0.5) ** 2)) + ERROR * noise

    y = [j / (NY - 1) for j in range(NY)]
    print("x\\y," + ",".join(f"{v:.6f}" for v in y))
    for i in range(NX):
        x = i / (NX - 1)
        print(f"{x:.6f}," + ",".join(f"{height(x, v):.5f}" for v in y))


main()
