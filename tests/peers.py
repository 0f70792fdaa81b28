"""MuJoCo and Exudyn on one mechanism: one line for each setting, `what; error in rad; seconds per simulated second`.

    python tests/peers.py

`cargo bench --workspace --bench goals -- motion` puts them beside Lemnis. Both come from PyPI, into an environment of
their own (target/peers). The mechanism: lemniscate crane with boom 20 t, jib 6 t, rocker 4 t and a load
of 16 t on a rope of 10 m, under 1.8 MN·m for 5 s from rest at 65 deg, rope at 0.1 rad. Reference
theta_1(5 s) = 1.95936582871882998 rad, phi(5 s) = 0.510282010345209914 rad.

Each runs its most favourable settings out of those listed; time is that of its compiled loop,
the best of several rounds, without start-up and without Python between steps.
"""

import math
import subprocess
import sys
import time
import venv
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
ENVIRONMENT = ROOT / "target" / "peers"
PINNED = ["mujoco==4.0.0", "exudyn==1.13.6", "numpy==2.4.6"]

THETA, PHI = 1.95936582871882998, 0.510282010345209914
X1, X2, X3, X4, X5, X6, X7 = 19.3, 6.5, 14.7, 16.0, 6.4, 5.3, 1.354
G, TORQUE, ROPE, LOAD, END = 9.81, 1.8e6, 10.0, 16e3, 5.0
BETA_0 = math.acos(X7 / X2) + math.acos(X7 / X4)


def start():
    """Points O1, B, C, A and the load at the start."""
    t = math.radians(65)
    b = (X1 * math.cos(t), X1 * math.sin(t))
    line = (b[0] + X5, b[1] - X6)
    d = math.hypot(*line)
    along = (d * d + X3 * X3 - X2 * X2) / (2 * d)
    across = math.sqrt(X3 * X3 - along * along)
    u = (line[0] / d, line[1] / d)
    c = (-X5 + along * u[0] - across * u[1], X6 + along * u[1] + across * u[0])
    be = math.atan2(c[1] - b[1], c[0] - b[0]) - BETA_0
    a = (b[0] + X4 * math.cos(be), b[1] + X4 * math.sin(be))
    load = (a[0] + ROPE * math.sin(0.1), a[1] - ROPE * math.cos(0.1))
    return (0.0, 0.0), b, c, a, load


def error(theta, phi):
    return max(abs(theta - THETA), abs(abs(phi) - PHI))


def bar(name, p, q, mass):
    """Centre, angle and inertia of a uniform bar."""
    return (p[0] + q[0]) / 2, (p[1] + q[1]) / 2, mass * math.dist(p, q) ** 2 / 12


def mujoco_rows():
    import mujoco

    o, b, c, a, load = start()
    o3 = (-X5, X6)

    def body(name, parent_at, at, centre, mass, inertia, inner=""):
        x, z = at[0] - parent_at[0], at[1] - parent_at[1]
        cx, cz = centre[0] - at[0], centre[1] - at[1]
        return (
            f'<body name="{name}" pos="{x!r} 0 {z!r}"><joint name="{name}" type="hinge" axis="0 -1 0"/>'
            f'<inertial pos="{cx!r} 0 {cz!r}" mass="{mass!r}" diaginertia="{max(inertia, 1e-9)!r} {max(inertia, 1e-9)!r} {max(inertia, 1e-9)!r}"/>'
            f"{inner}</body>"
        )

    jx, jz, ji = bar("jib", c, a, 6e3)
    bx, bz, bi = bar("boom", o, b, 20e3)
    rx, rz, ri = bar("rocker", o3, c, 4e3)
    rope = body("rope", b, a, load, LOAD, 1e-6)
    jib = body("jib", o, b, (jx, jz), 6e3, ji, rope)
    boom = body("boom", (0.0, 0.0), o, (bx, bz), 20e3, bi, jib)
    rocker = body("rocker", (0.0, 0.0), o3, (rx, rz), 4e3, ri)
    rows = []
    for integrator, h in [("RK4", 2e-2), ("RK4", 1e-2), ("RK4", 5e-3), ("RK4", 2.5e-3), ("RK4", 1e-3), ("implicitfast", 1e-4)]:
        xml = f"""<mujoco><option gravity="0 0 -{G}" timestep="{h}" integrator="{integrator}" solver="Newton"
            iterations="50" tolerance="1e-14"/><worldbody>{boom}{rocker}</worldbody>
            <equality><connect body1="jib" body2="rocker" anchor="{c[0] - b[0]!r} 0 {c[1] - b[1]!r}"
            solref="{2 * h} 1" solimp="0.9999 0.9999 0.001 0.5 2"/></equality></mujoco>"""
        model = mujoco.MjModel.from_xml_string(xml)
        data = mujoco.MjData(model)
        steps = round(END / h)
        best, at = math.inf, 0.0
        for _ in range(3):
            mujoco.mj_resetData(model, data)
            data.qfrc_applied[model.joint("boom").dofadr[0]] = TORQUE
            clock = time.perf_counter()
            mujoco.mj_step(model, data, nstep=steps)
            best = min(best, time.perf_counter() - clock)
            q = {n: data.qpos[model.joint(n).qposadr[0]] for n in ("boom", "jib", "rope")}
            at = error(math.radians(65) + q["boom"], 0.1 + q["boom"] + q["jib"] + q["rope"])
        rows.append((f"MuJoCo {mujoco.__version__} {integrator}, h = {h:g} s", at, best / END))
    return rows


def exudyn_rows():
    import exudyn as exu
    import numpy as np
    from exudyn.utilities import (
        LoadForceVector,
        LoadTorqueVector,
        MarkerBodyPosition,
        MarkerBodyRigid,
        NodeRigidBody2D,
        ObjectGround,
        ObjectJointRevolute2D,
        ObjectRigidBody2D,
        SensorBody,
    )

    o, b, c, a, load = start()
    o3 = (-X5, X6)
    rows = []

    def solve(steps):
        container = exu.SystemContainer()
        mbs = container.AddSystem()
        ground = mbs.AddObject(ObjectGround())

        def rigid(p, q, mass, at=None):
            centre = at or ((p[0] + q[0]) / 2, (p[1] + q[1]) / 2)
            inertia = 0.0 if at else mass * math.dist(p, q) ** 2 / 12
            node = mbs.AddNode(NodeRigidBody2D(referenceCoordinates=[centre[0], centre[1], 0.0]))
            number = mbs.AddObject(ObjectRigidBody2D(nodeNumber=node, mass=mass, inertia=max(inertia, 1e-9)))
            force = mbs.AddMarker(MarkerBodyPosition(bodyNumber=number, localPosition=[0, 0, 0]))
            mbs.AddLoad(LoadForceVector(markerNumber=force, loadVector=[0, -mass * G, 0]))
            return number, centre

        def joint(p, first, second):
            markers = []
            for number, centre in (first, second):
                local = [p[0] - centre[0], p[1] - centre[1], 0]
                markers.append(mbs.AddMarker(MarkerBodyPosition(bodyNumber=number, localPosition=local)))
            mbs.AddObject(ObjectJointRevolute2D(markerNumbers=markers))

        world = (ground, (0.0, 0.0))
        boom, rocker = rigid(o, b, 20e3), rigid(o3, c, 4e3)
        jib, rope = rigid(c, a, 6e3), rigid(a, load, LOAD, load)
        joint(o, world, boom)
        joint(o3, world, rocker)
        joint(b, boom, jib)
        joint(c, jib, rocker)
        joint(a, jib, rope)
        turn = mbs.AddMarker(MarkerBodyRigid(bodyNumber=boom[0], localPosition=[0, 0, 0]))
        mbs.AddLoad(LoadTorqueVector(markerNumber=turn, loadVector=[0, 0, TORQUE]))
        mbs.Assemble()
        settings = exu.SimulationSettings()
        settings.timeIntegration.numberOfSteps = steps
        settings.timeIntegration.endTime = END
        settings.timeIntegration.generalizedAlpha.spectralRadius = 1.0
        settings.timeIntegration.generalizedAlpha.useIndex2Constraints = True
        settings.timeIntegration.generalizedAlpha.useNewmark = True
        settings.timeIntegration.newton.useModifiedNewton = True
        settings.timeIntegration.verboseMode = 0
        settings.solution.file.write = False
        settings.solution.sensors.writePeriod = END
        settings.show.computationTime = False
        clock = time.perf_counter()
        mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.TrapezoidalIndex2)
        seconds = time.perf_counter() - clock
        turned = [mbs.GetObjectOutputBody(n, exu.OutputVariableType.Rotation, [0, 0, 0]) for n in (boom[0], rope[0])]
        turned = [float(np.asarray(x).reshape(-1)[-1]) for x in turned]
        at = error(math.radians(65) + turned[0], 0.1 + turned[1])
        return seconds, at

    for steps in (250, 500, 1000, 1250, 2000, 5000):
        seconds, at = min(solve(steps) for _ in range(3))
        rows.append((f"Exudyn {exu.__version__} trapezoidal index 2, h = {END / steps:g} s", at, seconds / END))
    return rows


def prepare():
    """The environment's Python, with both installed; else leaves with what is to be done."""
    if sys.version_info < (3, 10):
        sys.exit(f"Python 3.10 or later is needed, this is {sys.version.split()[0]}")
    python = ENVIRONMENT / ("Scripts/python.exe" if sys.platform == "win32" else "bin/python")
    if not python.exists():
        try:
            venv.create(ENVIRONMENT, with_pip=True)
        except (subprocess.CalledProcessError, ImportError):
            sys.exit("Python cannot make a virtual environment: install python3-venv")
    install = [str(python), "-m", "pip", "install", "-q", "--disable-pip-version-check", *PINNED]
    done = subprocess.run(install, capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{done.stderr}PyPI is needed once, for {', '.join(PINNED)}: {' '.join(install)}")
    return python


def main():
    python = prepare()
    for name in ("mujoco", "exudyn"):
        found = subprocess.run([python, __file__, name], capture_output=True, text=True)
        if found.returncode:
            sys.exit(found.stderr)
        print("".join(line + "\n" for line in found.stdout.splitlines() if line.count(";") == 2), end="")


if __name__ == "__main__":
    if len(sys.argv) == 1:
        main()
    else:
        for what, at, seconds in mujoco_rows() if sys.argv[1] == "mujoco" else exudyn_rows():
            print(f"{what};{float(at)!r};{float(seconds)!r}")
