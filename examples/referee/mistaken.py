"""A simulator of collisions on a line with the usual mistakes: `carom referee` finds them.

    carom referee --scenes -o scenes.json
    python3 mistaken.py scenes.json > results.csv
    carom referee results.csv

1. Time goes on in steps; who overlaps collides, wherever the two are by then.
2. All contacts of a step are resolved from the velocities before it, so that a body in the middle is hit twice.
3. `MISTAKE = "energy"`: the collision keeps the share e of the energy; it should keep the share e of the closing speed.
   `MISTAKE = "damping"`: velocities are those of an elastic collision times e, so that momentum is lost.
"""

import json
import sys

STEPS = 2000
"""Steps of time for each scene."""

MISTAKE = sys.argv[2] if len(sys.argv) > 2 else "energy"


def number(text):
    above, _, below = text.partition("/")
    return float(above) / float(below) if below else float(above)


def after(m1, m2, v1, v2, e):
    """The velocities after a collision, wrongly."""
    if MISTAKE == "damping":
        total = m1 + m2
        return (e * ((m1 - m2) * v1 + 2 * m2 * v2) / total, e * ((m2 - m1) * v2 + 2 * m1 * v1) / total)
    closing = e**0.5 * (v1 - v2)
    common = (m1 * v1 + m2 * v2) / (m1 + m2)
    return (common - closing * m2 / (m1 + m2), common + closing * m1 / (m1 + m2))


def play(scene):
    mass, x, v, length = (list(map(number, scene[key])) for key in ("masses", "positions", "velocities", "lengths"))
    restitution = list(map(number, scene["restitution"]))
    walls = [scene["left_wall"], scene["right_wall"]]
    step = number(scene["until"]) / STEPS
    pairs = []
    for _ in range(STEPS):
        x = [a + b * step for a, b in zip(x, v)]
        new = list(v)
        for k in range(len(x) - 1):
            if x[k] + length[k] / 2 >= x[k + 1] - length[k + 1] / 2 and v[k] > v[k + 1]:
                new[k], new[k + 1] = after(mass[k], mass[k + 1], v[k], v[k + 1], restitution[k])
                pairs.append(f"{k + 1}-{k + 2}")
        if walls[0] and x[0] - length[0] / 2 <= number(walls[0]["position"]) and v[0] < 0:
            new[0] = -number(walls[0]["restitution"]) * v[0]
            pairs.append("0-1")
        if walls[1] and x[-1] + length[-1] / 2 >= number(walls[1]["position"]) and v[-1] > 0:
            new[-1] = -number(walls[1]["restitution"]) * v[-1]
            pairs.append(f"{len(x)}-{len(x) + 1}")
        v = new
    return map(repr, v), pairs[:200]


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        scenes = json.load(file)["scenes"]
    print("scene,velocities,collisions")
    for scene in scenes:
        velocities, pairs = play(scene)
        print(f"{scene['name']},{' '.join(velocities)},{' '.join(pairs)}")


if __name__ == "__main__":
    main()
