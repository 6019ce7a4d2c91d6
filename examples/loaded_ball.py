"""A loaded ball on a table, from its Lagrangian: a Python file that the command line takes.

    chaplygin show examples/loaded_ball.py
    chaplygin study examples/loaded_ball.py --set start.omega=[0,0,4]

The frame is that of the rigid motions in body axes; place and heading are of no account, so that
only the vertical γ is left of the configuration.
"""

from chaplygin import Frame, Integral, Mechanism, Parameter
from flowlanes.system import Diagonal, Vector, cross, dot, norm_squared, real_symbol, unit_vector
from nonholonomic.mechanics.lagrangian import euclidean

gamma, omega, v, r = (Vector(name) for name in ("gamma", "omega", "v", "r"))
I = Diagonal("I")
m, g, R, c = (real_symbol(name) for name in ["m", "g", "R", "c"])

frame = Frame(
    rates={gamma: cross(gamma, omega)},
    velocities=(omega, v),
    relations=(norm_squared(gamma) - 1,),
    structure=euclidean(omega, v),
)

mechanism = Mechanism(
    name="loaded-ball",
    title="Loaded ball",
    summary="A ball whose centre of mass lies off its centre rolls on a table without slipping.",
    frame=frame,
    definitions={r: c * unit_vector(3) - R * gamma},
    lagrangian=m * norm_squared(v) / 2 + dot(omega, I * omega) / 2 + m * g * dot(r, gamma),
    constraints=(v + cross(omega, r),),
    parameters=(
        Parameter(m, "mass", 1.0, "kg"),
        Parameter(g, "gravity", 9.81, "m/s^2"),
        Parameter(R, "radius", 0.1, "m"),
        Parameter(c, "centre of the ball above the centre of mass", 0.02, "m"),
        *(
            Parameter(I.symbols[i], "principal moment of inertia", moment, "kg m^2")
            for i, moment in enumerate((0.004, 0.004, 0.003))
        ),
    ),
    laws=(
        # claimed, to be proved or refuted: it holds where the first two moments are equal
        Integral(
            "jellett",
            dot(I * omega, r) + m * dot(cross(r, cross(omega, r)), r),
            "Jellett's integral",
            level=(I.symbols[0] - I.symbols[1],),
        ),
    ),
)

start = {"gamma": [0.0, 0.6, 0.8], "omega": [0.0, 0.0, 20.0]}
run = {"until": 2.0, "samples": 401}
