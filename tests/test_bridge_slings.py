"""A load on slings below the spreader of a container bridge: both frequencies against eigenvalues by numpy of energies that mpmath
takes from the loop of the ropes as it stands, and what starts leave against the linear motion, step by step."""

import math
import re

import mpmath as mp
import numpy as np
import pytest
from fmpy import simulate_fmu
from scipy.linalg import expm

from conftest import lemnis, typst, words
from test_bridge import A_C, G, LOAD, ROPES, SPREADER, V_C, starts, written

LENGTH = 18.0
SLINGS = {"l_s": 6.0, "e_s": 0.8, "e_1": 0.3, "i_1": 2.0}
KINDS = {
    "trapezoid": {},
    "parallel": {"a_u": 2.4},
    "turned": {"a_u": 2.9, "b_u": 2.0},
}


def matrices(ropes):
    """Mass, stiffness, what the trolley's acceleration does, and the load's travel, over the turn of the spreader (its travel
    where the ropes are parallel) and the angle of the slings."""
    mp.mp.dps = 40
    own = ROPES | ropes
    a_o, a_u, aside = mp.mpf(own["a_o"]), mp.mpf(own["a_u"]), mp.mpf(own["b_o"]) - mp.mpf(own["b_u"])
    parallel = a_o == a_u

    def middle(by):
        """Place and turn of the spreader: of the ropes' joints, which keep both lengths."""
        if parallel:
            return by, -mp.sqrt(LENGTH**2 - aside**2 - by**2), mp.mpf(0)
        def lengths(x, y):
            ends = [(x + side * a_u * mp.cos(by) - side * a_o, y + side * a_u * mp.sin(by)) for side in (-1, 1)]
            return [u * u + v * v + aside**2 - LENGTH**2 for u, v in ends]
        high = -mp.sqrt(LENGTH**2 - (a_o - a_u) ** 2 - aside**2)
        x, y = mp.findroot(lengths, (-by * high * a_u / (a_u - a_o), high))
        return x, y, by

    def point(by, below):
        x, y, turn = middle(by)
        return x + below * mp.sin(turn), y - below * mp.cos(turn)

    e_1, e_s, l_s, i_1 = (mp.mpf(SLINGS[name]) for name in ("e_1", "e_s", "l_s", "i_1"))
    along = [mp.diff(lambda by: point(by, below)[0], 0) for below in (e_1, e_s)]
    rise = [mp.diff(lambda by: point(by, below)[1], 0, 2) for below in (e_1, e_s)]
    turn = mp.diff(lambda by: middle(by)[2], 0)
    m_1, m_2 = SPREADER, LOAD
    mass = [[m_1 * (along[0] ** 2 + (i_1 * turn) ** 2) + m_2 * along[1] ** 2, m_2 * along[1] * l_s], [m_2 * along[1] * l_s, m_2 * l_s**2]]
    stiff = [[G * (m_1 * rise[0] + m_2 * rise[1]), 0], [0, m_2 * G * l_s]]
    push = [-(m_1 * along[0] + m_2 * along[1]), -m_2 * l_s]
    return tuple(np.array(each, dtype=float) for each in (mass, stiff, push, [along[1], l_s]))


def slung(folder, name, ropes):
    more = "\n[trolley.slings]\n" + "".join(f'{key} = "{value} m"\n' for key, value in SLINGS.items())
    return written(folder, name, static=True, ropes=ropes, more=more)


@pytest.mark.parametrize("kind", KINDS)
def test_both_frequencies(tmp_path, kind):
    paths = slung(tmp_path, f"Slung{kind}", KINDS[kind])
    mass, stiff, *_ = matrices(KINDS[kind])
    wanted = np.sqrt(np.sort(np.linalg.eigvals(np.linalg.solve(mass, stiff))))
    for path in paths.values():
        found = simulate_fmu(path, stop_time=0.1, output=["omega_s1", "omega_s2", "T_s1", "T_s2"])[-1]
        for i, value in enumerate(wanted, 1):
            assert found[f"omega_s{i}"] == pytest.approx(value, rel=1e-12)
            assert found[f"T_s{i}"] == pytest.approx(2 * math.pi / value, rel=1e-12)


def test_a_heavy_spreader_is_one_pendulum_and_a_light_one_another(tmp_path):
    """As the load goes to nothing and to infinity: √(g/l) and √(g/l_s); √(g/(l + l_s))."""
    paths = slung(tmp_path, "Slunglimits", KINDS["parallel"])
    light = simulate_fmu(paths["FMI 3"], stop_time=0.1, start_values={"Q": 1e-3}, output=["omega_s1", "omega_s2"])[-1]
    assert [light["omega_s1"], light["omega_s2"]] == pytest.approx([math.sqrt(G / LENGTH), math.sqrt(G / SLINGS["l_s"])], rel=1e-6)
    heavy = simulate_fmu(paths["FMI 3"], stop_time=0.1, start_values={"Q": 1e15}, output=["omega_s1"])[-1]
    assert heavy["omega_s1"] == pytest.approx(math.sqrt(G / (LENGTH + SLINGS["l_s"])), rel=1e-6)


def against_both(periods):
    """A quarter of the plain start at once, half of either period late, and half of both: as steps (time, acceleration)."""
    jumps = [(late + other + time, jump / 4) for late in (0.0, periods[0] / 2) for other in (0.0, periods[1] / 2)
             for time, jump in ((0.0, A_C), (V_C / A_C, -A_C))]
    jumps.sort()
    return [(time, sum(jump for _, jump in jumps[:i + 1])) for i, (time, _) in enumerate(jumps)]


@pytest.mark.parametrize("language", ["en", "bg"])
def test_what_starts_leave_at_both(tmp_path, language):
    """The book's table against the linear motion by the exponential of its matrix, in the modes at the end."""
    slung(tmp_path, "Slungstarts", {})
    lemnis("book", tmp_path / "Slungstarts.toml", "--language", language, "--format", "typ", "--output", tmp_path)
    book = typst(tmp_path / "Slungstarts.typ")
    known = words(language)
    assert known["assumption"]["bridge_slung"].split("[")[0] in book
    table = book[book.index(known["table"]["bridge_slings"]):]
    rows = re.findall(r"^ *((?:\[[^\]]*\],\s*){5})$", table, re.M)[:5]
    cells = [[float(cell.replace(",", ".").replace("−", "-").replace(" · 10", "e").translate(str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")))
              for cell in re.findall(r"\[([^\]]*)\]", row)] for row in rows]
    assert [row[0] for row in cells] == [1, 2, 3, 4, 6]
    mass, stiff, push, travel = matrices({})
    square, modes = np.linalg.eig(np.linalg.solve(mass, stiff))
    order = np.argsort(square)
    omega, modes = np.sqrt(square[order]), modes[:, order]
    system = np.zeros((5, 5))
    system[:2, 2:4], system[2:4, :2], system[2:4, 4] = np.eye(2), -np.linalg.solve(mass, stiff), np.linalg.solve(mass, push)
    periods = 2 * math.pi / omega
    for made, columns in ((0, (1, 2)), (1, (3, 4))):
        for number, accelerated in [*enumerate(starts(periods[made])), (4, against_both(periods))]:
            state, time, rate = np.zeros(4), 0.0, 0.0
            for begin, value in accelerated:
                state = (expm(system * (begin - time)) @ [*state, rate])[:4]
                time, rate = begin, value
            assert abs(rate) < 1e-12
            place, speed = np.linalg.solve(modes, state[:2]), np.linalg.solve(modes, state[2:])
            left = np.hypot(place, speed / omega) * np.abs(travel @ modes)
            for column, value in zip(columns, left):
                assert cells[number][column] == pytest.approx(value, rel=2e-3, abs=2e-6), (made, number, column)
