"""The ready scenes of single booms in motion: their FMUs in FMPy, both standards and both interfaces."""

import numpy as np
import pytest
from fmpy import simulate_fmu
from fmpy.validation import validate_fmu

from conftest import ROOT
from single_boom import ENDS, G, packed

SCENES = {"rope_motion": ("RopeMotion", 12.0, 4.5e6), "ellipsograph_motion": ("EllipsographMotion", 15.0, 250e3),
          "curved_trunk_motion": ("CurvedTrunkMotion", 15.0, 250e3)}


@pytest.mark.parametrize("scene", SCENES)
def test_a_ready_scene_hoists_on_its_brake_and_luffs_without_it(scene, tmp_path):
    """Held by its brake the boom lets the load rise by the hoist's ramp: 0.25 m/s² up to 0.1 m/s, S_R = m (g + a). Without
    the brake all four runs raise the boom alike."""
    name, rope, moment = SCENES[scene]
    paths = packed(ROOT / f"models/scenes/{scene}.toml", name, tmp_path)
    luffed = []
    for standard in ENDS:
        assert not validate_fmu(paths[standard])
        for kind in ("CoSimulation", "ModelExchange"):
            run = lambda **told: simulate_fmu(
                paths[standard], fmi_type=kind, stop_time=5.0, output_interval=0.05, relative_tolerance=1e-9,
                record_events=False, output=["phi", "l_R", "S_R", "v_R"], **told)
            held = run()
            assert np.ptp(held["phi"]) == 0.0
            rising = (held["time"] > 0.06) & (held["time"] < 0.34)
            assert rising.sum() > 4 and np.allclose(held["S_R"][rising], 10e3 * (G + 0.25), rtol=1e-9)
            assert held["l_R"][-1] == pytest.approx(rope - (0.1 * 5.0 - 0.1 ** 2 / (2 * 0.25)), abs=1e-6)
            luffed.append(run(start_values={"M_A": moment, "M_S": 0.0, "v_h": 0.0})["phi"])
    assert np.ptp(luffed[0]) > 0.01
    for other in luffed[1:]:
        assert np.max(np.abs(other - luffed[0])) < 2e-5
