"""A contact, its impacts and its force."""

import copy
import json
import pickle
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import plm_impact as plm
import pytest
from conftest import ROOT, STEEL, steel


def test_an_impact_has_the_results_of_the_summary(contact: plm.Contact) -> None:
    impact = contact.impact("3 m/s", samples=400)
    outcome = plm.run(ROOT / "scenarios" / "steel-on-steel.toml")
    results = impact.to_dict()
    assert results and all(outcome.summary[name] == value for name, value in results.items() if name != "warnings")
    assert impact.restitution == outcome.summary["restitution"]
    assert impact.energy["drift"] == outcome.summary["energy"]["drift"]
    assert np.array_equal(impact.trace, outcome.trace)
    assert impact._repr_png_() == outcome.pictures["force_indentation"] == outcome._repr_png_()
    assert {"restitution", "contact_time_s", "trace"} <= set(dir(impact))
    assert "restitution       0.4925" in repr(impact) and "345 MPa" in repr(contact)


def test_a_trace_comes_when_it_is_asked_for(contact: plm.Contact) -> None:
    assert len(contact.impact(0.5).trace) >= 400
    assert len(contact.impact(0.5, samples=50).trace) < 70


def test_restitutions_are_those_of_the_table(contact: plm.Contact) -> None:
    speeds = np.logspace(-4, 1.5, 5000)
    table = plm.impacts(contact, speed=speeds)
    assert contact.restitution(speeds).tobytes() == table["restitution"].tobytes()
    # an elastic impact has e = 1; e falls as v^(-1/4) if the contact is fully plastic
    assert table["restitution"][0] == 1.0
    assert contact.restitution(3.0) == contact.restitution("3 m/s") == contact.restitution([3])[0]
    assert contact.restitution(speeds.reshape(50, 100)[::2, ::-1]).shape == (25, 100)
    damped = steel(damping=dict(viscous=0.05))
    assert damped.restitution(speeds).tobytes() == plm.impacts(damped, speed=speeds)["restitution"].tobytes()


def test_the_speed_may_be_part_of_the_contact() -> None:
    assert steel(impact=dict(speed=2)).impact().restitution == steel().impact(2).restitution
    falling = steel(impact=dict(drop_height="0.1 m"), gravity=dict(acceleration=9.81))
    assert falling.impact().restitution < 1
    with pytest.raises(ValueError, match=r"\[impact\] is missing"):
        steel().impact()


# the laws for which an impact at 1 m/s has a trace without jumps
@pytest.mark.parametrize("law", ["plm", "thornton", "johnson", "stronge", "yigit_christoforou"])
def test_the_force_along_a_trace_is_that_of_the_trace(law: str) -> None:
    contact = steel(law={law: {}})
    trace = contact.impact(1.0, samples=200).trace
    memory = None
    for row in trace:
        force, memory = contact.force([row["indentation_m"]], memory)
        assert abs(force[0] - row["force_N"]) <= 1e-10 * trace["force_N"].max()
    assert memory[0, 0] == trace["indentation_m"].max()


def test_a_memory_is_handed_in_and_out(contact: plm.Contact) -> None:
    deepest = np.geomspace(1e-9, 3e-5, 10_000)
    force, memory = contact.force(deepest)
    assert force.shape == (10_000,) and memory.shape == (10_000, 3)
    assert np.array_equal(memory[:, 0], deepest) and np.array_equal(memory[:, 1], force)
    # below the largest indentation the memory does not change
    for share in (0.0, 0.5, 0.9, 1.0):
        less, same = contact.force(share * deepest, memory)
        assert same.tobytes() == memory.tobytes() and np.all(less <= force * (1 + 1e-15))
    again, _ = contact.force(2 * deepest, memory)
    fresh, _ = contact.force(2 * deepest, np.zeros((10_000, 3)))
    assert again.tobytes() == fresh.tobytes()
    # a memory with few digits, as from a text file, is still valid
    contact.force(deepest, np.array([[float(f"{part:.8g}") for part in row] for row in memory]))
    # an elastic contact has no memory
    elastic = plm.Contact(sphere=dict(radius="5 mm", density=7850, **STEEL), half_space=STEEL)
    assert not elastic.force(deepest)[1].any()


@pytest.mark.parametrize(
    ("indentation", "memory", "error", "text"),
    [
        ([1e-6], [[1.0, 1.0, 1.0]], ValueError, "contact 0: the memory .* is none of this contact"),
        ([1e-6], [[1e-6, np.nan, 0.0]], ValueError, "none of this contact"),
        ([1e-6], np.zeros((2, 3)), ValueError, r"shape \[2, 3\], expected \[1, 3\]"),
        ([1e-6], np.zeros(3), ValueError, r"shape \[3\]"),
        ([1e-6, np.inf], None, ValueError, "contact 1: an indentation of inf"),
        (["1 um"], None, TypeError, "indentation: found the type"),
    ],
)
def test_a_bad_memory_is_refused(contact, indentation, memory, error, text) -> None:
    with pytest.raises(error, match=text):
        contact.force(indentation, memory)


def test_a_contact_travels_to_other_processes(contact: plm.Contact, tmp_path: Path) -> None:
    for other in (pickle.loads(pickle.dumps(contact)), copy.deepcopy(contact)):
        assert repr(other) == repr(contact) and other.restitution(3.0) == contact.restitution(3.0)
    for refused in (contact.impact(0.1), plm.impacts(contact, speed=[1.0])):
        with pytest.raises(TypeError, match="cannot pickle"):
            pickle.dumps(refused)


def test_threads_share_a_contact(contact: plm.Contact) -> None:
    speeds = np.logspace(-3, 1, 20_000)
    alone = contact.restitution(speeds)
    with ThreadPoolExecutor(8) as threads:
        for together in threads.map(lambda _: contact.restitution(speeds), range(32)):
            assert together.tobytes() == alone.tobytes()


def test_the_keys_of_a_contact_have_the_sentences_of_the_command() -> None:
    with pytest.raises(ValueError, match='unknown unit "mmm" in "5 mmm", did you mean "mm"'):
        plm.Contact(sphere=dict(radius="5 mmm"), half_space={})
    with pytest.raises(ValueError, match="impact.speed: -1 m/s is not allowed: a speed must be > 0 m/s"):
        steel().impact(-1)
    with pytest.raises(ValueError, match="did you mean `half_space`"):
        plm.Contact(sphere={}, halfspace={})
    with pytest.raises(ValueError, match="tables of one impact"):
        steel(sweep={"impact.speed": [1.0, 2.0]})


class Quantity(float):
    units = "cm"


@pytest.mark.parametrize(
    "radius",
    [None, object(), [], {}, True, "rigid", "", "\0", "5 mm\n[impact]", 1j, b"5 mm", float("nan"), 10**30, Quantity(5)],
)
def test_hostile_values_are_refused_without_a_panic(radius: object) -> None:
    with pytest.raises((ValueError, TypeError)):
        plm.Contact(sphere=dict(radius=radius, density=7850, **STEEL), half_space=STEEL)


def test_hostile_tables_are_refused_without_a_panic() -> None:
    endless: dict[str, object] = {}
    endless["law"] = endless
    for tables in (endless, {"a\n[b]": 1}, {'"': {'"': "'''"}}, {"": {"": ""}}, {1: 2}, {"sphere": {"\ud800": 1}}, {"sphere": {"radius": "\ud800"}}):
        with pytest.raises((ValueError, TypeError)):
            plm.run(tables)
    with pytest.raises(ValueError, match="cannot be read"):
        plm.run("no-such-file.toml")
    for samples in (0, 1, 10**7, -1, 2**70):
        with pytest.raises((ValueError, OverflowError)):
            steel().impact(1.0, samples=samples)
