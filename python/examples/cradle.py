"""Imperfect balls on a line, struck as in Newton's cradle and replayed exactly; they do not swing back."""

import carom

BALL = """
[[body]]
mass = "0.0663"
position = {position}
velocity = {velocity}
"""
scene = 'title = "Balls on a line"\nrestitution = "0.985"\n' + "".join(
    BALL.format(position=k, velocity=1 if k == 0 else 0) for k in range(4)
)

replay = carom.replay(scene)
print(replay)
for collision in replay:
    print(collision.pair, "at", float(collision.time) if not isinstance(collision.time, str) else collision.time)
assert sum(v for v in replay.velocities if not isinstance(v, str)) == 1
replay.svg().save("cradle.svg")
