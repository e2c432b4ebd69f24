"""A careful simulator of collisions on a line, in doubles: judged by `carom referee`.

    carom referee --scenes -o scenes.json
    python3 careful.py scenes.json > results.csv
    carom referee results.csv

From one collision to the next: the earliest meeting of two approaching neighbours comes first. Bodies that touch and
approach collide at once. Where restitution 0 lets the same bodies collide again and again at one instant, they share
the velocity of their centre of mass.
"""

import json
import sys

ROUNDS = 20_000
"""Collisions after which a scene is given up."""

NARROW = 1e-13
"""Gaps below this part of the scene's size are contacts: doubles tell no more."""

SLOW = 1e-15
"""Speeds of approach below this part of the largest speed are none."""


def number(text):
    above, _, below = text.partition("/")
    return float(above) / float(below) if below else float(above)


class Line:
    """Bodies and walls as points: rods are shifted together until only their contacts count."""

    def __init__(self, scene):
        bodies = zip(*(map(number, scene[key]) for key in ("masses", "positions", "velocities", "lengths")))
        self.mass, self.place, self.speed, self.shift = [], [], [], []
        offset = 0.0
        for mass, position, velocity, length in bodies:
            self.shift.append(offset + length / 2)
            self.mass.append(mass)
            self.place.append(position - self.shift[-1])
            self.speed.append(velocity)
            offset += length
        self.restitution = [number(e) for e in scene["restitution"]]
        self.first = 1
        for side, wall in ((0, scene["left_wall"]), (-1, scene["right_wall"])):
            if wall is None:
                continue
            at = 0 if side == 0 else len(self.mass)
            self.mass.insert(at, None)
            self.place.insert(at, number(wall["position"]) - (0.0 if side == 0 else offset))
            self.speed.insert(at, 0.0)
            self.shift.insert(at, 0.0)
            self.restitution.insert(0 if side == 0 else len(self.restitution), number(wall["restitution"]))
            self.first -= side == 0
        self.size = max(1e-300, max(self.place) - min(self.place))
        self.fastest = max(abs(v) for v in self.speed)

    def due(self):
        """The pair that meets next, and in how much time."""
        soonest = None
        for pair in range(len(self.mass) - 1):
            closing = self.speed[pair] - self.speed[pair + 1]
            if closing <= SLOW * self.fastest:
                continue
            gap = self.place[pair + 1] - self.place[pair]
            wait = 0.0 if gap <= NARROW * self.size else gap / closing
            if soonest is None or wait < soonest[1]:
                soonest = (pair, wait)
        return soonest

    def move(self, time):
        self.place = [x + v * time for x, v in zip(self.place, self.speed)]

    def collide(self, pair):
        """Momentum is kept, and the closing speed turns round, e times as large: by differences, which lose no digits."""
        left, right = self.mass[pair], self.mass[pair + 1]
        impulse = (1 + self.restitution[pair]) * (self.speed[pair] - self.speed[pair + 1])
        if left is None:
            self.speed[pair + 1] += impulse
        elif right is None:
            self.speed[pair] -= impulse
        else:
            self.speed[pair] -= impulse * right / (left + right)
            self.speed[pair + 1] += impulse * left / (left + right)
        middle = self.place[pair] if left is None else self.place[pair + 1]
        self.place[pair] = self.place[pair + 1] = middle

    def stick(self, pairs):
        """The bodies of these pairs have collided many times in no time: they move on together."""
        first, last = min(pairs), max(pairs) + 1
        masses, speeds = self.mass[first : last + 1], self.speed[first : last + 1]
        common = 0.0 if None in masses else sum(m * v for m, v in zip(masses, speeds)) / sum(masses)
        for point in range(first, last + 1):
            if self.mass[point] is not None:
                self.speed[point] = common


def play(scene):
    line, until = Line(scene), number(scene["until"])
    now, pairs, times, instant = 0.0, [], [], []
    for _ in range(ROUNDS):
        found = line.due()
        if found is None or now + found[1] > until:
            break
        pair, wait = found
        if wait > 1e-9 * until:
            instant = []
        instant.append(pair)
        line.move(wait)
        now += wait
        line.collide(pair)
        pairs.append(f"{pair + line.first}-{pair + line.first + 1}")
        times.append(repr(now))
        if len(instant) > 200:
            line.stick(instant)
            instant = []
    line.move(until - now)
    bodies = [k for k, mass in enumerate(line.mass) if mass is not None]
    velocities = [repr(line.speed[k]) for k in bodies]
    positions = [repr(line.place[k] + line.shift[k]) for k in bodies]
    return velocities, positions, pairs[:200], times[:200]


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        scenes = json.load(file)["scenes"]
    print("scene,velocities,positions,collisions,times")
    for scene in scenes:
        print(",".join([scene["name"], *(" ".join(part) for part in play(scene))]))


if __name__ == "__main__":
    main()
