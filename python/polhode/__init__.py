"""Rotation schemes for rigid bodies, to see, compare and understand.

SI units throughout. A suffix names the frame: W the world's, B the body's (origin in its centre of mass, axes
along its principal axes). Quaternions are w, x, y, z, and q_WB turns coordinates of B into those of W: v_W =
q_WB v_B.

    import polhode
    print(polhode.compare("dzhanibekov"))
"""

from . import rotations, torque_laws
from ._comparison import Comparison, Series, compare, contenders
from ._core import Motion, State, Torque
from ._core import version as __version__
from ._motion import Trajectory, free_motion
from ._scenario import Scenario, scenarios
from ._scheme import Scheme, register_scheme, scheme, schemes
from ._work_precision import Curve, WorkPrecision, work_precision

__all__ = [
    "Comparison",
    "Curve",
    "Motion",
    "Scenario",
    "Scheme",
    "Series",
    "State",
    "Torque",
    "Trajectory",
    "WorkPrecision",
    "__version__",
    "compare",
    "contenders",
    "free_motion",
    "register_scheme",
    "rotations",
    "scenarios",
    "scheme",
    "schemes",
    "torque_laws",
    "work_precision",
]
