"""A motor controller as a functional mock-up unit by pythonfmu: PID, current limits and the lag of the current loops.

`examples/fmu_motor.py` builds it with `pythonfmu` and connects it to the arm's unit.
"""

import math

from pythonfmu import Fmi2Causality, Fmi2Slave, Fmi2Variability, Real

GOAL = (-0.4928, 0.6922, 0.4270)
GAINS = ((1500.0, 180.0, 3000.0), (1500.0, 180.0, 3000.0), (400.0, 40.0, 800.0))
"""N·m/rad, N·m·s/rad and N·m/(rad·s) of each joint."""


class MotorController(Fmi2Slave):
    """Three drives that follow minimum-jerk paths; gear and torque constant turn amperes into N·m."""

    author = ""
    description = "PID control of three joints through current loops"

    def __init__(self, **kwargs):
        super().__init__(**kwargs)
        self.duration, self.lag, self.constant, self.most = 1.2, 0.004, 12.0, 20.0
        for name in ("duration", "lag", "constant", "most"):
            self._real(name, Fmi2Causality.parameter, Fmi2Variability.tunable)
        self.sums = [0.0] * 3
        for k in range(3):
            for name, way in (("q", "input"), ("v", "input"), ("tau", "output"), ("current", "output")):
                setattr(self, f"{name}{k}", 0.0)
                self._real(f"{name}{k}", Fmi2Causality[way], Fmi2Variability.continuous)

    def _real(self, name, causality, variability):
        self.register_variable(Real(name, causality=causality, variability=variability))

    def do_step(self, current_time, step_size):
        x = min(current_time / self.duration, 1.0)
        place = x**3 * (10 - 15 * x + 6 * x * x)
        rate = 30 * (x * (1 - x)) ** 2 / self.duration
        for k, (goal, (kp, kd, ki)) in enumerate(zip(GOAL, GAINS, strict=True)):
            error = goal * place - getattr(self, f"q{k}")
            self.sums[k] += ki * error * step_size
            wanted = kp * error + kd * (goal * rate - getattr(self, f"v{k}")) + self.sums[k]
            command = max(-self.most, min(self.most, wanted / self.constant))
            current = getattr(self, f"current{k}")
            current += (1 - math.exp(-step_size / self.lag)) * (command - current)
            setattr(self, f"current{k}", current)
            setattr(self, f"tau{k}", self.constant * current)
        return True
