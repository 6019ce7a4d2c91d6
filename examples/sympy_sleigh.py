"""A sleigh as SymPy has it, taken in: a Python file that the command line takes.

    chaplygin show examples/sympy_sleigh.py
    chaplygin find integrals examples/sympy_sleigh.py

The blade under the point P keeps the sleigh from slipping sideways; the centre of mass lies ahead
of P.  `LagrangesMethod` gets the constraint as what it is, nonholonomic.
"""

from sympy import symbols
from sympy.physics.mechanics import (
    LagrangesMethod,
    Lagrangian,
    Point,
    ReferenceFrame,
    RigidBody,
    dynamicsymbols,
    inertia,
)

from nonholonomic import mechanism_from_sympy

x, y, phi = dynamicsymbols("x y phi")
m, I, a = symbols("m I a", positive=True)

ground = ReferenceFrame("N")
blade = ground.orientnew("B", "Axis", [phi, ground.z])
origin, P = Point("O"), Point("P")
origin.set_vel(ground, 0)
P.set_pos(origin, x * ground.x + y * ground.y)
P.set_vel(ground, P.pos_from(origin).dt(ground))
centre = P.locatenew("C", a * blade.x)
centre.v2pt_theory(P, ground, blade)
body = RigidBody("sleigh", centre, blade, m, (inertia(blade, 0, 0, I), centre))

method = LagrangesMethod(
    Lagrangian(ground, body), [x, y, phi], nonhol_coneqs=[P.vel(ground).dot(blade.y)]
)
mechanism = mechanism_from_sympy(
    method, {"m": 1.0, "I": 0.5, "a": 0.3}, name="sympy-sleigh", title="Sleigh, by SymPy"
)
start = {"phi": 0.0, "xdot": 1.0, "ydot": 0.0, "phidot": 0.5, "x": 0.0, "y": 0.0}
run = {"until": 10.0, "samples": 201}
